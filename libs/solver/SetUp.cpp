#include "solver/SetUp.h"

#include "solver/elements/ModelSizes.h"

#include <algorithm>

namespace fpm {

namespace {

/// Rest is sought from the end of the last amplitude and of the last overlap that fades.
void addRelaxation(SolverSetUp& data, const Model& model)
{
    data.nodes.relaxation.tolerance = model.control.relaxationTolerance;
    double& held = data.nodes.relaxation.heldFrom;
    const auto wait = [&](const Condition& condition) {
        const Index last = condition.firstRow + condition.rowCount - 1;
        if (condition.rowCount > 1)
            held = std::max(held, data.nodes.amplitudeRows[2 * std::size_t(last)]);
    };
    for (const Condition& condition : data.nodes.conditions) wait(condition);
    for (const SurfaceShape& surface : data.contact.surfaces)
        if (surface.moves) wait(surface.motion);
    for (const ContactPassSetup& pass : data.contact.passes) held = std::max(held, pass.fadeTime);
}

} // namespace

void shareNodes(SolverSetUp& data)
{
    std::vector<bool> interior(std::size_t(data.nodes.count), false);
    for (const KernelGroup& group : data.elements.groups)
        for (const Index number : group.patches) {
            const PatchHeader& patch = data.elements.patches[std::size_t(number)];
            for (Index i = 0; i < patch.interiorCount; ++i)
                interior[std::size_t(patch.firstNode + i)] = true;
        }
    data.nodes.listed.clear();
    for (std::size_t node = 0; node < interior.size(); ++node) {
        std::uint8_t& fixed = data.nodes.fixed[node];
        fixed &= std::uint8_t(~listedNode);
        const auto has = [=](const std::vector<Index>& start) {
            return !start.empty() && start[node + 1] > start[node];
        };
        const auto numbered = [=](const std::vector<Index>& number) {
            return !number.empty() && number[node] >= 0;
        };
        const bool acted = fixed || has(data.nodes.conditionStart) || has(data.nodes.pressureStart)
                           || numbered(data.nodes.frameOf) || numbered(data.contact.numberOf)
                           || has(data.contact.surfaceStart);
        if ((interior[node] && !acted) || (fixed & bodyNode)) continue;
        fixed |= listedNode;
        data.nodes.listed.push_back(Index(node));
    }
    for (const KernelGroup& group : data.elements.groups)
        for (const Index number : group.patches) {
            PatchHeader& patch = data.elements.patches[std::size_t(number)];
            const auto first = data.nodes.fixed.begin() + patch.firstNode;
            patch.movesInterior = std::count(first, first + patch.interiorCount, 0) > 0;
        }
}

SolverSetUp makeSetUp(const Model& model, bool audit)
{
    requirePlaces(sizesOf(model));
    SolverSetUp data;
    data.nodes.count = Index(model.mesh.points.size());
    addElements(data, model);
    addMotion(data, model);
    if (!model.contactPairs.empty()) addContact(data, model);
    addRelaxation(data, model);
    addLoadedBodyNodes(data);
    // Works of all nodes and the sums of relaxation are blocks of all nodes in a row.
    data.nodes.movedByPatches = model.control.assembly == Assembly::patch && !audit
                                && !(model.control.massDamping > 0)
                                && !(data.nodes.relaxation.tolerance > 0);
    if (data.nodes.movedByPatches) shareNodes(data);
    return data;
}

} // namespace fpm
