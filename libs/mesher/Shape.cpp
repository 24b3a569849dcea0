#include "mesher/Shape.h"

#include "base/Error.h"
#include "base/Format.h"
#include "mesh/Patches.h"
#include "mesher/Gmsh.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

/// Corner of a hexahedron by the side of the centre it lies on: bits xi, eta, zeta positive.
constexpr std::array<int, 8> cornerAt{0, 1, 3, 2, 4, 5, 7, 6};

double dot(const Point& a, const Point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Numbers the corners so that xi, eta and zeta run along the given directions.
Hexahedron aligned(const Shape& shape, const Hexahedra& reference, const Hexahedron& cell)
{
    Point centre{};
    for (const Index node : cell)
        for (int k = 0; k < 3; ++k) centre[k] += reference.points[node][k] / 8;
    const auto axes = shape.axes(centre);

    Hexahedron ordered;
    ordered.fill(-1);
    for (const Index node : cell) {
        Point arm;
        for (int k = 0; k < 3; ++k) arm[k] = reference.points[node][k] - centre[k];
        int octant = 0;
        for (int k = 0; k < 3; ++k) octant |= int(dot(arm, axes[k]) > 0) << k;
        ordered[cornerAt[octant]] = node;
    }
    for (const Index node : ordered)
        if (node < 0)
            throw Error(ExitCode::mesh,
                        format("{}: gmsh made a twisted hexahedron", shape.subject));
    return ordered;
}

/// Sides of the cells whose four nodes lie on face `face`.
std::vector<ElementSide>
sidesOn(const std::vector<Hexahedron>& cells, const std::vector<PlacedNode>& nodes, int face)
{
    std::vector<ElementSide> sides;
    for (Index element = 0; element < Index(cells.size()); ++element)
        for (Index side = 0; side < 6; ++side) {
            unsigned shared = ~0u;
            for (const int corner : sideCorners[side])
                shared &= nodes[cells[element][corner]].faces;
            if (shared >> face & 1u) sides.push_back({element, side});
        }
    return sides;
}

} // namespace

Mesh meshShape(const Shape& shape, Log& log)
{
    const Hexahedra reference =
        extrude(shape.subject, shape.section, shape.layers, shape.cellCount, log);

    std::vector<PlacedNode> nodes;
    nodes.reserve(reference.points.size());
    for (const Point& point : reference.points) nodes.push_back(shape.place(point));

    Mesh mesh;
    for (const PlacedNode& node : nodes) mesh.points.push_back(node.position);
    for (const Hexahedron& cell : reference.cells)
        mesh.hexahedra.push_back(aligned(shape, reference, cell));
    mesh.parts.push_back({shape.name, 0, Index(mesh.hexahedra.size())});

    for (int face = 0; face < int(shape.faces.size()); ++face)
        mesh.sideSets[shape.name + "." + shape.faces[face]] = sidesOn(mesh.hexahedra, nodes, face);
    if (shape.hasEnds) {
        auto ends = mesh.sideSets.at(shape.name + ".bottom");
        const auto& top = mesh.sideSets.at(shape.name + ".top");
        ends.insert(ends.end(), top.begin(), top.end());
        std::sort(ends.begin(), ends.end());
        mesh.sideSets[shape.name + ".ends"] = std::move(ends);
    }
    return mesh;
}

std::array<int, 3> readCells(const Dictionary& entry, std::string_view key)
{
    const Point values = entry.vector(key);
    std::array<int, 3> cells;
    for (int k = 0; k < 3; ++k) {
        if (!(values[k] >= 1 && values[k] <= maxCellsInRow) || values[k] != std::floor(values[k]))
            entry.fail(key, format("'{}' must be three integers between 1 and {}, found {}", key,
                                   maxCellsInRow, values[k]));
        cells[k] = int(values[k]);
    }
    return cells;
}

int refined(const Dictionary& entry, std::string_view key, int cells, int refinement, int most)
{
    const std::int64_t count = std::int64_t(cells) * refinement;
    if (count > most)
        entry.fail(key,
                   format("{} cells times refinement {} are more than {}", cells, refinement, most),
                   "use fewer cells or less refinement");
    return int(count);
}

void requireCountable(const Dictionary& entry, std::string_view key, std::int64_t cells)
{
    constexpr std::int64_t most = maxElements;
    if (cells > most)
        entry.fail(key, format("{} elements in one entry; at most {} can be numbered", cells, most),
                   "use fewer cells");
}

} // namespace fpm
