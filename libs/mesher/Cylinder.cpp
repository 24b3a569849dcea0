#include "mesher/DiscNodes.h"
#include "mesher/Shape.h"
#include "mesher/Stations.h"
#include "mesher/cylinderFaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fpm {

namespace {

/// Inside the square blocks at the centre of the O-grid?
bool inCore(const Point& at)
{
    const double longer = std::max(std::abs(at[0]), std::abs(at[1]));
    const double shorter = std::min(std::abs(at[0]), std::abs(at[1]));
    return longer + shorter * (coreEdge - coreDiagonal) / coreDiagonal < coreEdge;
}

} // namespace

Shape readCylinder(const std::string& name, const Dictionary& entry, int refinement)
{
    const Placement placement = Placement::read(entry);
    const double radius = entry.number("radius", positive());
    const double height = entry.number("height", positive());
    const auto cells = [&](std::string_view key, int most) {
        return refined(entry, key, int(entry.integer(key, 1, most)), refinement, most);
    };
    const int core = cells("core", mostCellsAcross);
    const int rings = cells("rings", mostCellsAcross);
    const int axial = cells("axial", maxCellsInRow);
    const int quarters = placement.quarters;

    Shape shape;
    shape.name = name;
    shape.subject = entry.name();
    shape.section = discSection(core, rings, quarters);
    shape.layers = axial;
    shape.cellCount = std::int64_t(quarters) * axial * core * (core + 2 * rings);
    requireCountable(entry, "axial", shape.cellCount);
    shape.faces = {"bottom", "top", "outer"};
    shape.hasEnds = true;
    shape.roundVolume = std::numbers::pi / 4 * quarters * radius * radius * height;
    const int symmetry = addSymmetryFaces(shape, placement);

    const double base = placement.base[placement.axis];
    const auto heights = stations(base, base + height, axial);
    const DiscNodes nodes(core, rings);
    shape.place = [=](const Point& reference) {
        PlacedNode node;
        const int level = stationOf(reference[2], axial);
        if (level == 0) node.faces |= bit(face::bottom);
        if (level == axial) node.faces |= bit(face::top);

        const auto [at, onArc] = nodes.nearest(reference[0], reference[1]);
        if (onArc) node.faces |= bit(face::outer);
        node.faces |= symmetryBits(at, quarters, symmetry);
        node.position = placement.global({radius * at[0], radius * at[1]}, heights[level]);
        return node;
    };
    shape.axes = [](const Point& at) -> std::array<Point, 3> {
        if (inCore(at)) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        return polarAxes(at);
    };
    return shape;
}

} // namespace fpm
