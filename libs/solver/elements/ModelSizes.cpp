#include "solver/elements/ModelSizes.h"

#include "base/Error.h"
#include "base/Format.h"
#include "kernels/contact/ContactPassView.h"
#include "kernels/element/StateLayout.h"

#include <algorithm>
#include <set>

namespace fpm {

namespace {

const std::vector<ElementSide>& contactorSides(const Model& model, const ContactPair& pair)
{
    static const std::vector<ElementSide> none; // refused with words of its own later on
    for (const ContactSurfaces& surfaces : model.mesh.contact)
        if (surfaces.pair == pair.name) return surfaces.contactorSides;
    return none;
}

/// Counts nodes of sides, each once.
class NodeCount
{
public:
    explicit NodeCount(const Mesh& mesh) : mesh_(mesh), seen_(mesh.points.size(), false) {}
    void add(const std::vector<ElementSide>& sides)
    {
        for (const ElementSide& side : sides)
            for (const Index node : mesh_.sideNodes(side)) {
                if (!seen_[std::size_t(node)]) ++count_;
                seen_[std::size_t(node)] = true;
            }
    }
    std::size_t count() const { return count_; }

private:
    const Mesh& mesh_;
    std::vector<bool> seen_;
    std::size_t count_ = 0;
};

/// Bodies that one contactor may touch at once, as passes have slots for them.
std::size_t
slotsOf(const Model& model, const ContactPair& pair, const std::vector<ElementSide>& target)
{
    if (pair.kind != ContactKind::general && pair.search == ContactSearch::closestParticle)
        return 1;
    std::set<Index> bodies;
    for (const ElementSide& side : target) bodies.insert(model.mesh.partOf(side.element));
    return std::clamp<std::size_t>(bodies.size(), 1, maxSlots);
}

void addPasses(ModelSizes& sizes, const Model& model)
{
    NodeCount touched(model.mesh);
    for (const ContactPair& pair : model.contactPairs) {
        const std::vector<ElementSide>&own = contactorSides(model, pair),
              &target = pair.targetSides;
        const auto add = [&](const std::vector<ElementSide>& from,
                             const std::vector<ElementSide>& to) {
            NodeCount nodes(model.mesh);
            nodes.add(from);
            sizes.passes.push_back(
                {pair.name, nodes.count() * slotsOf(model, pair, to), from.size(), to.size()});
        };
        add(own, target);
        if (pair.passes == 2) add(target, own);
        touched.add(own);
        touched.add(target);
    }
    sizes.contactNodes = touched.count();
}

void require(std::size_t places, const std::string& what, const std::string& advice)
{
    if (places <= mostPlaces) return;
    throw Error(ExitCode::mesh,
                format("{} take {} places in one list; at most {} can be numbered", what, places,
                       mostPlaces),
                advice);
}

const char* const coarser = "use a coarser mesh";
const char* const smaller = "use a coarser mesh, or let only sides that can meet be its surfaces";

void requirePass(const ModelSizes::Pass& pass)
{
    const auto of = [&](const char* what, std::size_t count) {
        return format("contact pair '{}': {} {}", pass.pair, count, what);
    };
    require(3 * pass.contactors, of("contactors", pass.contactors), smaller); // vectors, in planes
    require(4 * pass.ownFaces, of("faces of the contactor", pass.ownFaces), smaller);
    require(4 * pass.faces, of("faces of the target", pass.faces), smaller);
}

} // namespace

ModelSizes sizesOf(const Model& model)
{
    ModelSizes sizes;
    const std::vector<Index>& starts = model.mesh.patchStarts;
    for (std::size_t patch = 0; patch + 1 < starts.size(); ++patch)
        sizes.paddedElements += std::size_t((starts[patch + 1] - starts[patch] + tileWidth - 1)
                                            / tileWidth * tileWidth);
    sizes.parts = model.parts.size();
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        if (condition.kind == BoundaryCondition::Kind::pressure)
            sizes.pressureSides += condition.sides.size();
        else if (condition.kind != BoundaryCondition::Kind::fixed)
            sizes.uses += (condition.isLoad() ? 1 : 3) * condition.nodes.size();
    }
    addPasses(sizes, model);
    return sizes;
}

void requirePlaces(const ModelSizes& sizes)
{
    // makePatches() judges the corners of elements; those that fill patches up count here.
    require(8 * sizes.paddedElements,
            format("corners of {} elements, small patches filled up,", sizes.paddedElements),
            coarser);
    require(sizes.parts * sizes.parts, format("pairs of {} parts", sizes.parts),
            "let bodies that belong together be one part");
    require(4 * sizes.pressureSides,
            format("corners of {} sides under pressure", sizes.pressureSides), coarser);
    require(sizes.uses, "nodes of all loads and drives together", coarser);
    require(4 * sizes.contactNodes, format("forces on {} nodes in contact", sizes.contactNodes),
            smaller);
    for (const ModelSizes::Pass& pass : sizes.passes) requirePass(pass);
}

void requireExclusionPlaces(const std::string& pair, std::size_t exclusions)
{
    require(exclusions,
            format("contact pair '{}': the faces around each contactor, no partners of it,", pair),
            smaller);
}

} // namespace fpm
