#include "base/Error.h"
#include "base/Format.h"
#include "mesh/Quality.h"
#include "solver/SetUp.h"
#include "solver/elements/PatchTables.h"

#include <algorithm>

namespace fpm {

namespace {

static_assert(int(RotationForm::arcsine) == int(RotationRule::arcsine)
              && int(RotationForm::polar) == int(RotationRule::polar)
              && int(RotationForm::hughesWinget) == int(RotationRule::hughesWinget));

/// What the elements of a part keep from step to step, as the kernel of its group has it.
StateLayout stateLayout(const Part& part, Precision precision)
{
    if (isRigid(part.kind)) return {0, 0, false};
    const bool plastic = part.kind == PartKind::elastoplastic;
    StateLayout layout{1, part.hourglass == HourglassForm::viscous ? 0 : 12,
                       plastic || part.erosion.any(), plastic && part.flow.kinematicModulus > 0,
                       plastic && part.flow.heatFraction > 0};
    if (part.hexahedron == HexahedronForm::selective) {
        layout.points = SelectiveIntegration::points;
        layout.hourglass = SelectiveIntegration::stateSize;
    }
    layout.floatHourglass = layout.hourglass > 0 && precision == Precision::double_
                            && part.hourglassStorage == HourglassStorage::float_;
    return layout;
}

/// Interior nodes as PatchHeader has them. renumber() numbers all of them in a row; one that is not
/// is like a node of several patches, with one of them.
Index interiorCount(const Patches& patches, const Patch& patch)
{
    const Index* node = patches.slotNode.data() + patch.firstSlot;
    Index count = 0;
    while (count < patch.interiorCount && node[count] == node[0] + count) ++count;
    return count;
}

void addPatches(SolverSetUp& data, const Model& model, const Patches& patches)
{
    data.elements.tileStart.resize(std::size_t(data.elements.count));
    data.elements.placeInPatch.resize(std::size_t(data.elements.count));
    data.elements.patchOf.resize(std::size_t(data.elements.count));
    for (std::size_t part = 0; part < model.parts.size(); ++part) {
        data.elements.layouts.push_back(stateLayout(model.parts[part], model.control.precision));
        data.elements.materials[part].floatHourglass = data.elements.layouts[part].floatHourglass;
    }
    for (Index element = 0; element < data.elements.count; ++element)
        if (!(volume(model.mesh, element) > 0))
            throw Error(ExitCode::mesh, format("element {} has no positive volume", element),
                        "its nodes are numbered inside out, or the mesh is damaged: run fpmMesh");
    Index tile = 0;
    PatchTables tables;
    for (const Patch& patch : patches.patches) {
        const Index stride = (patch.elementCount + tileWidth - 1) / tileWidth * tileWidth;
        PatchHeader& header = data.elements.patches.emplace_back();
        header.elementCount = patch.elementCount;
        header.tile = tile;
        header.firstNode = patches.slotNode[std::size_t(patch.firstSlot)];
        header.nodeCount = patch.nodeCount;
        header.interiorCount = interiorCount(patches, patch);
        header.material = patch.part;
        header.state = data.elements.stateSize;
        header.strains = data.elements.strainCount;
        tables.add(data, header, patches, patch);
        const StateLayout& layout = data.elements.layouts[std::size_t(patch.part)];
        data.elements.stateSize += std::size_t(layout.size()) * std::size_t(stride);
        data.elements.strainCount += std::size_t(layout.sums()) * std::size_t(stride);
        data.elements.maxPatchNodes =
            std::max(data.elements.maxPatchNodes, std::size_t(patch.nodeCount));
        data.elements.mass.resize(std::size_t(tile + stride));
        const double density = model.parts[std::size_t(patch.part)].density;
        for (Index e = 0; e < stride; ++e) {
            // Places beyond the last element repeat it: harmless work, no branch in the kernel.
            const Index element = patch.firstElement + std::min(e, patch.elementCount - 1);
            data.elements.mass[std::size_t(tile + e)] = density * volume(model.mesh, element);
            if (e >= patch.elementCount) continue;
            data.elements.tileStart[std::size_t(element)] = std::size_t(tile);
            data.elements.placeInPatch[std::size_t(element)] = e;
            data.elements.patchOf[std::size_t(element)] = Index(data.elements.patches.size()) - 1;
        }
        tile += stride;
    }
    data.elements.padded = tile;
}

/// Partial sums of force: one for every node of a patch that is not interior; those of a node in
/// the order of patches.
void addPartialSums(SolverSetUp& data, const Patches& patches)
{
    std::vector<Index> sumOf(patches.slotNode.size(), -1);
    for (std::size_t number = 0; number < data.elements.patches.size(); ++number) {
        PatchHeader& patch = data.elements.patches[number];
        patch.firstPartialSum = data.elements.partialSumCount;
        for (Index i = patch.interiorCount; i < patch.nodeCount; ++i) {
            const std::size_t slot = std::size_t(patches.patches[number].firstSlot + i);
            sumOf[slot] = data.elements.partialSumCount++;
            data.elements.boundaryNodes.push_back(patches.slotNode[slot]);
        }
    }
    data.nodes.partialSumsStart.assign(1, 0);
    data.nodes.firstBoundaryNode = data.nodes.count;
    for (Index node = 0; node < data.nodes.count; ++node) {
        const std::size_t before = data.nodes.partialSums.size();
        for (Index k = patches.nodeSlotStart[std::size_t(node)];
             k < patches.nodeSlotStart[std::size_t(node) + 1]; ++k) {
            const Index sum = sumOf[std::size_t(patches.nodeSlots[std::size_t(k)])];
            if (sum >= 0) data.nodes.partialSums.push_back(sum);
        }
        if (data.nodes.partialSums.size() > before)
            data.nodes.firstBoundaryNode = std::min(data.nodes.firstBoundaryNode, node);
        else
            data.nodes.interiorEnd = node + 1;
        if (node >= data.nodes.firstBoundaryNode)
            data.nodes.partialSumsStart.push_back(Index(data.nodes.partialSums.size()));
    }
}

void addGroups(SolverSetUp& data, const Model& model)
{
    for (std::size_t i = 0; i < data.elements.patches.size(); ++i) {
        const Part& part = model.parts[std::size_t(data.elements.patches[i].material)];
        if (isRigid(part.kind)) {
            data.elements.rigidParts = true;
            continue;
        }
        const bool general = needsGeneralPlasticity(part);
        const bool selective = part.hexahedron == HexahedronForm::selective;
        const auto same = [&](const KernelGroup& group) {
            return group.general == general && (general || group.kind == part.kind)
                   && group.hexahedron == part.hexahedron
                   && (selective || group.hourglass == part.hourglass);
        };
        auto group = std::find_if(data.elements.groups.begin(), data.elements.groups.end(), same);
        if (group == data.elements.groups.end())
            group = data.elements.groups.insert(
                group, {part.kind, general, part.hexahedron, part.hourglass, {}});
        group->patches.push_back(Index(i));
    }
}

void addMass(SolverSetUp& data, const Model& model)
{
    data.nodes.mass.assign(std::size_t(data.nodes.count), 0.0);
    data.nodes.ownMass = data.nodes.mass;
    for (Index element = 0; element < data.elements.count; ++element) {
        const double mass = data.elements.massOf(element);
        const double own = model.parts[std::size_t(model.mesh.partOf(element))].density
                           * volume(model.mesh, element);
        for (const Index node : model.mesh.hexahedra[std::size_t(element)]) {
            data.nodes.mass[std::size_t(node)] += mass / 8;
            data.nodes.ownMass[std::size_t(node)] += own / 8;
        }
    }
}

} // namespace

void addElements(SolverSetUp& data, const Model& model)
{
    data.elements.count = Index(model.mesh.hexahedra.size());
    for (const Part& part : model.parts) {
        data.elements.materials.push_back(materialConstants(part));
        data.elements.erodes |= data.elements.materials.back().general.erodes;
        data.elements.heats |= data.elements.materials.back().general.heatPerWork > 0;
    }
    const Patches patches = makePatches(model.mesh);
    addPatches(data, model, patches);
    addPartialSums(data, patches);
    addGroups(data, model);
    scaleMass(data, model);
    addMass(data, model);
}

} // namespace fpm
