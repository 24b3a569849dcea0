#include "model/InitialDepth.h"

#include "base/Format.h"
#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "model/FaceTree.h"
#include "model/PointAlgebra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace fpm {

namespace {

/// Nodes nearer to the limit than this share of it are not relied upon to be held.
constexpr double rounding = 1e-5;

/// A node lies under a face, not beside its border, when its offset is along the normal.
constexpr double overTheFace = 0.866;

/// The material of a part: its box and, once something lies in that, its skin.
class Body
{
public:
    Body(const Mesh& mesh, Index part) : mesh_(mesh), part_(part)
    {
        const MeshPart& run = mesh.parts[std::size_t(part)];
        for (Index e = run.firstElement; e < run.firstElement + run.elementCount; ++e)
            for (const Index node : mesh.hexahedra[std::size_t(e)])
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double x = mesh.points[std::size_t(node)][axis];
                    lower_[axis] = std::min(lower_[axis], x);
                    upper_[axis] = std::max(upper_[axis], x);
                }
    }
    /// Deeper inside than `margin`, which may be negative.
    bool holds(const Point& point, double margin)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (point[axis] <= lower_[axis] + margin || point[axis] >= upper_[axis] - margin)
                return false;
        if (!skin_) skin_ = std::make_unique<FaceTree>(mesh_, skin(mesh_, part_));
        return skin_->nearest(point).height < -margin;
    }

private:
    const Mesh& mesh_;
    Index part_;
    Point lower_{1e300, 1e300, 1e300}, upper_{-1e300, -1e300, -1e300};
    std::unique_ptr<FaceTree> skin_;
};

/// The target sides of one part, with the depth to which contact finds a node under each.
struct Target {
    Index part;
    std::vector<ElementSide> sides;
    std::vector<double> limits;
    double touching; ///< a millionth of a face's width
};

Target targetOf(const Mesh& mesh, Index part, const std::vector<ElementSide>& sides)
{
    Target target{part, sides, {}, 0};
    double areas = 0;
    for (const ElementSide& side : sides) {
        const double a = area(mesh, side);
        areas += a;
        target.limits.push_back(a > 0 ? 0.5 * volume(mesh, side.element) / a : 0);
    }
    target.touching = 1e-6 * std::sqrt(areas / double(sides.size()));
    return target;
}

/// Surfaces in contact oppose each other; a node whose own normals cancel is not tested. The bounds
/// are those of the search.
bool opposes(const Point& outward, const Point& normal)
{
    return !(length(outward) > 0.2) || dot(normal, outward) < -0.01 * length(outward);
}

/// Sorts the contactor nodes that lie in one part of the target.
class Sorting
{
public:
    Sorting(const Mesh& mesh, const ContactSurfaces& surfaces, Target target, InitialDepths& out)
        : mesh_(mesh),
          surfaces_(surfaces),
          target_(std::move(target)),
          material_(mesh, target_.part),
          out_(out)
    {
    }

    void add(std::size_t number, Index ownPart, const Point& outward)
    {
        const Index node = surfaces_.contactorNodes[number];
        const Point& point = mesh_.points[std::size_t(node)];
        // A node of one part lies on both of its surfaces; only the depth decides there.
        const bool same = ownPart == target_.part;
        if (!same && !material_.holds(point, target_.touching)) return;
        if (!tree_) tree_.emplace(mesh_, target_.sides);
        const auto faces = [&](const FaceTree::Hit& hit) {
            return opposes(outward, normal(mesh_, target_.sides[hit.face]));
        };
        const FaceTree::Hit holder = tree_->nearest(point, outward, [&](const FaceTree::Hit& hit) {
            return hit.height < -target_.touching && -hit.height >= overTheFace * hit.distance
                   && hit.distance <= (1 - rounding) * target_.limits[hit.face] && faces(hit);
        });
        if (std::isfinite(holder.distance)) return keep(out_.held, node, holder);
        if (same) return;
        // The exit leads through the node's own body, by which it entered.
        // Of a body that is inside as a whole, any face that points towards it is one.
        Own& own = ownBody(ownPart);
        const FaceTree::Hit exit = tree_->nearest(point, outward, [&](const FaceTree::Hit& hit) {
            return own.inside ? faces(hit) : own.body.holds(hit.point, -target_.touching);
        });
        if (std::isfinite(exit.distance) && faces(exit))
            keep(out_.tooDeep, node, exit);
        else
            out_.astray.push_back(node);
    }

private:
    struct Own {
        Body body;
        bool inside; ///< the target, as a whole
    };
    Own& ownBody(Index part)
    {
        if (const auto found = bodies_.find(part); found != bodies_.end()) return found->second;
        const MeshPart& run = mesh_.parts[std::size_t(part)];
        bool inside = true;
        for (Index e = run.firstElement; inside && e < run.firstElement + run.elementCount; ++e)
            for (const Index node : mesh_.hexahedra[std::size_t(e)])
                inside = inside && material_.holds(mesh_.points[std::size_t(node)], 0);
        return bodies_.emplace(part, Own{Body(mesh_, part), inside}).first->second;
    }
    void keep(std::vector<InitialDepths::Node>& nodes, Index node, const FaceTree::Hit& hit)
    {
        nodes.push_back({node, hit.distance, hit.point, target_.limits[hit.face]});
    }

    const Mesh& mesh_;
    const ContactSurfaces& surfaces_;
    Target target_;
    Body material_;
    std::optional<FaceTree> tree_;
    std::map<Index, Own> bodies_;
    InitialDepths& out_;
};

/// A part with a side at each contactor node.
std::vector<Index> ownParts(const Mesh& mesh, const ContactSurfaces& surfaces)
{
    const std::vector<Index>& nodes = surfaces.contactorNodes;
    std::vector<Index> parts(nodes.size(), -1);
    for (const ElementSide& side : surfaces.contactorSides)
        for (const Index node : mesh.sideNodes(side))
            parts[std::size_t(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin())] =
                mesh.partOf(side.element);
    return parts;
}

} // namespace

std::vector<Point> contactorNormals(const Mesh& mesh, const ContactSurfaces& surfaces)
{
    const std::vector<Index>& nodes = surfaces.contactorNodes;
    std::vector<Point> normals(nodes.size(), Point{0, 0, 0});
    std::vector<int> count(nodes.size(), 0);
    for (const ElementSide& side : surfaces.contactorSides) {
        const Point direction = normal(mesh, side);
        for (const Index node : mesh.sideNodes(side)) {
            const auto found = std::lower_bound(nodes.begin(), nodes.end(), node);
            const std::size_t number = std::size_t(found - nodes.begin());
            normals[number] = along(normals[number], 1, direction);
            ++count[number];
        }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (count[i] > 0) normals[i] = along({0, 0, 0}, 1.0 / count[i], normals[i]);
    return normals;
}

InitialDepths initialDepths(const Mesh& mesh, const ContactSurfaces& surfaces)
{
    InitialDepths depths;
    std::map<Index, std::vector<ElementSide>> targets;
    for (const ElementSide& side : surfaces.targetSides)
        targets[mesh.partOf(side.element)].push_back(side);
    const std::vector<Point> outward = contactorNormals(mesh, surfaces);
    const std::vector<Index> own = ownParts(mesh, surfaces);
    for (const auto& [part, sides] : targets) {
        Sorting sorting(mesh, surfaces, targetOf(mesh, part, sides), depths);
        for (std::size_t i = 0; i < own.size(); ++i) sorting.add(i, own[i], outward[i]);
    }
    return depths;
}

void refuseDeepStart(const Mesh& mesh,
                     const ContactSurfaces& surfaces,
                     int passes,
                     const Dictionary& place,
                     const std::string& key)
{
    if (surfaces.contactorSides == surfaces.targetSides) return;
    std::vector<InitialDepths::Node> deep = initialDepths(mesh, surfaces).tooDeep;
    if (passes == 2) {
        const std::vector<InitialDepths::Node> others =
            initialDepths(mesh, {surfaces.pair, nodesOf(mesh, surfaces.targetSides),
                                 surfaces.targetSides, surfaces.contactorSides})
                .tooDeep;
        deep.insert(deep.end(), others.begin(), others.end());
    }
    if (deep.empty()) return;
    const auto& deepest = *std::max_element(deep.begin(), deep.end(), [](auto& a, auto& b) {
        return a.depth * b.limit < b.depth * a.limit;
    });
    place.fail(
        key,
        format("pair {}: {} contactor nodes start too deep inside the target to be held, "
               "such as node {} at {}: it lies {} deep, and contact finds a node down to {}, "
               "half the thickness of the target's element there",
               surfaces.pair, deep.size(), deepest.node,
               pointText(mesh.points[std::size_t(deepest.node)]), deepest.depth, deepest.limit),
        "they would feel no force and pass through: move the bodies apart in "
        "system/meshDict, or give the two a pair with 'initialOverlap move;', which puts "
        "the nodes on the surface");
}

} // namespace fpm
