#include "model/EdgeCrossing.h"

#include "model/PointAlgebra.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fpm {

namespace {

using vector::cross;

struct Segment {
    Point a, b;
};

Point areaVector(const std::vector<Point>& points, const Quad& quad)
{
    const auto x = [&](std::size_t k) { return points[std::size_t(quad[k])]; };
    return cross(difference(x(2), x(0)), difference(x(3), x(1)));
}

std::vector<Segment> sharpEdges(const Mesh& mesh,
                                const std::vector<Point>& points,
                                const std::vector<ElementSide>& sides,
                                const std::vector<SurfaceMirror>& mirrors)
{
    constexpr double cosine30 = 0.86602540378443865;
    std::map<std::pair<Index, Index>, std::vector<Point>> normals;
    for (const ElementSide& side : sides) {
        const Quad quad = mesh.sideNodes(side);
        const auto isCut = [&](const SurfaceMirror& mirror) { // the scene goes on behind it
            return std::all_of(quad.begin(), quad.end(),
                               [&](Index node) { return (*mirror.holds)[std::size_t(node)]; });
        };
        if (std::any_of(mirrors.begin(), mirrors.end(), isCut)) continue;
        for (std::size_t k = 0; k < 4; ++k)
            normals[std::minmax(quad[k], quad[(k + 1) % 4])].push_back(areaVector(points, quad));
    }
    std::vector<Segment> edges;
    for (auto& [nodes, faces] : normals) {
        for (const SurfaceMirror& mirror : mirrors)
            if (faces.size() == 1 && (*mirror.holds)[std::size_t(nodes.first)]
                && (*mirror.holds)[std::size_t(nodes.second)])
                faces.push_back(along(faces[0], -2 * dot(faces[0], mirror.normal), mirror.normal));
        const bool smooth =
            faces.size() == 2
            && dot(faces[0], faces[1]) > cosine30 * length(faces[0]) * length(faces[1]);
        if (!smooth)
            edges.push_back({points[std::size_t(nodes.first)], points[std::size_t(nodes.second)]});
    }
    return edges;
}

/// Where the segment passes through the triangle: share of its length; -1: not at all.
double piercing(const Segment& segment, const Point& a, const Point& b, const Point& c)
{
    const Point ab = difference(b, a), ac = difference(c, a), n = cross(ab, ac);
    const Point d = difference(segment.b, segment.a);
    const double slope = dot(d, n);
    if (slope == 0) return -1;
    const double t = dot(difference(a, segment.a), n) / slope;
    if (!(t > 0 && t < 1)) return -1;
    const Point p = difference(along(segment.a, t, d), a);
    const double u = dot(cross(p, ac), n), v = dot(cross(ab, p), n), size = dot(n, n);
    return u >= 0 && v >= 0 && u + v <= size ? t : -1;
}

double distanceToSegment(const Point& x, const Point& a, const Point& b)
{
    const Point d = difference(b, a), ax = difference(x, a);
    const double square = dot(d, d), t = square > 0 ? dot(ax, d) / square : 0;
    return length(difference(x, along(a, std::clamp(t, 0.0, 1.0), d)));
}

double distanceToTriangle(const Point& x, const Point& a, const Point& b, const Point& c)
{
    const Point n = cross(difference(b, a), difference(c, a));
    const double size = dot(n, n), height = dot(difference(x, a), n);
    const auto isWithin = [&](const Point& from, const Point& to) {
        return dot(cross(difference(to, from), difference(x, from)), n) >= 0;
    };
    if (size > 0 && isWithin(a, b) && isWithin(b, c) && isWithin(c, a))
        return std::abs(height) / std::sqrt(size);
    return std::min(
        {distanceToSegment(x, a, b), distanceToSegment(x, b, c), distanceToSegment(x, c, a)});
}

/// Faces as two triangles each, sorted along x, to find those near a segment.
class Sweep
{
public:
    Sweep(const Mesh& mesh, const std::vector<Point>& points, const std::vector<ElementSide>& sides)
        : points_(points)
    {
        for (const ElementSide& side : sides) {
            Face face{mesh.sideNodes(side), {}, {}};
            for (std::size_t c = 0; c < 3; ++c) {
                const auto x = [&](std::size_t k) { return points[std::size_t(face.quad[k])][c]; };
                face.least[c] = std::min({x(0), x(1), x(2), x(3)});
                face.most[c] = std::max({x(0), x(1), x(2), x(3)});
            }
            widest_ = std::max(widest_, face.most[0] - face.least[0]);
            faces_.push_back(face);
        }
        std::sort(faces_.begin(), faces_.end(),
                  [](const Face& a, const Face& b) { return a.least[0] < b.least[0]; });
    }

    /// Depth of the middle where the segment enters the surface and leaves it again, outside at
    /// both ends, in widths of the nearest face or, where it leaves on the other side, in lengths
    /// of its path through the body if that is less; 0: it does not cross.
    double crosses(const Segment& s, Point& place) const
    {
        double first = 2, last = -1;
        const Face *enters = nullptr, *leaves = nullptr;
        const double from = std::min(s.a[0], s.b[0]) - widest_, to = std::max(s.a[0], s.b[0]);
        auto face = std::lower_bound(faces_.begin(), faces_.end(), from,
                                     [](const Face& f, double x) { return f.least[0] < x; });
        for (; face != faces_.end() && face->least[0] <= to; ++face) {
            if (!overlaps(*face, s)) continue;
            const double t = pierced(*face, s);
            if (t < 0) continue;
            const bool inwards = dot(difference(s.b, s.a), areaVector(points_, face->quad)) < 0;
            if (inwards && t < first) {
                first = t;
                enters = &*face;
            }
            if (!inwards && t > last) {
                last = t;
                leaves = &*face;
            }
        }
        if (!enters || !leaves || !(first < last)) return 0;
        place = along(s.a, 0.5 * (first + last), difference(s.b, s.a));
        const Point n1 = areaVector(points_, enters->quad), n2 = areaVector(points_, leaves->quad);
        const double through = (last - first) * length(difference(s.b, s.a));
        return depth(place, dot(n1, n2) < 0 ? through : 1e300);
    }

private:
    struct Face {
        Quad quad;
        Point least, most;
    };
    /// Of a place inside, over the width of the nearest face or `most`, if that is less.
    double depth(const Point& place, double most) const
    {
        double least = 1e300, width = most;
        for (const Face& face : faces_) {
            const auto x = [&](std::size_t k) { return points_[std::size_t(face.quad[k])]; };
            const double distance = std::min(distanceToTriangle(place, x(0), x(1), x(2)),
                                             distanceToTriangle(place, x(0), x(2), x(3)));
            if (!(distance < least)) continue;
            least = distance;
            width = std::min(most, std::sqrt(0.5 * length(areaVector(points_, face.quad))));
        }
        return width > 0 ? least / width : 0;
    }
    static bool overlaps(const Face& face, const Segment& s)
    {
        for (std::size_t c = 0; c < 3; ++c)
            if (std::max(s.a[c], s.b[c]) < face.least[c] || std::min(s.a[c], s.b[c]) > face.most[c])
                return false;
        return true;
    }
    double pierced(const Face& face, const Segment& s) const
    {
        const auto x = [&](std::size_t k) { return points_[std::size_t(face.quad[k])]; };
        const double t = piercing(s, x(0), x(1), x(2));
        return t >= 0 ? t : piercing(s, x(0), x(2), x(3));
    }

    const std::vector<Point>& points_;
    std::vector<Face> faces_;
    double widest_ = 0;
};

void count(EdgeCrossings& found, const std::vector<Segment>& edges, const Sweep& faces)
{
    constexpr double least = 0.01; // penalties let surfaces in contact overlap as deeply
    for (const Segment& edge : edges) {
        Point place;
        const double depth = faces.crosses(edge, place);
        if (!(depth > least)) continue;
        ++found.count;
        if (!(depth > found.depth)) continue;
        found.depth = depth;
        found.place = place;
    }
}

} // namespace

EdgeCrossings edgeCrossings(const Mesh& mesh,
                            const std::vector<Point>& points,
                            const std::vector<ElementSide>& contactor,
                            const std::vector<ElementSide>& target,
                            const std::vector<SurfaceMirror>& mirrors)
{
    EdgeCrossings found;
    count(found, sharpEdges(mesh, points, contactor, mirrors), Sweep(mesh, points, target));
    count(found, sharpEdges(mesh, points, target, mirrors), Sweep(mesh, points, contactor));
    return found;
}

} // namespace fpm
