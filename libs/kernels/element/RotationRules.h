#pragma once

#include "kernels/element/Gradient.h"
#include "kernels/element/Rotation.h"
#include "kernels/material/MaterialConstants.h"

namespace fpm {

/// A rotation through a non-negative angle of at most pi.
template <class T>
struct Angle {
    T sine, cosine;
};

/// Half the sum of two angles, each at most a right angle.
template <class T>
FPM_KERNEL Angle<T> meanAngle(const Angle<T>& a, const Angle<T>& b)
{
    using Real = ScalarOf<T>;
    const T half = T(Real(0.5));
    const T sine = fusedMultiplyAdd(a.sine, b.cosine, a.cosine * b.sine);
    const T cosine = fusedMultiplyAdd(a.cosine, b.cosine, -(a.sine * b.sine));
    // cos(t/2) from cos t, sin(t/2) = sin t / 2 cos(t/2): small angles keep their digits.
    const T halfCosine = squareRoot(maximum(half + half * cosine, T(Real(1e-30))));
    return {half * sine / halfCosine, halfCosine};
}

/// Eqs. (4) and (5) of the paper as printed: the angles are arcsines of lengths of cross products,
/// the in-plane one their mean over the four corners. Kept as printed are the missing sign (the
/// reverse rotation is always about +n'': right for a body that turns clockwise, twice as wrong for
/// one that turns the other direction, spurious where a stretch turns corners to both sides), the
/// ambiguity beyond a right angle, and the cross products that are not projected into the middle
/// plane. Only the arithmetic differs: an arcsine is kept as its sine and non-negative cosine, and
/// the mean of four is formed exactly by half angles, twice. Returns R - I like midSurfaceRotation.
template <class T>
FPM_KERNEL Mat3<T> arcsineRotation(const Modes<T>& x, const Modes<T>& w)
{
    using Real = ScalarOf<T>;
    const T one = T(Real(1)), zero = T(Real(0));
    const SurfaceTilt<T> surface = surfaceTilt<true>(x, w);
    const Mat3<T>& tilt = surface.tilt;
    const Vec3<T>& n = surface.normal;
    const Vec3<T>*a = x.mode, *d = w.mode;
    const auto change = [&](int m) { return d[m] - tilt * (a[m] - d[m]); };
    const Vec3<T> c1 = change(1), c2 = change(2), c4 = change(4);
    Angle<T> angle[4];
    for (int i = 0; i < 4; ++i) {
        const T xi = T(Real(i == 0 || i == 3 ? -1 : 1)), eta = T(Real(i < 2 ? -1 : 1));
        const Vec3<T> now = xi * a[1] + eta * a[2] + (xi * eta) * a[4];
        const Vec3<T> moved = xi * c1 + eta * c2 + (xi * eta) * c4, before = now - moved;
        const Vec3<T> product = cross(now, moved); // before x now
        const T square = dot(product, product) / (dot(now, now) * dot(before, before));
        angle[i] = {squareRoot(square), squareRoot(maximum(one - square, zero))};
    }
    const Angle<T> mean = meanAngle(meanAngle(angle[0], angle[1]), meanAngle(angle[2], angle[3]));
    const T versine = mean.sine * mean.sine / (one + mean.cosine);
    const Mat3<T> turn = turnMatrix(versine * n, n, (-mean.sine) * n);
    return tilt + turn + turn * tilt;
}

/// Polar decomposition of the mean deformation gradient of the step, F = sum_I x_I b_I(start):
/// R <- (R + R^-T) / 2 from F (Higham 1986), written for K = R - I. Every iteration squares the
/// distance of the stretches from 1: four take 10 % to 1e-21.
template <class T>
FPM_KERNEL Mat3<T> polarRotation(const Modes<T>& x, const Modes<T>& w)
{
    using Real = ScalarOf<T>;
    const T zero = T(Real(0)), one = T(Real(1)), half = T(Real(0.5));
    Modes<T> start;
    for (int m = 1; m < 8; ++m) start.mode[m] = x.mode[m] - w.mode[m];
    const Gradient<T> b = meanGradient(start);
    Mat3<T> k{{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
    const T inverse = one / b.volume64;
    for (int m = 1; m < 7; ++m) addOuter(k, inverse * w.mode[m], b.g[m]);
    for (int iteration = 0; iteration < 4; ++iteration) {
        Mat3<T> r = k;
        r.x.x += one;
        r.y.y += one;
        r.z.z += one;
        const Mat3<T> cofactors{cross(r.y, r.z), cross(r.z, r.x), cross(r.x, r.y)};
        const T scale = -half / dot(r.x, cofactors.x);
        // R^-T - I = -R^-T K^T
        const Mat3<T> p = cofactors * transpose(k);
        k = {multiplyAdd(scale, p.x, half * k.x), multiplyAdd(scale, p.y, half * k.y),
             multiplyAdd(scale, p.z, half * k.z)};
    }
    return k;
}

/// Hughes and Winget (1980): the spin of the mid-step gradient, Q = (I - W/2)^-1 (I + W/2), and its
/// square root, both less I. Integrates the Jaumann rate.
template <class T>
struct SpinRotation {
    Mat3<T> whole, half;
};

/// `a`: the axis times tan(angle / 2), half the axial vector of the spin over the step.
template <class T>
FPM_KERNEL SpinRotation<T> spinRotation(const Vec3<T>& a)
{
    using Real = ScalarOf<T>;
    const T one = T(Real(1)), square = dot(a, a);
    const auto cayley = [&](const Vec3<T>& t, const T& tSquare) {
        const Vec3<T> scaled = (T(Real(2)) / (one + tSquare)) * t;
        return turnMatrix(scaled, t, scaled);
    };
    const T ratio = one / (one + squareRoot(one + square)); // tan of a quarter by tan of a half
    return {cayley(a, square), cayley(ratio * a, ratio * ratio * square)};
}

template <class T>
FPM_KERNEL SpinRotation<T> hughesWingetRotation(const Modes<T>& middle, const Modes<T>& w)
{
    using Real = ScalarOf<T>;
    const T zero = T(Real(0));
    const Gradient<T> b = meanGradient(middle);
    Vec3<T> a{zero, zero, zero};
    for (int m = 1; m < 7; ++m) a += cross(b.g[m], w.mode[m]);
    return spinRotation((T(Real(0.25)) / b.volume64) * a);
}

/// Removes the rotation from a step by the part's rule: `w` becomes the increment without rotation
/// (Hughes and Winget: with the spin, which causes no strain), in the axes of the end of the step,
/// and `middle` the geometry where the strain is measured. Returns R - I.
template <class T>
FPM_KERNEL Mat3<T> removeRotation(
    RotationRule rule, ScalarOf<T> strainPoint, const Modes<T>& x, Modes<T>& w, Modes<T>& middle)
{
    const T half = T(ScalarOf<T>(0.5));
    if (rule == RotationRule::hughesWinget) {
        for (int m = 1; m < 8; ++m) middle.mode[m] = multiplyAdd(-half, w.mode[m], x.mode[m]);
        const SpinRotation<T> spin = hughesWingetRotation(middle, w);
        for (int m = 1; m < 8; ++m) {
            w.mode[m] += spin.half * w.mode[m];
            middle.mode[m] += spin.half * middle.mode[m];
        }
        return spin.whole;
    }
    const Mat3<T> rotation = rule == RotationRule::polar     ? polarRotation(x, w)
                             : rule == RotationRule::arcsine ? arcsineRotation(x, w)
                                                             : midSurfaceRotation(x, w);
    for (int m = 1; m < 8; ++m) {
        w.mode[m] = w.mode[m] - rotation * (x.mode[m] - w.mode[m]);
        middle.mode[m] = multiplyAdd(T(-strainPoint), w.mode[m], x.mode[m]);
    }
    return rotation;
}

} // namespace fpm
