#pragma once

#include "parallel/Math.h"

#include <cstdint>

namespace fpm {

/// Sine, and 1 - cosine, of an angle.
struct Turn {
    double sine, versine;
};

/// Of an angle in degrees, to 1e-16, the same bits everywhere: whole quarters are taken out exactly
/// and Taylor series serve the rest, at most pi/4, where they end below 1e-19.
FPM_KERNEL Turn turnBy(double degrees)
{
    const double quarters = degrees / 90;
    const std::int64_t whole = std::int64_t(quarters < 0 ? quarters - 0.5 : quarters + 0.5);
    const double rest = fusedMultiplyAdd(double(whole), -90.0, degrees);
    const double y = rest * 1.7453292519943295769e-2, z = y * y;
    double s = 0, c = 0; // sine / y - 1 and versine / (z / 2) - 1, last terms first
    for (int k = 18; k >= 2; k -= 2) {
        s = -(1 + s) * z / double(k * (k + 1));
        c = -(1 + c) * z / double((k + 1) * (k + 2));
    }
    const double sine = fusedMultiplyAdd(y, s, y), versine = 0.5 * fusedMultiplyAdd(z, c, z);
    switch (whole & 3) {
    case 0:
        return {sine, versine};
    case 1:
        return {1 - versine, 1 + sine};
    case 2:
        return {-sine, 2 - versine};
    default:
        return {versine - 1, 1 - sine};
    }
}

} // namespace fpm
