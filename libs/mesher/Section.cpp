#include "mesher/Section.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace fpm {

int Section::addPoint(std::array<double, 2> point)
{
    points.push_back(point);
    return int(points.size()) - 1;
}

int Section::addCurve(int from, int to, int cells, bool arc)
{
    curves.push_back({from, to, cells, arc});
    return int(curves.size());
}

std::array<double, 2> turned(std::array<double, 2> point, int quarters)
{
    for (int turn = 0; turn < quarters % 4; ++turn) point = {-point[1], point[0]};
    return {point[0] + 0.0, point[1] + 0.0}; // no negative zeros
}

std::array<double, 2> direction(int step, int steps, int quarters)
{
    const std::int64_t turns = std::int64_t(step) * quarters;
    const int whole = int(turns / steps);
    const std::int64_t rest = turns % steps;
    // Both halves of a quarter from the same angles below 45 degrees: mirrored nodes are equal.
    const auto angle = [&](std::int64_t part) {
        return 0.5 * std::numbers::pi * double(part) / double(steps);
    };
    if (2 * rest == steps) {
        const double half = std::sqrt(0.5);
        return turned({half, half}, whole);
    }
    if (2 * rest < steps) return turned({std::cos(angle(rest)), std::sin(angle(rest))}, whole);
    return turned({std::sin(angle(steps - rest)), std::cos(angle(steps - rest))}, whole);
}

Section squareSection(int cellsX, int cellsY)
{
    Section section;
    section.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    section.blocks.push_back({section.addCurve(0, 1, cellsX), section.addCurve(1, 2, cellsY),
                              section.addCurve(2, 3, cellsX), section.addCurve(3, 0, cellsY)});
    return section;
}

Section discSection(int core, int rings, int quarters)
{
    const int axes = quarters == 4 ? 4 : quarters + 1;
    Section section;
    const int centre = section.addPoint({0, 0});
    std::vector<int> edge, rim, inner, outer; // points on an axis; curves along it
    for (int axis = 0; axis < axes; ++axis) {
        edge.push_back(section.addPoint(turned({coreEdge, 0}, axis)));
        rim.push_back(section.addPoint(turned({1, 0}, axis)));
        inner.push_back(section.addCurve(centre, edge[axis], core));
        outer.push_back(section.addCurve(edge[axis], rim[axis], rings));
    }
    for (int quarter = 0; quarter < quarters; ++quarter) {
        const int next = (quarter + 1) % axes;
        const int corner = section.addPoint(turned({coreDiagonal, coreDiagonal}, quarter));
        const int rimCorner = section.addPoint(turned(direction(1, 2, 1), quarter));
        const int firstSide = section.addCurve(edge[quarter], corner, core);
        const int secondSide = section.addCurve(corner, edge[next], core);
        const int diagonal = section.addCurve(corner, rimCorner, rings);
        const int firstArc = section.addCurve(rim[quarter], rimCorner, core, true);
        const int secondArc = section.addCurve(rimCorner, rim[next], core, true);
        section.blocks.push_back({inner[quarter], firstSide, secondSide, -inner[next]});
        section.blocks.push_back({outer[quarter], firstArc, -diagonal, -firstSide});
        section.blocks.push_back({diagonal, secondArc, -outer[next], -secondSide});
    }
    return section;
}

Section ringSection(int circumferential, int radial, int quarters)
{
    // An arc must stay below half a turn: four blocks, or one a cell where there are fewer.
    const int blocks = std::min(circumferential, quarters == 4 ? 4 : quarters);
    const bool closed = quarters == 4;
    const int rays = closed ? blocks : blocks + 1;
    const auto step = [&](int ray) { return int(std::int64_t(ray) * circumferential / blocks); };

    Section section;
    std::vector<int> inside, outside, across;
    for (int ray = 0; ray < rays; ++ray) {
        const auto [x, y] = direction(step(ray), circumferential, quarters);
        inside.push_back(section.addPoint({x, y}));
        outside.push_back(section.addPoint({2 * x, 2 * y}));
        across.push_back(section.addCurve(inside[ray], outside[ray], radial));
    }
    for (int block = 0; block < blocks; ++block) {
        const int next = (block + 1) % rays;
        const int cells = step(block + 1) - step(block);
        const int innerArc = section.addCurve(inside[block], inside[next], cells, true);
        const int outerArc = section.addCurve(outside[block], outside[next], cells, true);
        section.blocks.push_back({across[block], outerArc, -across[next], -innerArc});
    }
    return section;
}

} // namespace fpm
