#include "advise/Mirror.h"

#include "base/Format.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace fpm {

namespace {

std::string placeText(const Mesh& mesh, Index node)
{
    const Point& p = mesh.points[std::size_t(node)];
    return format("node {} at ({} {} {})", node, p[0], p[1], p[2]);
}

/// Nodes by position: cells far larger than the tolerance, so that most queries visit one cell.
class NodeFinder
{
public:
    explicit NodeFinder(double tolerance) : tolerance_(tolerance), cell_(1024 * tolerance) {}

    void add(Index node, const Point& p) { cells_[key(p)].push_back({node, p}); }
    /// The only node within the tolerance; -1: none, -2: several.
    Index at(const Point& p) const
    {
        Index found = -1;
        std::array<double, 3> first, last;
        for (std::size_t c = 0; c < 3; ++c) {
            first[c] = std::floor((p[c] - tolerance_) / cell_);
            last[c] = std::floor((p[c] + tolerance_) / cell_);
        }
        for (double x = first[0]; x <= last[0]; ++x)
            for (double y = first[1]; y <= last[1]; ++y)
                for (double z = first[2]; z <= last[2]; ++z) {
                    const auto cell = cells_.find(key(x, y, z));
                    if (cell == cells_.end()) continue;
                    for (const auto& [node, place] : cell->second)
                        if (near(place, p)) found = found == -1 ? node : -2;
                }
        return found;
    }

private:
    static std::uint64_t key(double x, double y, double z)
    {
        std::uint64_t sum = 0;
        for (const double c : {x, y, z})
            sum = (sum ^ std::uint64_t(std::int64_t(c))) * 0x9e3779b97f4a7c15U + (sum >> 29);
        return sum;
    }
    std::uint64_t key(const Point& p) const
    {
        return key(std::floor(p[0] / cell_), std::floor(p[1] / cell_), std::floor(p[2] / cell_));
    }
    bool near(const Point& a, const Point& b) const
    {
        return std::abs(a[0] - b[0]) <= tolerance_ && std::abs(a[1] - b[1]) <= tolerance_
               && std::abs(a[2] - b[2]) <= tolerance_;
    }

    double tolerance_, cell_;
    std::unordered_map<std::uint64_t, std::vector<std::pair<Index, Point>>> cells_;
};

std::vector<Index> nodesOf(const Mesh& mesh, const MeshPart& part)
{
    std::vector<Index> nodes;
    for (Index e = part.firstElement; e < part.firstElement + part.elementCount; ++e)
        nodes.insert(nodes.end(), mesh.hexahedra[std::size_t(e)].begin(),
                     mesh.hexahedra[std::size_t(e)].end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

/// Images of the nodes of a part among its own nodes.
void matchNodes(const Mesh& mesh, const MeshPart& part, double tolerance, MirrorMap& map)
{
    const std::vector<Index> nodes = nodesOf(mesh, part);
    NodeFinder finder(tolerance);
    for (const Index node : nodes) finder.add(node, mesh.points[std::size_t(node)]);
    for (const Index node : nodes) {
        const Index image = finder.at(map.plane.image(mesh.points[std::size_t(node)]));
        Index& known = map.node[std::size_t(node)];
        if (image < 0 || (known >= 0 && known != image)) {
            map.obstacle = format("{} of part {} has {} mirror image", placeText(mesh, node),
                                  part.name, image == -1 ? "no" : "more than one");
            return;
        }
        known = image;
    }
}

Hexahedron sorted(Hexahedron nodes)
{
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

struct HexahedronHash {
    std::size_t operator()(const Hexahedron& nodes) const
    {
        std::uint64_t sum = 0;
        for (const Index node : nodes)
            sum = (sum ^ std::uint64_t(node)) * 0x9e3779b97f4a7c15U + (sum >> 31);
        return sum;
    }
};

Hexahedron imageOf(const MirrorMap& map, const Hexahedron& nodes)
{
    Hexahedron out;
    for (std::size_t i = 0; i < 8; ++i) out[i] = map.node[std::size_t(nodes[i])];
    return out;
}

/// Whether the sides of `image` across direction `d` (0 xi, 1 eta, 2 zeta) are those of `nodes`.
bool sameDirection(const Hexahedron& nodes, const Hexahedron& image, std::size_t d)
{
    const auto ring = [&](const Hexahedron& from, std::size_t side) {
        std::array<Index, 4> out;
        for (std::size_t i = 0; i < 4; ++i) out[i] = from[std::size_t(sideCorners[side][i])];
        std::sort(out.begin(), out.end());
        return out;
    };
    const auto lower = ring(nodes, 2 * d);
    return lower == ring(image, 2 * d) || lower == ring(image, 2 * d + 1);
}

void matchElements(const Mesh& mesh, const MeshPart& part, ElementAxes axes, MirrorMap& map)
{
    std::unordered_map<Hexahedron, Index, HexahedronHash> numbers;
    const Index end = part.firstElement + part.elementCount;
    for (Index e = part.firstElement; e < end; ++e)
        numbers[sorted(mesh.hexahedra[std::size_t(e)])] = e;
    for (Index e = part.firstElement; e < end; ++e) {
        const Hexahedron nodes = imageOf(map, mesh.hexahedra[std::size_t(e)]);
        const auto image = numbers.find(sorted(nodes));
        if (image == numbers.end()) {
            map.obstacle = format("element {} of part {} has no mirror image", e, part.name);
            return;
        }
        map.element[std::size_t(e)] = image->second;
        const Hexahedron& other = mesh.hexahedra[std::size_t(image->second)];
        for (std::size_t d = 0; d < 3; ++d) {
            if (axes == ElementAxes::none || (axes == ElementAxes::zeta && d < 2)) continue;
            if (sameDirection(nodes, other, d)) continue;
            map.obstacle =
                format("element {} of part {} and its image have their {} axes in other "
                       "directions, and the part's rotation or hourglass form distinguishes them",
                       e, part.name,
                       d == 0   ? "xi"
                       : d == 1 ? "eta"
                                : "zeta");
            return;
        }
    }
}

/// Nodes on the plane, and elements that it passes through.
void findPlane(const Mesh& mesh, double tolerance, MirrorMap& map)
{
    const auto side = [&](Index node) {
        const double d = mesh.points[std::size_t(node)][map.plane.axis] - map.plane.place;
        return d > tolerance ? 1 : d < -tolerance ? -1 : 0;
    };
    for (std::size_t node = 0; node < mesh.points.size(); ++node)
        map.onPlane[node] = side(Index(node)) == 0;
    std::size_t cut = 0;
    for (const Hexahedron& nodes : mesh.hexahedra) {
        const auto [least, most] = std::minmax_element(
            nodes.begin(), nodes.end(), [&](Index a, Index b) { return side(a) < side(b); });
        cut += side(*least) < 0 && side(*most) > 0;
    }
    if (cut > 0)
        map.obstacle = format("the mesh is symmetric, but the plane passes through {} elements: an "
                              "even number of them across it can be cut",
                              cut);
}

} // namespace

std::string MirrorPlane::text() const
{
    return format("{} = {}", std::string(1, "xyz"[axis]), place == 0 ? 0.0 : place);
}

ElementSide MirrorMap::image(const Mesh& mesh, const ElementSide& side) const
{
    Quad nodes = mesh.sideNodes(side);
    for (Index& n : nodes) n = node[std::size_t(n)];
    std::sort(nodes.begin(), nodes.end());
    ElementSide out{element[std::size_t(side.element)], 0};
    for (; out.side < 6; ++out.side) {
        Quad candidate = mesh.sideNodes(out);
        std::sort(candidate.begin(), candidate.end());
        if (candidate == nodes) break;
    }
    return out;
}

double mirrorTolerance(const Mesh& mesh)
{
    Point low{0, 0, 0}, high{0, 0, 0};
    if (!mesh.points.empty()) low = high = mesh.points.front();
    for (const Point& p : mesh.points)
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    return 1e-9 * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

MirrorMap
mirrorMesh(const Mesh& mesh, const MirrorPlane& plane, const std::vector<ElementAxes>& axes)
{
    MirrorMap map{plane, "", {}, {}, {}};
    const double tolerance = mirrorTolerance(mesh);
    map.node.assign(mesh.points.size(), -1);
    map.element.assign(mesh.hexahedra.size(), -1);
    map.onPlane.assign(mesh.points.size(), false);
    for (const MeshPart& part : mesh.parts) {
        matchNodes(mesh, part, tolerance, map);
        if (!map.holds()) return map;
    }
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
        matchElements(mesh, mesh.parts[part], axes[part], map);
        if (!map.holds()) return map;
    }
    findPlane(mesh, tolerance, map);
    return map;
}

} // namespace fpm
