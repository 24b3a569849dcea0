#pragma once

#include "base/Format.h"
#include "mesh/Vector.h"

#include <string>

namespace fpm {

using vector::difference;
using vector::dot;
using vector::length;

/// origin + factor * direction
inline Point along(const Point& origin, double factor, const Point& direction)
{
    return vector::sum(origin, vector::scaled(direction, factor));
}

/// "(1 2.5 0)", 6 significant digits.
inline std::string pointText(const Point& a)
{
    return format("({} {} {})", a[0], a[1], a[2]);
}

} // namespace fpm
