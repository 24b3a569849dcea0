#include "model/RigidSurface.h"

#include "model/PointAlgebra.h"

#include <limits>

namespace fpm {

double RigidSurface::gap(const Point& x, Point& normal) const
{
    Point r = difference(x, point);
    normal = axis;
    if (kind == Kind::plane) return dot(r, axis);
    if (kind == Kind::cylinder) {
        const double share = dot(r, axis);
        if (!infinite && (share < 0 || share > length))
            return std::numeric_limits<double>::infinity();
        r = along(r, -share, axis);
    }
    const double distance = fpm::length(r), sign = inside ? -1 : 1;
    if (distance > 0) normal = along({0, 0, 0}, sign / distance, r);
    return sign * (distance - radius);
}

} // namespace fpm
