#include "mesh/Surface.h"

#include "mesh/Vector.h"

#include <algorithm>

namespace fpm {
namespace {

struct SideOfNodes {
    Quad nodes; ///< ascending: equal for the two elements that share the side
    ElementSide side;
    auto operator<=>(const SideOfNodes&) const = default;
};

/// Half the cross product of the diagonals: the side's area vector, outward.
Point areaVector(const Mesh& mesh, const ElementSide& side)
{
    const Quad nodes = mesh.sideNodes(side);
    const auto corner = [&](std::size_t k) { return mesh.points[std::size_t(nodes[k])]; };
    const Point first = vector::difference(corner(2), corner(0));
    const Point second = vector::difference(corner(3), corner(1));
    return vector::scaled(vector::cross(first, second), 0.5);
}

/// All sides of a part sorted by their lowest node (counting sort), for short searches below.
std::vector<SideOfNodes> sidesByLowestNode(const Mesh& mesh,
                                           const MeshPart& part,
                                           const std::vector<bool>& absent,
                                           std::vector<std::size_t>& starts)
{
    starts.assign(mesh.points.size() + 1, 0);
    std::vector<SideOfNodes> sides;
    sides.reserve(6 * std::size_t(part.elementCount));
    for (Index element = part.firstElement; element < part.firstElement + part.elementCount;
         ++element) {
        if (!absent.empty() && absent[std::size_t(element)]) continue;
        for (Index side = 0; side < 6; ++side) {
            Quad nodes = mesh.sideNodes({element, side});
            std::ranges::sort(nodes);
            sides.push_back({nodes, {element, side}});
            ++starts[std::size_t(nodes[0]) + 1];
        }
    }
    for (std::size_t node = 1; node < starts.size(); ++node) starts[node] += starts[node - 1];
    std::vector<SideOfNodes> sorted(sides.size());
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    for (const auto& side : sides) sorted[next[std::size_t(side.nodes[0])]++] = side;
    return sorted;
}

} // namespace

std::vector<ElementSide> skin(const Mesh& mesh, Index part, const std::vector<bool>& absent)
{
    std::vector<std::size_t> starts;
    auto sides = sidesByLowestNode(mesh, mesh.parts[std::size_t(part)], absent, starts);
    std::vector<ElementSide> outer;
    for (std::size_t node = 0; node + 1 < starts.size(); ++node) {
        const auto group = std::span(sides).subspan(starts[node], starts[node + 1] - starts[node]);
        std::ranges::sort(group);
        for (std::size_t k = 0; k < group.size(); ++k) {
            const bool before = k > 0 && group[k - 1].nodes == group[k].nodes;
            const bool after = k + 1 < group.size() && group[k + 1].nodes == group[k].nodes;
            if (!before && !after) outer.push_back(group[k].side);
        }
    }
    std::ranges::sort(outer);
    return outer;
}

std::vector<ElementSide> innerSides(const Mesh& mesh, std::span<const ElementSide> sides)
{
    std::vector<bool> marked(mesh.points.size(), false);
    std::vector<SideOfNodes> sorted;
    const auto quadOf = [&](const ElementSide& side) {
        Quad nodes = mesh.sideNodes(side);
        std::ranges::sort(nodes);
        return nodes;
    };
    for (const ElementSide& side : sides) {
        sorted.push_back({quadOf(side), side});
        for (const Index node : sorted.back().nodes) marked[std::size_t(node)] = true;
    }
    std::ranges::sort(sorted);
    std::vector<bool> inner(sorted.size(), false);
    for (Index element = 0; element < Index(mesh.hexahedra.size()); ++element)
        for (Index side = 0; side < 6; ++side) {
            const Quad corners = mesh.sideNodes({element, side});
            if (!std::ranges::all_of(corners, [&](Index n) { return marked[std::size_t(n)]; }))
                continue;
            const Quad nodes = quadOf({element, side});
            for (auto at = std::ranges::lower_bound(sorted, nodes, {}, &SideOfNodes::nodes);
                 at != sorted.end() && at->nodes == nodes; ++at)
                if (at->side.element != element) inner[std::size_t(at - sorted.begin())] = true;
        }
    std::vector<ElementSide> out;
    for (const ElementSide& side : sides) {
        const auto at = std::ranges::lower_bound(sorted, SideOfNodes{quadOf(side), side});
        if (inner[std::size_t(at - sorted.begin())]) out.push_back(side);
    }
    return out;
}

std::vector<Index> nodesOf(const Mesh& mesh, std::span<const ElementSide> sides)
{
    std::vector<Index> nodes;
    nodes.reserve(4 * sides.size());
    for (const auto& side : sides)
        for (const Index node : mesh.sideNodes(side)) nodes.push_back(node);
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

Point centre(const Mesh& mesh, const ElementSide& side)
{
    Point sum{};
    for (const Index node : mesh.sideNodes(side))
        sum = vector::sum(sum, mesh.points[std::size_t(node)]);
    return vector::scaled(sum, 0.25);
}

Point normal(const Mesh& mesh, const ElementSide& side)
{
    const Point outward = areaVector(mesh, side);
    const double length = vector::length(outward);
    return length > 0 ? vector::scaled(outward, 1 / length) : Point{};
}

double area(const Mesh& mesh, const ElementSide& side)
{
    return vector::length(areaVector(mesh, side));
}

} // namespace fpm
