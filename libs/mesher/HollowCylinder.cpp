#include "base/Format.h"
#include "mesher/Shape.h"
#include "mesher/Stations.h"
#include "mesher/cylinderFaces.h"

#include <cmath>
#include <numbers>

namespace fpm {

namespace {

/// Step of the angle of (x, y) among `steps` equal steps over `quarters` quarter turns.
int angleStep(double x, double y, int steps, int quarters)
{
    constexpr double turn = 2 * std::numbers::pi;
    double angle = std::atan2(y, x);
    if (angle < -turn / (8.0 * steps)) angle += turn; // slightly below the x axis is on it
    const int step = stationOf(angle / (turn / 4 * quarters), steps);
    return quarters == 4 ? step % steps : step;
}

} // namespace

Shape readHollowCylinder(const std::string& name, const Dictionary& entry, int refinement)
{
    const Placement placement = Placement::read(entry);
    const double innerRadius = entry.number("innerRadius", positive());
    const double outerRadius = entry.number("outerRadius", positive());
    if (!(innerRadius < outerRadius))
        entry.fail("innerRadius",
                   format("'innerRadius' must be smaller than outerRadius {}, found {}",
                          outerRadius, innerRadius));
    const double height = entry.number("height", positive());
    const int quarters = placement.quarters;
    const int fewest = quarters == 4 ? 3 : quarters; // no cell may span half a turn
    const auto cells = [&](std::string_view key, int least, int most) {
        return refined(entry, key, int(entry.integer(key, least, most)), refinement, most);
    };
    const int around = cells("circumferential", fewest, maxCellsInRow);
    const int radial = cells("radial", 1, mostCellsAcross);
    const int axial = cells("axial", 1, maxCellsInRow);

    Shape shape;
    shape.name = name;
    shape.subject = entry.name();
    shape.section = ringSection(around, radial, quarters);
    shape.layers = axial;
    shape.cellCount = std::int64_t(around) * radial * axial;
    requireCountable(entry, "circumferential", shape.cellCount);
    shape.faces = {"bottom", "top", "outer", "inner"};
    shape.hasEnds = true;
    shape.roundVolume = std::numbers::pi / 4 * quarters * height
                        * (outerRadius * outerRadius - innerRadius * innerRadius);
    const int symmetry = addSymmetryFaces(shape, placement);

    const double base = placement.base[placement.axis];
    const auto heights = stations(base, base + height, axial);
    const auto radii = stations(innerRadius, outerRadius, radial);
    shape.place = [=](const Point& reference) {
        PlacedNode node;
        const int level = stationOf(reference[2], axial);
        const int ring = stationOf(std::hypot(reference[0], reference[1]) - 1, radial);
        const int step = angleStep(reference[0], reference[1], around, quarters);
        const auto [x, y] = direction(step, around, quarters);
        if (level == 0) node.faces |= bit(face::bottom);
        if (level == axial) node.faces |= bit(face::top);
        if (ring == radial) node.faces |= bit(face::outer);
        if (ring == 0) node.faces |= bit(face::inner);
        node.faces |= symmetryBits({x, y}, quarters, symmetry);
        node.position = placement.global({radii[ring] * x, radii[ring] * y}, heights[level]);
        return node;
    };
    shape.axes = [](const Point& at) -> std::array<Point, 3> {
        const auto [outward, tangent, along] = polarAxes(at);
        return {tangent, along, outward};
    };
    return shape;
}

} // namespace fpm
