#pragma once

#include "kernels/element/Modes.h"

namespace fpm {

/// a b^T - (a . b) I + [s]x: with b = s and a = s / (1 + cos) the rotation, less I, about s, whose
/// length is the sine of its angle.
template <class T>
FPM_KERNEL Mat3<T> turnMatrix(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& s)
{
    return {{-fusedMultiplyAdd(a.y, b.y, a.z * b.z), fusedMultiplyAdd(a.x, b.y, -s.z),
             fusedMultiplyAdd(a.x, b.z, s.y)},
            {fusedMultiplyAdd(a.x, b.y, s.z), -fusedMultiplyAdd(a.x, b.x, a.z * b.z),
             fusedMultiplyAdd(a.y, b.z, -s.x)},
            {fusedMultiplyAdd(a.x, b.z, -s.y), fusedMultiplyAdd(a.y, b.z, s.x),
             -fusedMultiplyAdd(a.x, b.x, a.y * b.y)}};
}

/// Out-of-plane part of the middle surface's motion.
template <class T>
struct SurfaceTilt {
    Mat3<T> tilt;   ///< R - I about n x dn: takes the old normal to the new one
    Vec3<T> normal; ///< unit, at the end of the step
};

/// Out-of-plane rotation of the xi-eta middle surface, eq. (4) of the paper. `x`: modes at the end;
/// `w`: modes of the displacement increment. The normal of the middle surface is x1 x x2. With
/// `arcsine` the angle is the arcsine as printed, at most a right angle.
template <bool arcsine = false, class T>
FPM_KERNEL SurfaceTilt<T> surfaceTilt(const Modes<T>& x, const Modes<T>& w)
{
    const Vec3<T>*a = x.mode, *d = w.mode;
    const T one = T(ScalarOf<T>(1));
    const Vec3<T> n = cross(a[1], a[2]);
    const Vec3<T> dn = cross(d[1], a[2]) + cross(a[1], d[2]) - cross(d[1], d[2]);
    const Vec3<T> old = n - dn;
    const T inverse = one / squareRoot(dot(n, n));
    const T axisScale = inverse * (one / squareRoot(dot(old, old)));
    const Vec3<T> s = axisScale * cross(n, dn); // old normal x new normal = axis sin(theta)
    T cosine = axisScale * dot(n, old);
    if constexpr (arcsine) cosine = select(cosine < -cosine, -cosine, cosine);
    const Vec3<T> k = (one / (one + cosine)) * s;
    return {turnMatrix(k, s, s), inverse * n};
}

/// Rotation of the xi-eta middle surface over one step (the paper's fictitious reverse motion, eqs.
/// (4) and (5), in their signed, projected form): returns K = R - I, where R takes the start of the
/// step to its end. Everything is formed from the increments, never from differences of
/// coordinates, so that elements in float keep their stress. No trigonometry. The corners of the
/// surface are +-x1 +-x2 +-x4.
template <class T>
FPM_KERNEL Mat3<T> midSurfaceRotation(const Modes<T>& x, const Modes<T>& w)
{
    const Vec3<T>*a = x.mode, *d = w.mode;
    const T one = T(ScalarOf<T>(1));
    const SurfaceTilt<T> surface = surfaceTilt(x, w);
    const Mat3<T>& tilt = surface.tilt;
    const Vec3<T>& n = surface.normal;

    // In plane, eq. (5): least-squares angle between the tilted old corner vectors and the new
    // ones.
    T sine = T(ScalarOf<T>(0)), cosineSum = T(ScalarOf<T>(0));
    for (const int m : {1, 2, 4}) {
        const Vec3<T> before = a[m] - d[m];
        const Vec3<T> change = d[m] - tilt * before;
        const Vec3<T> tilted = a[m] - change;
        sine += dot(n, cross(a[m], change)); // tilted x a = (a - change) x a = a x change
        cosineSum += dot(tilted, a[m]);
        // x1 and x2 lie in the plane; the part of x4 along the normal (warp) has no angle.
        if (m == 4) cosineSum = fusedMultiplyAdd(-dot(n, tilted), dot(n, a[m]), cosineSum);
    }
    const T scale = one / squareRoot(fusedMultiplyAdd(sine, sine, cosineSum * cosineSum));
    sine = sine * scale;
    const T versine = sine * sine / (one + cosineSum * scale);
    const Mat3<T> turn = turnMatrix(versine * n, n, sine * n);
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
