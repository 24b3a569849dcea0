#pragma once

#include "kernels/element/Modes.h"

namespace fpm {

/// Exact mean gradient of a hexahedron with bilinear faces (Flanagan and Belytschko 1981), the B of
/// eq. (6) of the paper, in mode space: B_iI = dV/dx_iI = (1/64) sum_m g[m]_i pattern_m(I), V =
/// volume64 / 64.
template <class T>
struct Gradient {
    Vec3<T> g[7]; ///< g[1..6]; g[0] unused, mode 7 has none
    T volume64;   ///< 64 V
};

template <class T>
FPM_KERNEL Gradient<T> meanGradient(const Modes<T>& x)
{
    const T third = T(ScalarOf<T>(1) / ScalarOf<T>(3));
    const Vec3<T>* a = x.mode;
    Gradient<T> out;
    Vec3<T>* g = out.g;
    g[1] = multiplyAdd(third, cross(a[4], a[6]), cross(a[2], a[3]));
    g[2] = multiplyAdd(third, cross(a[5], a[4]), cross(a[3], a[1]));
    g[3] = multiplyAdd(third, cross(a[6], a[5]), cross(a[1], a[2]));
    const Vec3<T> c25 = cross(a[2], a[5]), c53 = cross(a[5], a[3]);
    g[4] = third * (c25 + cross(a[6], a[1]));
    g[5] = third * (cross(a[4], a[2]) + cross(a[3], a[6]));
    g[6] = third * (c53 + cross(a[1], a[4]));
    // V is cubic in the modes: 3 V = sum_m a_m . dV/da_m, here without the repeated terms.
    out.volume64 = fusedMultiplyAdd(third, dot(a[4], c25) + dot(a[6], c53), dot(a[1], g[1]));
    return out;
}

/// sum_i B_iI B_iI (sum over corners too) times 512.
template <class T>
FPM_KERNEL T gradientSquare512(const Gradient<T>& b)
{
    T sum = dot(b.g[1], b.g[1]);
    for (int m = 2; m < 7; ++m) sum += dot(b.g[m], b.g[m]);
    return sum;
}

} // namespace fpm
