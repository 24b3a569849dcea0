#include "mesher/Placement.h"

#include "base/Format.h"
#include "mesher/Section.h"

#include <map>

namespace fpm {

Placement Placement::read(const Dictionary& entry)
{
    const std::map<std::string, int> axes{{"x", 0}, {"y", 1}, {"z", 2}};
    const std::map<std::string, int> sectors{{"quarter", 1}, {"half", 2}, {"full", 4}};
    constexpr int rightAngle = 90;

    Placement placement;
    placement.base = entry.vector("base");
    placement.axis = axes.at(entry.choiceOr("axis", "z", {"x", "y", "z"}));
    placement.quarters = sectors.at(entry.choiceOr("sector", "full", {"full", "half", "quarter"}));
    const auto angle = entry.integerOr("startAngle", 0, 0, 3 * rightAngle);
    if (angle % rightAngle != 0)
        entry.fail("startAngle", format("'startAngle' must be 0, 90, 180 or 270, found {}", angle));
    placement.turns = int(angle / rightAngle);
    return placement;
}

Point Placement::global(std::array<double, 2> section, double station) const
{
    const auto [x, y] = turned(section, turns);
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    Point place;
    place[first] = base[first] + x;
    place[second] = base[second] + y;
    place[axis] = station;
    return place;
}

std::string Placement::symmetryFace(bool second) const
{
    // Unturned, the plane y = 0 is normal to local y; every quarter turn swaps the two directions.
    const bool normalToY = second == (turns % 2 == 1);
    const int normal = (axis + (normalToY ? 2 : 1)) % 3;
    return std::string("sym") + "XYZ"[normal];
}

} // namespace fpm
