#pragma once

#include "parallel/Vec3.h"

namespace fpm {

/// The eight corner vectors of a hexahedron as sums over the Walsh-Hadamard sign patterns
/// 1, xi, eta, zeta, xi eta, eta zeta, zeta xi, xi eta zeta (in this order, not divided by 8).
/// Mode 0 (translation) drops out of everything; 4..7 are the hourglass modes.
template <class T>
struct Modes {
    Vec3<T> mode[8];
};

/// Sums the corner values c[0..7] (VTK order) over the sign patterns: out[0..7].
template <class T>
FPM_KERNEL void toModes(const T (&c)[8], T (&out)[8])
{
    const T s01 = c[1] + c[0], d01 = c[1] - c[0], s32 = c[2] + c[3], d32 = c[2] - c[3];
    const T s45 = c[5] + c[4], d45 = c[5] - c[4], s76 = c[6] + c[7], d76 = c[6] - c[7];
    const T lower = s32 + s01, lowerEta = s32 - s01, lowerXi = d32 + d01, lowerXiEta = d32 - d01;
    const T upper = s76 + s45, upperEta = s76 - s45, upperXi = d76 + d45, upperXiEta = d76 - d45;
    out[0] = upper + lower;
    out[1] = upperXi + lowerXi;
    out[2] = upperEta + lowerEta;
    out[3] = upper - lower;
    out[4] = upperXiEta + lowerXiEta;
    out[5] = upperEta - lowerEta;
    out[6] = upperXi - lowerXi;
    out[7] = upperXiEta - lowerXiEta;
}

/// Corner values of modes 1..7 (mode 0 taken as zero): c_I = sum_m pattern_m(I) modes[m].
template <class T>
FPM_KERNEL void toCorners(const T (&m)[8], T (&c)[8])
{
    const T lower = -m[3], upper = m[3], lowerEta = m[2] - m[5], upperEta = m[2] + m[5];
    const T lowerXiEta = m[4] - m[7], upperXiEta = m[4] + m[7];
    const T lowerXi = m[1] - m[6], upperXi = m[1] + m[6];
    const T s01 = lower - lowerEta, s32 = lower + lowerEta;
    const T d01 = lowerXi - lowerXiEta, d32 = lowerXi + lowerXiEta;
    const T s45 = upper - upperEta, s76 = upper + upperEta;
    const T d45 = upperXi - upperXiEta, d76 = upperXi + upperXiEta;
    c[0] = s01 - d01;
    c[1] = s01 + d01;
    c[2] = s32 + d32;
    c[3] = s32 - d32;
    c[4] = s45 - d45;
    c[5] = s45 + d45;
    c[6] = s76 + d76;
    c[7] = s76 - d76;
}

} // namespace fpm
