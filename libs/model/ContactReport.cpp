#include "model/ContactReport.h"

#include "base/Format.h"
#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "model/FaceTree.h"
#include "model/PointAlgebra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace fpm {

namespace {

constexpr double noteworthy = 0.05; ///< depth of an overlap, of a face's width: more is warned of

double totalArea(const Mesh& mesh, const std::vector<ElementSide>& sides)
{
    double sum = 0;
    for (const ElementSide& side : sides) sum += area(mesh, side);
    return sum;
}

/// Height of the element over one of its sides, were it a prism.
double thickness(const Mesh& mesh, const ElementSide& side)
{
    const double base = area(mesh, side);
    return base > 0 ? volume(mesh, side.element) / base : 0;
}

std::set<Index> nodesInside(const InitialDepths& depths)
{
    std::set<Index> nodes(depths.astray.begin(), depths.astray.end());
    for (const auto* list : {&depths.held, &depths.tooDeep})
        for (const InitialDepths::Node& entry : *list) nodes.insert(entry.node);
    return nodes;
}

template <class Value>
std::size_t sharedCount(const std::vector<Value>& a, const std::vector<Value>& b)
{
    std::vector<Value> shared;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
    return shared.size();
}

/// Nodes in cells, to find those within a small distance of one another.
class Neighbourhood
{
public:
    Neighbourhood(const std::vector<Point>& points,
                  const std::vector<Index>& nodes,
                  double distance)
        : points_(points),
          distance_(distance)
    {
        for (const Index node : nodes)
            cells_[cell(points[std::size_t(node)], {0, 0, 0})].push_back(node);
    }

    /// Nodes within the distance of a node, but for itself.
    std::set<Index> around(Index node) const
    {
        const Point& p = points_[std::size_t(node)];
        std::set<Index> found;
        for (int corner = 0; corner < 8; ++corner) {
            const auto shift = [&](int axis) { return (corner >> axis) & 1 ? 1.0 : -1.0; };
            const auto here = cells_.find(cell(p, {shift(0), shift(1), shift(2)}));
            if (here == cells_.end()) continue;
            for (const Index other : here->second)
                if (other != node
                    && length(difference(points_[std::size_t(other)], p)) <= distance_)
                    found.insert(other);
        }
        return found;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    /// Cells are wide against the distance, so that a ball overlaps few of them.
    Cell cell(const Point& p, const Point& shift) const
    {
        Cell out{};
        for (std::size_t c = 0; c < 3; ++c)
            out[c] = std::int64_t(std::floor((p[c] + shift[c] * distance_) / (64 * distance_)));
        return out;
    }

    const std::vector<Point>& points_;
    double distance_;
    std::map<Cell, std::vector<Index>> cells_;
};

} // namespace

ContactFit measureContact(const Mesh& mesh, const ContactSurfaces& surfaces)
{
    // A node lies over or under a face, not beside its border, when its offset is along the normal.
    constexpr double overTheFace = 0.866;
    ContactFit fit;
    fit.contactorArea = totalArea(mesh, surfaces.contactorSides);
    fit.targetArea = totalArea(mesh, surfaces.targetSides);
    fit.targetSize = std::sqrt(fit.targetArea / double(surfaces.targetSides.size()));
    fit.smallestGap = std::numeric_limits<double>::infinity();
    const double touching = 1e-6 * fit.targetSize;

    const FaceTree tree(mesh, surfaces.targetSides);
    const std::vector<Point> outward = contactorNormals(mesh, surfaces);
    fit.depths = initialDepths(mesh, surfaces);
    const std::set<Index> inside = nodesInside(fit.depths);
    std::vector<bool> pointsAway(surfaces.targetSides.size(), false);
    double sum = 0;
    for (std::size_t i = 0; i < surfaces.contactorNodes.size(); ++i) {
        const Index node = surfaces.contactorNodes[i];
        if (inside.count(node)) continue;
        const FaceTree::Hit hit = tree.nearest(mesh.points[std::size_t(node)], outward[i]);
        const ElementSide& side = surfaces.targetSides[hit.face];
        if (hit.height < -touching && -hit.height >= overTheFace * hit.distance) {
            pointsAway[hit.face] = pointsAway[hit.face] || -hit.height > thickness(mesh, side);
        } else if (hit.height >= -touching && dot(outward[i], normal(mesh, side)) < 0) {
            ++fit.facingNodes;
            const double gap = hit.distance <= touching ? 0.0 : hit.distance;
            fit.smallestGap = std::min(fit.smallestGap, gap);
            sum += gap;
        }
    }
    if (fit.facingNodes > 0)
        fit.meanGap = sum / double(fit.facingNodes);
    else
        fit.smallestGap = 0;
    fit.facesPointingAway = std::size_t(std::count(pointsAway.begin(), pointsAway.end(), true));
    return fit;
}

void reportOverlaps(const Mesh& mesh,
                    const std::string& pair,
                    const ContactFit& fit,
                    InitialOverlap overlap,
                    Log& log)
{
    const std::vector<InitialDepths::Node>& held = fit.depths.held;
    if (held.empty()) {
        if (!fit.depths.astray.empty() && fit.depths.tooDeep.empty())
            log.warning(
                format("pair {}: {} contactor nodes lie inside the target, such as node {} "
                       "at {}, and none "
                       "of them is held: no face near them points towards them; do the bodies "
                       "overlap, or is one "
                       "inside the other?",
                       pair, fit.depths.astray.size(), fit.depths.astray.front(),
                       pointText(mesh.points[std::size_t(fit.depths.astray.front())])));
        return;
    }
    const auto deepest = std::max_element(
        held.begin(), held.end(), [](const auto& a, const auto& b) { return a.depth < b.depth; });
    const std::string what =
        format("pair {}: {} contactor nodes lie inside the target, deepest {} ({} of a face's "
               "width) at node {} {}",
               pair, held.size(), deepest->depth, deepest->depth / fit.targetSize, deepest->node,
               pointText(mesh.points[std::size_t(deepest->node)]));
    switch (overlap) {
    case InitialOverlap::report:
        log.warning(what + "; they are pushed out at the first step (see 'initialOverlap')");
        break;
    case InitialOverlap::offset:
        if (deepest->depth > noteworthy * fit.targetSize)
            log.warning(
                what
                + "; this causes no force until they have separated: move the bodies apart, "
                  "or for a press fit write 'initialOverlap ramp;' and 'rampTime'");
        else
            log.line(what + "; this causes no force until they have separated");
        break;
    case InitialOverlap::ramp:
        log.line(what + "; the force of this grows over rampTime");
        break;
    case InitialOverlap::move:
        log.line(what + "; they are moved to the surface, free of stress");
        break;
    }
}

/// No contactor node faces the target, nor lies inside.
static void reportUnmet(const Mesh& mesh, const ContactSurfaces& surfaces, int passes, Log& log)
{
    const ContactFit swapped =
        measureContact(mesh, {surfaces.pair, nodesOf(mesh, surfaces.targetSides),
                              surfaces.targetSides, surfaces.contactorSides});
    const bool other = swapped.facingNodes > 0 || !swapped.depths.held.empty();
    if (other && passes == 2)
        log.line(format("    its second pass meets: {} nodes of the target face the contactor, "
                        "smallest gap {}",
                        swapped.facingNodes, swapped.smallestGap));
    else if (other)
        log.warning(format("pair {}: no contactor node faces the target, but {} nodes of the "
                           "target face the contactor: swap contactor and target, or set passes "
                           "two",
                           surfaces.pair, swapped.facingNodes + swapped.depths.held.size()));
    else
        log.warning(format("pair {}: no contactor node faces the target; are contactor and target "
                           "the surfaces that meet?",
                           surfaces.pair));
}

void reportContact(const Mesh& mesh,
                   const ContactSurfaces& surfaces,
                   const ContactFit& fit,
                   InitialOverlap overlap,
                   int passes,
                   Log& log)
{
    log.line(format("pair {}: {} contactor nodes (area {}), {} target faces (area {})",
                    surfaces.pair, surfaces.contactorNodes.size(), fit.contactorArea,
                    surfaces.targetSides.size(), fit.targetArea));
    if (fit.facingNodes > 0)
        log.line(format("    initial gap: smallest {}, mean {} over {} nodes that face the target",
                        fit.smallestGap, fit.meanGap, fit.facingNodes));
    else if (fit.depths.none() && fit.facesPointingAway == 0)
        reportUnmet(mesh, surfaces, passes, log);
    reportOverlaps(mesh, surfaces.pair, fit, overlap, log);
    if (fit.facesPointingAway > 0)
        log.warning(
            format("pair {}: {} target faces point away from the contactor nodes nearest to "
                   "them, which lie deeper behind than one element; narrow the target with "
                   "'facing', or check the positions of the bodies",
                   surfaces.pair, fit.facesPointingAway));
}

void reportSeams(const Mesh& mesh, const ContactSurfaces& surfaces, Log& log)
{
    double areas = 0;
    std::map<Index, std::set<Index>> together; // nodes of one face
    for (const ElementSide& side : surfaces.targetSides) {
        areas += area(mesh, side);
        const Quad quad = mesh.sideNodes(side);
        for (const Index node : quad) together[node].insert(quad.begin(), quad.end());
    }
    const double close = 1e-6 * std::sqrt(areas / double(surfaces.targetSides.size()));
    const Neighbourhood near(mesh.points, nodesOf(mesh, surfaces.targetSides), close);
    std::set<Index> doubled;
    for (const auto& [node, faces] : together)
        for (const Index other : near.around(node))
            if (!faces.count(other)) doubled.insert({node, other});
    if (doubled.empty()) return;
    log.warning(format("pair {}: {} target nodes lie on one another without being one, first node "
                       "{} at {}: the target has a seam there, contactors may slip through when "
                       "it opens",
                       surfaces.pair, doubled.size(), *doubled.begin(),
                       pointText(mesh.points[std::size_t(*doubled.begin())])));
}

void reportSharing(const std::vector<ContactSurfaces>& pairs, Log& log)
{
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (std::size_t j = i + 1; j < pairs.size(); ++j) {
            const ContactSurfaces &a = pairs[i], &b = pairs[j];
            const std::size_t nodes = sharedCount(a.contactorNodes, b.contactorNodes);
            if (nodes == 0) continue;
            const std::size_t sides = sharedCount(a.targetSides, b.targetSides);
            if (sides > 0)
                log.warning(format("pairs {} and {} share {} contactor nodes and {} target faces: "
                                   "the penalty acts twice there",
                                   a.pair, b.pair, nodes, sides));
            else
                log.line(format("pairs {} and {} share {} contactor nodes (with different targets)",
                                a.pair, b.pair, nodes));
        }
}

} // namespace fpm
