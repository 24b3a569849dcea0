#include "mesher/cylinderFaces.h"

#include <cmath>

namespace fpm {

unsigned bit(int face)
{
    return 1u << face;
}

int addSymmetryFaces(Shape& shape, const Placement& placement)
{
    const int first = int(shape.faces.size());
    if (placement.quarters < 4) shape.faces.push_back(placement.symmetryFace(false));
    if (placement.quarters == 1) shape.faces.push_back(placement.symmetryFace(true));
    return first;
}

unsigned symmetryBits(const std::array<double, 2>& at, int quarters, int firstFace)
{
    unsigned faces = 0;
    if (quarters < 4 && at[1] == 0) faces |= bit(firstFace);
    if (quarters == 1 && at[0] == 0) faces |= bit(firstFace + 1);
    return faces;
}

std::array<Point, 3> polarAxes(const Point& at)
{
    const double radius = std::hypot(at[0], at[1]);
    const double c = at[0] / radius, s = at[1] / radius;
    return {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
}

} // namespace fpm
