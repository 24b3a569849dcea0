#include "mesh/SharpEdges.h"

#include "mesh/Surface.h"
#include "mesh/Vector.h"

#include <algorithm>
#include <map>

namespace fpm {

namespace {

constexpr double cosine30 = 0.86602540378443865;

using Mirrors = std::vector<const std::vector<bool>*>;
using Ends = std::pair<Index, Index>;

/// A side at an edge: that of its corners with which the edge begins.
struct Adjacent {
    ElementSide side;
    Quad quad;
    std::size_t corner;
    bool own; ///< of the surface
};

Index at(const Adjacent& a, std::size_t further)
{
    return a.quad[(a.corner + further) % 4];
}

template <class Nodes>
bool isCut(const Nodes& nodes, const Mirrors& mirrors)
{
    return std::ranges::any_of(mirrors, [&](const std::vector<bool>* holds) {
        return std::ranges::all_of(nodes, [&](Index n) { return (*holds)[std::size_t(n)]; });
    });
}

Point areaVector(const Mesh& mesh, const Quad& quad)
{
    const auto x = [&](std::size_t k) { return mesh.points[std::size_t(quad[k])]; };
    return vector::cross(vector::difference(x(2), x(0)), vector::difference(x(3), x(1)));
}

/// The other side of the element at an edge of one of its sides.
Adjacent beyond(const Mesh& mesh, const Adjacent& from)
{
    for (Index side = 0; side < Index(sideCorners.size()); ++side) {
        if (side == from.side.side) continue;
        Adjacent other{{from.side.element, side}, {}, 0, false};
        other.quad = mesh.sideNodes(other.side);
        for (other.corner = 0; other.corner < 4; ++other.corner)
            if (at(other, 0) == at(from, 1) && at(other, 1) == at(from, 0)) return other;
    }
    return from;
}

/// Adds the edge between two sides, if it is one.
void addEdge(std::vector<SharpEdge>& edges,
             const Mesh& mesh,
             const Adjacent& first,
             const Adjacent& second)
{
    const Point n1 = areaVector(mesh, first.quad), n2 = areaVector(mesh, second.quad);
    const Point along = vector::difference(mesh.points[std::size_t(at(first, 1))],
                                           mesh.points[std::size_t(at(first, 0))]);
    const bool smooth = vector::dot(n1, n2) > cosine30 * vector::length(n1) * vector::length(n2);
    if (smooth || !(vector::dot(vector::cross(n1, n2), along) > 0)) return;
    SharpEdge edge{
        {at(first, 0), at(first, 1), at(first, 2), at(first, 3), at(second, 2), at(second, 3)}, {}};
    for (const Adjacent* each : {&first, &second})
        if (each->own) edge.sides.push_back(each->side);
    edges.push_back(std::move(edge));
}

/// Where more than two sides meet, those of one element belong together.
void addEdges(std::vector<SharpEdge>& edges, const Mesh& mesh, const std::vector<Adjacent>& sides)
{
    if (sides.size() == 2 && at(sides[0], 0) == at(sides[1], 1)) {
        addEdge(edges, mesh, sides[0], sides[1]);
        return;
    }
    for (std::size_t a = 0; a < sides.size(); ++a)
        for (std::size_t b = a + 1; b < sides.size(); ++b)
            if (sides[a].side.element == sides[b].side.element)
                addEdge(edges, mesh, sides[a], sides[b]);
}

} // namespace

std::vector<SharpEdge>
sharpEdges(const Mesh& mesh, std::span<const ElementSide> surface, const Mirrors& mirrors)
{
    std::map<Ends, std::vector<Adjacent>> around;
    for (const ElementSide& side : surface) {
        const Quad quad = mesh.sideNodes(side);
        if (isCut(quad, mirrors)) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            const Ends ends = std::minmax(Index(quad[k]), Index(quad[(k + 1) % 4]));
            if (ends.first != ends.second && !isCut(std::array{ends.first, ends.second}, mirrors))
                around[ends].push_back({side, quad, k, true});
        }
    }
    std::vector<ElementSide> borders;
    for (const auto& [ends, sides] : around)
        if (sides.size() == 1) borders.push_back(beyond(mesh, sides[0]).side);
    std::vector<ElementSide> inner = innerSides(mesh, borders);
    std::ranges::sort(inner);
    std::vector<SharpEdge> edges;
    for (auto& [ends, sides] : around) {
        if (sides.size() == 1) {
            const Adjacent other = beyond(mesh, sides[0]);
            if (std::ranges::binary_search(inner, other.side) || isCut(other.quad, mirrors))
                continue;
            sides.push_back(other);
        }
        addEdges(edges, mesh, sides);
    }
    return edges;
}

} // namespace fpm
