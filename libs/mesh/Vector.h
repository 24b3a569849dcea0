#pragma once

#include "base/Types.h"

#include <cmath>

/// Arithmetic of points for this library's .cpp files.
namespace fpm::vector {

inline Point sum(const Point& a, const Point& b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point difference(const Point& a, const Point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point scaled(const Point& a, double factor)
{
    return {factor * a[0], factor * a[1], factor * a[2]};
}
inline double dot(const Point& a, const Point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point& a)
{
    return std::sqrt(dot(a, a));
}

} // namespace fpm::vector
