#include "run/BodyOverlap.h"

#include "mesh/Vector.h"
#include "run/Box.h"

#include <algorithm>

namespace fpm {

namespace {

/// Behind all six sides, each a plane through its middle.
bool isInside(const std::vector<Point>& points, const Hexahedron& element, const Point& p)
{
    using namespace vector;
    for (const auto& corners : sideCorners) {
        const auto x = [&](std::size_t k) -> const Point& {
            return points[std::size_t(element[std::size_t(corners[k])])];
        };
        const Point area = cross(difference(x(2), x(0)), difference(x(3), x(1)));
        const Point middle = scaled(sum(sum(x(0), x(1)), sum(x(2), x(3))), 0.25);
        const double twice = length(area); // of the area
        if (!(dot(difference(p, middle), area) < -0.01 * std::sqrt(0.5 * twice) * twice))
            return false;
    }
    return true;
}

} // namespace

BodyOverlap overlapOf(const Mesh& mesh,
                      const std::vector<Point>& points,
                      const std::vector<Index>& nodes,
                      const std::vector<std::size_t>& parts)
{
    Box own;
    for (const Index node : nodes) own.take(points[std::size_t(node)]);
    // Nodes by x: an element asks only those that its box may hold.
    std::vector<Index> sorted;
    BodyOverlap found;
    std::vector<bool> seen(nodes.size(), false);
    for (const std::size_t part : parts) {
        const Index first = mesh.parts[part].firstElement;
        for (Index e = first; e < first + mesh.parts[part].elementCount; ++e) {
            const Hexahedron& element = mesh.hexahedra[std::size_t(e)];
            Box box;
            for (const Index node : element) box.take(points[std::size_t(node)]);
            if (!box.meets(own)) continue;
            if (sorted.empty()) {
                sorted = nodes;
                std::sort(sorted.begin(), sorted.end(), [&](Index a, Index b) {
                    return points[std::size_t(a)][0] < points[std::size_t(b)][0];
                });
            }
            auto node =
                std::lower_bound(sorted.begin(), sorted.end(), box.least[0],
                                 [&](Index i, double x) { return points[std::size_t(i)][0] < x; });
            for (; node != sorted.end() && points[std::size_t(*node)][0] <= box.most[0]; ++node) {
                const Point& p = points[std::size_t(*node)];
                if (seen[std::size_t(node - sorted.begin())] || !box.holds(p)
                    || !isInside(points, element, p))
                    continue;
                seen[std::size_t(node - sorted.begin())] = true;
                if (found.count++ == 0) found.node = *node;
            }
        }
    }
    return found;
}

} // namespace fpm
