#pragma once

#include "parallel/Vec3.h"

#include <cmath>

namespace fpm::test {

inline double size(const Vec3<double>& v)
{
    return std::sqrt(dot(v, v));
}

/// Rotation about an axis by an angle (Rodrigues).
inline Vec3<double> rotated(const Vec3<double>& v, const Vec3<double>& axis, double angle)
{
    const Vec3<double> a = (1 / size(axis)) * axis;
    return std::cos(angle) * v + std::sin(angle) * cross(a, v)
           + ((1 - std::cos(angle)) * dot(a, v)) * a;
}

} // namespace fpm::test
