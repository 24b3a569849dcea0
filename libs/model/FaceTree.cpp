#include "model/FaceTree.h"

#include "base/Error.h"
#include "mesh/Surface.h"
#include "model/PointAlgebra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fpm {

namespace {

constexpr std::size_t leafSize = 8;

double squareTo(const Point& lower, const Point& upper, const Point& point)
{
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double out = std::max({lower[axis] - point[axis], point[axis] - upper[axis], 0.0});
        square += out * out;
    }
    return square;
}

/// Point of the triangle a b c nearest to p, by the region p projects to (method of Ericson,
/// Real-Time Collision Detection, 5.1.5).
Point nearestOnTriangle(const Point& a, const Point& b, const Point& c, const Point& p)
{
    const Point ab = difference(b, a), ac = difference(c, a), ap = difference(p, a);
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return a;
    const Point bp = difference(p, b);
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return along(a, d1 / (d1 - d3), ab);
    const Point cp = difference(p, c);
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return along(a, d2 / (d2 - d6), ac);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return along(b, (d4 - d3) / ((d4 - d3) + (d5 - d6)), difference(c, b));
    const double scale = 1 / (va + vb + vc);
    return along(along(a, vb * scale, ab), vc * scale, ac);
}

} // namespace

struct FaceTree::Best {
    Hit hit{0, {}, std::numeric_limits<double>::infinity(), 0};
    double opposition = 0; ///< of the face's normal to the point's own outward direction
};

FaceTree::FaceTree(const Mesh& mesh, std::span<const ElementSide> sides)
{
    if (sides.empty()) throw Error(ExitCode::internal, "a face tree without faces");
    for (const ElementSide& side : sides) {
        const Quad nodes = mesh.sideNodes(side);
        std::array<Point, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.points[std::size_t(nodes[i])];
        corners_.push_back(corners);
        normals_.push_back(normal(mesh, side));
        centres_.push_back(centre(mesh, side));
    }
    double sum = 0;
    for (const ElementSide& side : sides) sum += area(mesh, side);
    tolerance_ = 1e-9 * std::sqrt(sum / double(sides.size()));
    order_.resize(sides.size());
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    branches_.reserve(2 * sides.size());
    branches_.emplace_back();
    split(0, 0, sides.size());
}

FaceTree::Box FaceTree::boxOf(std::size_t first, std::size_t count) const
{
    constexpr double far = std::numeric_limits<double>::infinity();
    Box box{{far, far, far}, {-far, -far, -far}};
    for (std::size_t i = first; i < first + count; ++i)
        for (const Point& corner : corners_[order_[i]])
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box.lower[axis] = std::min(box.lower[axis], corner[axis]);
                box.upper[axis] = std::max(box.upper[axis], corner[axis]);
            }
    return box;
}

void FaceTree::split(std::size_t branch, std::size_t first, std::size_t count)
{
    const Box box = boxOf(first, count);
    branches_[branch] = {box, first, count, 0};
    if (count <= leafSize) return;

    const Point extent = difference(box.upper, box.lower);
    const std::size_t axis =
        std::size_t(std::max_element(extent.begin(), extent.end()) - extent.begin());
    const auto begin = order_.begin() + std::ptrdiff_t(first);
    std::nth_element(begin, begin + std::ptrdiff_t(count / 2), begin + std::ptrdiff_t(count),
                     [&](std::size_t a, std::size_t b) {
                         const double ca = centres_[a][axis], cb = centres_[b][axis];
                         return ca != cb ? ca < cb : a < b;
                     });
    const std::size_t child = branches_.size();
    branches_.resize(child + 2);
    branches_[branch].count = 0;
    branches_[branch].child = child;
    split(child, first, count / 2);
    split(child + 1, first + count / 2, count - count / 2);
}

void FaceTree::tryFace(std::size_t face,
                       const Point& point,
                       const Point& outward,
                       const Accept& accepts,
                       Best& best) const
{
    const auto& [a, b, c, d] = corners_[face];
    const double opposition = -dot(normals_[face], outward);
    for (const Point& candidate :
         {nearestOnTriangle(a, b, c, point), nearestOnTriangle(a, c, d, point)}) {
        const Point offset = difference(point, candidate);
        const Hit hit{face, candidate, length(offset), dot(offset, normals_[face])};
        if (hit.distance > best.hit.distance + tolerance_) continue;
        if (hit.distance >= best.hit.distance - tolerance_) {
            const double lead = std::abs(hit.height) - std::abs(best.hit.height);
            if (lead < -tolerance_) continue;
            if (lead <= tolerance_
                && (opposition < best.opposition
                    || (opposition == best.opposition && face >= best.hit.face)))
                continue;
        }
        if (accepts && !accepts(hit)) continue;
        best = {hit, opposition};
    }
}

FaceTree::Hit FaceTree::nearest(const Point& point, const Point& outward) const
{
    return nearest(point, outward, {});
}

FaceTree::Hit
FaceTree::nearest(const Point& point, const Point& outward, const Accept& accepts) const
{
    Best best;
    std::array<std::pair<double, std::size_t>, 128> waiting; // deeper than any balanced tree
    std::size_t count = 0;
    waiting[count++] = {0.0, 0};
    while (count > 0) {
        const auto [square, number] = waiting[--count];
        if (std::sqrt(square) > best.hit.distance + tolerance_) continue;
        const Branch& branch = branches_[number];
        for (std::size_t i = branch.first; i < branch.first + branch.count; ++i)
            tryFace(order_[i], point, outward, accepts, best);
        if (branch.count > 0) continue;

        std::array<std::pair<double, std::size_t>, 2> children;
        for (std::size_t i = 0; i < 2; ++i) {
            const Box& box = branches_[branch.child + i].box;
            children[i] = {squareTo(box.lower, box.upper, point), branch.child + i};
        }
        if (children[0].first < children[1].first) std::swap(children[0], children[1]);
        for (const auto& child : children) waiting[count++] = child; // the nearer is taken first
    }
    return best.hit;
}

} // namespace fpm
