#pragma once

#include "kernels/element/Modes.h"

namespace fpm {

/// Rotation of the xi-eta middle surface over one step (the paper's fictitious reverse motion, eqs.
/// 4-5, in its signed, projected form): returns K = R - I, where R takes the start of the step to
/// its end. `x`: modes at the end; `w`: modes of the displacement increment. Everything is formed
/// from the increments, never from differences of coordinates: float elements keep their stress.
/// No trigonometry. The middle surface's normal is x1 x x2, its corners are +-x1 +-x2 +-x4.
template <class T>
FPM_KERNEL Mat3<T> midSurfaceRotation(const Modes<T>& x, const Modes<T>& w)
{
    const Vec3<T>*a = x.mode, *d = w.mode;
    const T one = T(ScalarOf<T>(1));

    // Out of plane: the rotation about n x dn that takes the old normal to the new one.
    Vec3<T> n = cross(a[1], a[2]);
    const Vec3<T> dn = cross(d[1], a[2]) + cross(a[1], d[2]) - cross(d[1], d[2]);
    const Vec3<T> old = n - dn;
    const T inverse = one / squareRoot(dot(n, n));
    const T axisScale = inverse * (one / squareRoot(dot(old, old)));
    const Vec3<T> s = axisScale * cross(n, dn); // old normal x new normal = axis sin(theta)
    const T cosine = axisScale * dot(n, old);
    const Vec3<T> k = (one / (one + cosine)) * s;
    const Mat3<T> tilt{{-fusedMultiplyAdd(k.y, s.y, k.z * s.z), fusedMultiplyAdd(k.x, s.y, -s.z),
                        fusedMultiplyAdd(k.x, s.z, s.y)},
                       {fusedMultiplyAdd(k.x, s.y, s.z), -fusedMultiplyAdd(k.x, s.x, k.z * s.z),
                        fusedMultiplyAdd(k.y, s.z, -s.x)},
                       {fusedMultiplyAdd(k.x, s.z, -s.y), fusedMultiplyAdd(k.y, s.z, s.x),
                        -fusedMultiplyAdd(k.x, s.x, k.y * s.y)}};
    n = inverse * n;

    // In plane: least-squares angle between the tilted old corner vectors and the new ones.
    T sine = T(ScalarOf<T>(0)), cosineSum = T(ScalarOf<T>(0));
    for (const int m : {1, 2, 4}) {
        const Vec3<T> before = a[m] - d[m];
        const Vec3<T> change = d[m] - tilt * before;
        const Vec3<T> tilted = a[m] - change;
        sine += dot(n, cross(a[m], change)); // tilted x a = (a - change) x a = a x change
        cosineSum += dot(tilted, a[m]);
        // x1 and x2 lie in the plane; the part of x4 along the normal (warp) tells no angle.
        if (m == 4) cosineSum = fusedMultiplyAdd(-dot(n, tilted), dot(n, a[m]), cosineSum);
    }
    const T scale = one / squareRoot(fusedMultiplyAdd(sine, sine, cosineSum * cosineSum));
    sine = sine * scale;
    const T versine = sine * sine / (one + cosineSum * scale);
    const Vec3<T> v = versine * n, sn = sine * n;
    const Mat3<T> turn{{-fusedMultiplyAdd(v.y, n.y, v.z * n.z), fusedMultiplyAdd(v.x, n.y, -sn.z),
                        fusedMultiplyAdd(v.x, n.z, sn.y)},
                       {fusedMultiplyAdd(v.x, n.y, sn.z), -fusedMultiplyAdd(v.x, n.x, v.z * n.z),
                        fusedMultiplyAdd(v.y, n.z, -sn.x)},
                       {fusedMultiplyAdd(v.x, n.z, -sn.y), fusedMultiplyAdd(v.y, n.z, sn.x),
                        -fusedMultiplyAdd(v.x, n.x, v.y * n.y)}};
    return tilt + turn + turn * tilt;
}

/// K s + (K s)^T + K s K^T + s: the tensor rotated by I + K without forming I + K.
template <class T>
FPM_KERNEL Sym3<T> rotated(const Mat3<T>& k, const Sym3<T>& s)
{
    const Mat3<T> p = k * matrix(s);
    return {s.xx + (p.x.x + p.x.x + dot(p.x, k.x)), s.yy + (p.y.y + p.y.y + dot(p.y, k.y)),
            s.zz + (p.z.z + p.z.z + dot(p.z, k.z)), s.xy + (p.x.y + p.y.x + dot(p.x, k.y)),
            s.yz + (p.y.z + p.z.y + dot(p.y, k.z)), s.zx + (p.x.z + p.z.x + dot(p.x, k.z))};
}

} // namespace fpm
