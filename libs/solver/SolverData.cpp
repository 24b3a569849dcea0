#include "solver/SolverData.h"

#include "base/Error.h"
#include "base/Format.h"
#include "kernels/particle/Amplitude.h"
#include "mesh/Quality.h"

#include <algorithm>
#include <cmath>

namespace fpm {

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
    m.waveSpeed = std::sqrt(m.pressureWaveModulus / part.density);
    m.linearViscosity = part.linearBulkViscosity;
    m.quadraticViscosity = part.quadraticBulkViscosity;
    m.hourglass = part.hourglassCoefficient;
    m.coupledHourglass = part.hourglass == HourglassForm::physical
                                 && part.hourglassPlastic == HourglassPlastic::coupled
                                 && part.kind == PartKind::elastoplastic
                             ? 1
                             : 0;
    m.rows = int(std::min<std::size_t>(part.hardening.size(), maxHardeningRows));
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
    m.general.rotation = RotationRule(int(part.rotation));
    return m;
}

bool needsGeneralPlasticity(const Part& part)
{
    return part.rotation != RotationForm::midSurface;
}

namespace {

static_assert(int(RotationForm::arcsine) == int(RotationRule::arcsine)
              && int(RotationForm::polar) == int(RotationRule::polar)
              && int(RotationForm::hughesWinget) == int(RotationRule::hughesWinget));

/// What the elements of a part keep from step to step, as the kernel of its group has it.
StateLayout stateLayout(const Part& part)
{
    if (part.kind == PartKind::rigid) return {0, 0, false};
    return {1, part.hourglass == HourglassForm::viscous ? 0 : 12,
            part.kind == PartKind::elastoplastic};
}

void addPatches(SolverData& data, const Model& model, const Patches& patches)
{
    data.slotNode = patches.slotNode;
    data.slotCornerStart = patches.slotCornerStart;
    data.nodeSlotStart = patches.nodeSlotStart;
    data.nodeSlots = patches.nodeSlots;
    data.slotCount = Index(patches.slotNode.size());
    for (const std::uint16_t entry : patches.slotCorners)
        data.slotCorners.push_back(std::uint16_t((entry & 7) * patchCapacity + (entry >> 3)));
    data.elementTile.resize(std::size_t(data.elementCount));
    data.elementPlace.resize(std::size_t(data.elementCount));
    data.elementPatch.resize(std::size_t(data.elementCount));
    for (const Part& part : model.parts) data.layouts.push_back(stateLayout(part));
    for (Index element = 0; element < data.elementCount; ++element)
        if (!(volume(model.mesh, element) > 0))
            throw Error(ExitCode::mesh, format("element {} has no positive volume", element),
                        "its nodes are numbered inside out, or the mesh is damaged: run fpmMesh");
    Index tile = 0;
    for (const Patch& patch : patches.patches) {
        const Index stride = (patch.elementCount + 15) / 16 * 16;
        data.patches.push_back({patch.elementCount, stride, tile, patch.firstSlot, patch.nodeCount,
                                patch.part, data.stateSize, data.strainCount});
        const StateLayout& layout = data.layouts[std::size_t(patch.part)];
        data.stateSize += std::size_t(layout.size()) * std::size_t(stride);
        data.strainCount += std::size_t(layout.strains()) * std::size_t(stride);
        data.maxPatchNodes = std::max(data.maxPatchNodes, std::size_t(patch.nodeCount));
        data.corners.resize(8 * std::size_t(tile + stride));
        data.elementMass.resize(std::size_t(tile + stride));
        const double density = model.parts[std::size_t(patch.part)].density;
        for (Index e = 0; e < stride; ++e) {
            // Places beyond the last element repeat it: harmless work, no branch in the kernel.
            const Index element = patch.firstElement + std::min(e, patch.elementCount - 1);
            for (Index corner = 0; corner < 8; ++corner)
                data.corners[8 * std::size_t(tile) + std::size_t(corner * stride + e)] =
                    patches.corners[8 * std::size_t(element) + std::size_t(corner)];
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

void addGroups(SolverData& data, const Model& model)
{
    for (std::size_t i = 0; i < data.patches.size(); ++i) {
        const Part& part = model.parts[std::size_t(data.patches[i].material)];
        if (part.kind == PartKind::rigid) {
            data.rigidParts = true;
            continue;
        }
        const bool general = needsGeneralPlasticity(part);
        const auto same = [&](const KernelGroup& group) {
            return group.general == general && (general || group.kind == part.kind)
                   && group.hourglass == part.hourglass;
        };
        auto group = std::find_if(data.groups.begin(), data.groups.end(), same);
        if (group == data.groups.end())
            group = data.groups.insert(group, {part.kind, general, part.hourglass, {}});
        group->patches.push_back(Index(i));
    }
}

void addMass(SolverData& data, const Model& model)
{
    data.nodeMass.assign(std::size_t(data.nodeCount), 0.0);
    for (Index element = 0; element < data.elementCount; ++element) {
        const double mass =
            data.elementMass[data.tileOf(element)
                             + std::size_t(data.elementPlace[std::size_t(element)])];
        for (const Index node : model.mesh.hexahedra[std::size_t(element)])
            data.nodeMass[std::size_t(node)] += mass / 8;
    }
}

/// Factor of the value that a driven node moves with at time 0: a body driven from the start is in
/// motion then, it is not struck.
double startFactor(const Condition& condition, const std::vector<double>& rows)
{
    if (condition.kind == 1) return amplitudeAt(condition, rows.data(), 0);
    const double* row = rows.data() + 2 * std::size_t(condition.firstRow);
    for (Index i = 1; i < condition.rowCount; ++i) {
        const double before = row[2 * i - 2], after = row[2 * i], length = after - before;
        if (!(before <= 0 && 0 < after)) continue;
        const double tau = -before / length, slope = (row[2 * i + 1] - row[2 * i - 1]) / length;
        return condition.smooth ? slope * 30 * tau * tau * (1 - tau) * (1 - tau) : slope;
    }
    return 0;
}

void addMotion(SolverData& data, const Model& model)
{
    data.velocity.assign(std::size_t(data.nodeCount), Point{0, 0, 0});
    data.fixed.assign(std::size_t(data.nodeCount), 0);
    for (const InitialVelocity& initial : model.initialVelocities)
        for (const Index node : initial.nodes) data.velocity[std::size_t(node)] = initial.velocity;

    std::vector<std::pair<Index, Index>> uses; // node, condition
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        int components = 0;
        for (int c = 0; c < 3; ++c) components |= int(condition.constrains[std::size_t(c)]) << c;
        if (condition.kind == BoundaryCondition::Kind::fixed) {
            for (const Index node : condition.nodes) {
                data.fixed[std::size_t(node)] |= std::uint8_t(components);
                for (int c = 0; c < 3; ++c)
                    if ((components >> c) & 1) data.velocity[std::size_t(node)][std::size_t(c)] = 0;
            }
            continue;
        }
        Condition out{};
        out.kind = condition.kind == BoundaryCondition::Kind::displacement ? 0
                   : condition.kind == BoundaryCondition::Kind::velocity   ? 1
                                                                           : 2;
        out.components = components;
        out.smooth = condition.amplitude.kind == Amplitude::Kind::smooth;
        out.firstRow = Index(data.amplitudeRows.size() / 2);
        out.rowCount = Index(condition.amplitude.rows.size());
        for (const auto& row : condition.amplitude.rows) {
            data.amplitudeRows.push_back(row[0]);
            data.amplitudeRows.push_back(row[1]);
        }
        const double share = out.kind == 2 ? 1.0 / double(condition.nodes.size()) : 1.0;
        for (int c = 0; c < 3; ++c) out.value[c] = share * condition.value[std::size_t(c)];
        if (out.kind != 2)
            for (const Index node : condition.nodes)
                for (int c = 0; c < 3; ++c)
                    if ((components >> c) & 1)
                        data.velocity[std::size_t(node)][std::size_t(c)] =
                            out.value[c] * startFactor(out, data.amplitudeRows);
        for (const Index node : condition.nodes)
            uses.emplace_back(node, Index(data.conditions.size()));
        data.conditions.push_back(out);
    }
    if (uses.empty()) return;
    std::sort(uses.begin(), uses.end());
    data.conditionStart.assign(std::size_t(data.nodeCount) + 1, 0);
    for (const auto& [node, condition] : uses) {
        ++data.conditionStart[std::size_t(node) + 1];
        data.conditionOf.push_back(condition);
    }
    for (std::size_t i = 1; i < data.conditionStart.size(); ++i)
        data.conditionStart[i] += data.conditionStart[i - 1];
}

} // namespace

SolverData makeSolverData(const Model& model)
{
    SolverData data;
    data.nodeCount = Index(model.mesh.points.size());
    data.elementCount = Index(model.mesh.hexahedra.size());
    for (const Part& part : model.parts) data.materials.push_back(materialConstants(part));
    addPatches(data, model, makePatches(model.mesh));
    addGroups(data, model);
    addMass(data, model);
    addMotion(data, model);
    if (!model.contactPairs.empty()) addContact(data, model);
    return data;
}

} // namespace fpm
