#include "solver/SolverData.h"

#include "base/Error.h"
#include "base/Format.h"
#include "kernels/particle/Amplitude.h"
#include "mesh/Quality.h"
#include "model/PartMaterial.h"
#include "solver/ModelSizes.h"
#include "solver/PatchTables.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

static_assert(int(RateDependence::cowperSymonds) == int(RateLaw::cowperSymonds)
              && int(RateDependence::johnsonCook) == int(RateLaw::logarithmic));

GeneralConstants<double> generalConstants(const Part& part)
{
    GeneralConstants<double> g{};
    g.rotation = RotationRule(int(part.rotation));
    g.erodes = part.erosion.any();
    g.erodesInverted = part.erosion.inverted;
    g.erosionStrain = part.erosion.plasticStrain > 0 ? part.erosion.plasticStrain : 1e30;
    const Flow& flow = part.flow;
    g.temperature = flow.temperature;
    if (!isPlastic(part.kind)) return g;
    g.kinematicModulus = flow.kinematicModulus;
    g.powerModulus = flow.powerModulus;
    g.powerExponent = flow.powerExponent;
    g.rateLaw = RateLaw(int(flow.rate));
    g.referenceRate = flow.referenceRate;
    g.rateCoefficient = flow.rateCoefficient;
    g.heatPerWork = flow.heatFraction > 0 ? flow.heatFraction / flow.specificHeat : 0;
    g.softeningExponent = flow.softeningExponent;
    g.roomTemperature = flow.roomTemperature;
    if (flow.softeningExponent > 0)
        g.inverseMeltingRange = 1 / (flow.meltingTemperature - flow.roomTemperature);
    return g;
}

} // namespace

MaterialConstants<double> materialConstants(const Part& part)
{
    MaterialConstants<double> m{};
    const double e = part.youngsModulus, nu = part.poissonsRatio;
    const double mu = e / (2 * (1 + nu));
    m.lambda = e * nu / ((1 + nu) * (1 - 2 * nu));
    m.twoMu = 2 * mu;
    m.threeMu = 3 * mu;
    m.pressureWaveModulus = m.lambda + 2 * mu;
    m.young = e;
    m.poisson = nu;
    m.linearViscosity = part.linearBulkViscosity;
    m.quadraticViscosity = part.quadraticBulkViscosity;
    m.hourglass = part.hourglassCoefficient;
    m.coupledHourglass = part.hourglass == HourglassForm::physical
                                 && part.hourglassPlastic == HourglassPlastic::coupled
                                 && isPlastic(part.kind)
                             ? 1
                             : 0;
    static_assert(mostHardeningRows <= std::size_t(maxHardeningRows));
    m.rows = int(part.hardening.size());
    for (int row = 0; row < m.rows; ++row) {
        const Hardening& here = part.hardening[std::size_t(row)];
        m.strain[row] = here.equivalentPlasticStrain;
        m.stress[row] = here.yieldStress;
        if (row + 1 < m.rows) {
            const Hardening& next = part.hardening[std::size_t(row) + 1];
            m.slope[row] = (next.yieldStress - here.yieldStress)
                           / (next.equivalentPlasticStrain - here.equivalentPlasticStrain);
        } else // the last slope continues
            m.slope[row] = row > 0 ? m.slope[row - 1] : 0;
    }
    m.general = generalConstants(part);
    if (!isRigid(part.kind)) materialOf(part.kind).constants(part.lawValues.data(), m);
    return m;
}

namespace {

static_assert(int(RotationForm::arcsine) == int(RotationRule::arcsine)
              && int(RotationForm::polar) == int(RotationRule::polar)
              && int(RotationForm::hughesWinget) == int(RotationRule::hughesWinget));

/// What the elements of a part keep from step to step.
StateLayout layoutOf(const Part& part, const MaterialConstants<double>& m, Precision precision)
{
    StateLayout layout{0, 0, false};
    if (isRigid(part.kind)) return layout;
    const bool floats =
        precision == Precision::double_ && part.hourglassStorage == HourglassStorage::float_;
    visitKernel(kernelOf(part), [&]<class Material, class Element>() {
        layout = stateLayout<Material, Element>(m, floats);
    });
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

void addPatches(SolverData& data, const Model& model, const Patches& patches)
{
    data.elementTile.resize(std::size_t(data.elementCount));
    data.elementPlace.resize(std::size_t(data.elementCount));
    data.elementPatch.resize(std::size_t(data.elementCount));
    for (std::size_t part = 0; part < model.parts.size(); ++part) {
        MaterialConstants<double>& m = data.materials[part];
        data.layouts.push_back(layoutOf(model.parts[part], m, model.control.precision));
        m.floatHourglass = data.layouts[part].floatHourglass;
    }
    for (Index element = 0; element < data.elementCount; ++element)
        if (!(volume(model.mesh, element) > 0))
            throw Error(ExitCode::mesh, format("element {} has no positive volume", element),
                        "its nodes are numbered inside out, or the mesh is damaged: run fpmMesh");
    Index tile = 0;
    PatchTables tables;
    for (const Patch& patch : patches.patches) {
        const Index stride = (patch.elementCount + tileWidth - 1) / tileWidth * tileWidth;
        PatchHeader& header = data.patches.emplace_back();
        header.elementCount = patch.elementCount;
        header.tile = tile;
        header.firstNode = patches.slotNode[std::size_t(patch.firstSlot)];
        header.nodeCount = patch.nodeCount;
        header.interiorCount = interiorCount(patches, patch);
        header.material = patch.part;
        header.state = data.stateSize;
        header.strains = data.strainCount;
        tables.add(data, header, patches, patch);
        const StateLayout& layout = data.layouts[std::size_t(patch.part)];
        data.stateSize += std::size_t(layout.size()) * std::size_t(stride);
        data.strainCount += std::size_t(layout.sums()) * std::size_t(stride);
        data.maxPatchNodes = std::max(data.maxPatchNodes, std::size_t(patch.nodeCount));
        data.elementMass.resize(std::size_t(tile + stride));
        const double density = model.parts[std::size_t(patch.part)].density;
        for (Index e = 0; e < stride; ++e) {
            // Places beyond the last element repeat it: harmless work, no branch in the kernel.
            const Index element = patch.firstElement + std::min(e, patch.elementCount - 1);
            data.elementMass[std::size_t(tile + e)] = density * volume(model.mesh, element);
            if (e >= patch.elementCount) continue;
            data.elementTile[std::size_t(element)] = std::size_t(tile);
            data.elementPlace[std::size_t(element)] = e;
            data.elementPatch[std::size_t(element)] = Index(data.patches.size()) - 1;
        }
        tile += stride;
    }
    data.paddedElements = tile;
}

/// Partial sums of force: one for every node of a patch that is not interior; those of a node in
/// the order of patches.
void addPartialSums(SolverData& data, const Patches& patches)
{
    std::vector<Index> sumOf(patches.slotNode.size(), -1);
    for (std::size_t number = 0; number < data.patches.size(); ++number) {
        PatchHeader& patch = data.patches[number];
        patch.firstPartialSum = data.partialSumCount;
        for (Index i = patch.interiorCount; i < patch.nodeCount; ++i) {
            const std::size_t slot = std::size_t(patches.patches[number].firstSlot + i);
            sumOf[slot] = data.partialSumCount++;
            data.boundaryNodes.push_back(patches.slotNode[slot]);
        }
    }
    data.partialSumsStart.assign(1, 0);
    data.firstBoundaryNode = data.nodeCount;
    for (Index node = 0; node < data.nodeCount; ++node) {
        const std::size_t before = data.partialSums.size();
        for (Index k = patches.nodeSlotStart[std::size_t(node)];
             k < patches.nodeSlotStart[std::size_t(node) + 1]; ++k) {
            const Index sum = sumOf[std::size_t(patches.nodeSlots[std::size_t(k)])];
            if (sum >= 0) data.partialSums.push_back(sum);
        }
        if (data.partialSums.size() > before)
            data.firstBoundaryNode = std::min(data.firstBoundaryNode, node);
        else
            data.interiorEnd = node + 1;
        if (node >= data.firstBoundaryNode)
            data.partialSumsStart.push_back(Index(data.partialSums.size()));
    }
}

void addGroups(SolverData& data, const Model& model)
{
    for (std::size_t i = 0; i < data.patches.size(); ++i) {
        const Part& part = model.parts[std::size_t(data.patches[i].material)];
        if (isRigid(part.kind)) {
            data.rigidParts = true;
            continue;
        }
        const ElementKernel kernel = kernelOf(part);
        const auto same = [&](const KernelGroup& group) { return group.kernel == kernel; };
        auto group = std::find_if(data.groups.begin(), data.groups.end(), same);
        if (group == data.groups.end()) group = data.groups.insert(group, {kernel, {}});
        group->patches.push_back(Index(i));
    }
}

void addMass(SolverData& data, const Model& model)
{
    data.nodeMass.assign(std::size_t(data.nodeCount), 0.0);
    data.ownNodeMass = data.nodeMass;
    for (Index element = 0; element < data.elementCount; ++element) {
        const double mass = data.massOf(element);
        const double own = model.parts[std::size_t(model.mesh.partOf(element))].density
                           * volume(model.mesh, element);
        for (const Index node : model.mesh.hexahedra[std::size_t(element)]) {
            data.nodeMass[std::size_t(node)] += mass / 8;
            data.ownNodeMass[std::size_t(node)] += own / 8;
        }
    }
}

/// Rest is sought from the end of the last amplitude and of the last overlap that fades.
void addRelaxation(SolverData& data, const Model& model)
{
    data.relaxation.tolerance = model.control.relaxationTolerance;
    double& held = data.relaxation.heldFrom;
    const auto wait = [&](const Condition& condition) {
        const Index last = condition.firstRow + condition.rowCount - 1;
        if (condition.rowCount > 1)
            held = std::max(held, data.amplitudeRows[2 * std::size_t(last)]);
    };
    for (const Condition& condition : data.conditions) wait(condition);
    for (const SurfaceShape& surface : data.surfaces)
        if (surface.moves) wait(surface.motion);
    for (const ContactPassSetup& pair : data.passes) held = std::max(held, pair.fadeTime);
}

} // namespace

void shareNodes(SolverData& data)
{
    std::vector<bool> interior(std::size_t(data.nodeCount), false);
    for (const KernelGroup& group : data.groups)
        for (const Index number : group.patches) {
            const PatchHeader& patch = data.patches[std::size_t(number)];
            for (Index i = 0; i < patch.interiorCount; ++i)
                interior[std::size_t(patch.firstNode + i)] = true;
        }
    data.listedNodes.clear();
    for (std::size_t node = 0; node < interior.size(); ++node) {
        std::uint8_t& fixed = data.fixed[node];
        fixed &= std::uint8_t(~listedNode);
        const auto has = [=](const std::vector<Index>& start) {
            return !start.empty() && start[node + 1] > start[node];
        };
        const auto numbered = [=](const std::vector<Index>& number) {
            return !number.empty() && number[node] >= 0;
        };
        const bool acted = fixed || has(data.conditionStart) || has(data.pressureStart)
                           || numbered(data.frameOf) || numbered(data.contactNumber);
        if ((interior[node] && !acted) || (fixed & bodyNode)) continue;
        fixed |= listedNode;
        data.listedNodes.push_back(Index(node));
    }
}

SolverData makeSolverData(const Model& model, bool audit)
{
    requirePlaces(sizesOf(model));
    SolverData data;
    data.nodeCount = Index(model.mesh.points.size());
    data.elementCount = Index(model.mesh.hexahedra.size());
    for (const Part& part : model.parts) {
        data.materials.push_back(materialConstants(part));
        data.erodes |= data.materials.back().general.erodes;
        data.heats |= data.materials.back().general.heatPerWork > 0;
    }
    const Patches patches = makePatches(model.mesh);
    addPatches(data, model, patches);
    addPartialSums(data, patches);
    addGroups(data, model);
    scaleMass(data, model);
    addMass(data, model);
    addMotion(data, model);
    if (!model.contactPairs.empty()) addContact(data, model);
    addRelaxation(data, model);
    addLoadedBodyNodes(data);
    // Works of all nodes and the sums of relaxation are blocks of all nodes in a row.
    data.sharesNodes = model.control.assembly == Assembly::patch && !audit
                       && !(model.control.massDamping > 0) && !(data.relaxation.tolerance > 0);
    if (data.sharesNodes) shareNodes(data);
    return data;
}

} // namespace fpm
