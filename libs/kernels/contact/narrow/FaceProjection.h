#pragma once

#include "kernels/contact/narrow/Tolerances.h"
#include "parallel/Vec3.h"

namespace fpm {

/// Target face relative to a contactor: corner positions minus the contactor's position.
template <class T>
struct FaceCorners {
    Vec3<T> corner[4];
};

template <class T>
struct Projection {
    T xi, eta;
    Vec3<T> normal; ///< outward unit normal at (xi, eta)
    Vec3<T> offset; ///< contactor minus point on the face
    T gap;          ///< normal gap, offset . normal: negative when penetrating
};

template <class T>
FPM_KERNEL void shapeFunctions(T xi, T eta, T (&n)[4])
{
    const T q = T(0.25);
    n[0] = q * (1 - xi) * (1 - eta);
    n[1] = q * (1 + xi) * (1 - eta);
    n[2] = q * (1 + xi) * (1 + eta);
    n[3] = q * (1 - xi) * (1 + eta);
}

template <class T>
FPM_KERNEL T squareOfDiagonal(const FaceCorners<T>& face)
{
    const Vec3<T> diagonal = face.corner[2] - face.corner[0];
    return dot(diagonal, diagonal);
}

/// Position and tangents of the bilinear face at (xi, eta); `offset` is contactor minus point.
template <class T>
FPM_KERNEL void
evaluateFace(const FaceCorners<T>& face, T xi, T eta, Vec3<T>& offset, Vec3<T>& t1, Vec3<T>& t2)
{
    T n[4];
    shapeFunctions(xi, eta, n);
    const Vec3<T>* x = face.corner;
    offset = -(n[0] * x[0] + n[1] * x[1] + n[2] * x[2] + n[3] * x[3]);
    const T q = T(0.25);
    t1 = (q * (1 - eta)) * (x[1] - x[0]) + (q * (1 + eta)) * (x[2] - x[3]);
    t2 = (q * (1 - xi)) * (x[3] - x[0]) + (q * (1 + xi)) * (x[2] - x[1]);
}

template <class T>
FPM_KERNEL Vec3<T> offsetOn(const FaceCorners<T>& face, T xi, T eta)
{
    Vec3<T> offset, t1, t2;
    evaluateFace(face, xi, eta, offset, t1, t2);
    return offset;
}

/// One Newton step of the closest-point projection onto a bilinear quadrilateral, r . t1 = r . t2 =
/// 0 (curvature terms are dropped where they make the matrix indefinite), at most 1 in each natural
/// coordinate. `size`: length of the step. Returns the lanes where a step exists: those whose face
/// is not degenerate. All lanes of T are computed together, here and below.
template <class T>
FPM_KERNEL MaskOf<T> projectionStep(const FaceCorners<T>& face, T& xi, T& eta, T& size)
{
    Vec3<T> r, t1, t2;
    evaluateFace(face, xi, eta, r, t1, t2);
    const Vec3<T>* x = face.corner;
    const Vec3<T> twist = T(0.25) * ((x[0] - x[1]) + (x[2] - x[3]));
    const T a = dot(t1, t1), c = dot(t2, t2), plain = dot(t1, t2), bend = dot(r, twist), one = T(1);
    T b = plain - bend;
    T determinant = a * c - b * b;
    const MaskOf<T> definite = determinant > T(1e-3) * a * c;
    b = select(definite, b, plain);
    determinant = select(definite, determinant, a * c - plain * plain);
    const MaskOf<T> regular = definite | (determinant > T(1e-12) * a * c);
    const T f = dot(r, t1), g = dot(r, t2);
    T dXi = (f * c - g * b) / determinant, dEta = (g * a - f * b) / determinant;
    dXi = select(dXi > one, one, select(dXi < -one, -one, dXi));
    dEta = select(dEta > one, one, select(dEta < -one, -one, dEta));
    xi = select(regular, xi + dXi, xi);
    eta = select(regular, eta + dEta, eta);
    size = magnitude(dXi) + magnitude(dEta);
    return regular;
}

/// Closest-point projection from a start value in the lanes of `wanted`; (xi, eta) may end outside
/// [-1, 1]. Returns the lanes that converged.
template <class T>
FPM_KERNEL MaskOf<T> projectWhere(MaskOf<T> wanted, const FaceCorners<T>& face, T& xi, T& eta)
{
    const T enough = T(ContactTolerances<ScalarOf<T>>::projected);
    MaskOf<T> found = wanted & !wanted, going = wanted;
    for (int iteration = 0; iteration < 10 && NumberTraits<T>::any(going); ++iteration) {
        T nextXi = xi, nextEta = eta, size;
        const MaskOf<T> regular = projectionStep(face, nextXi, nextEta, size);
        xi = select(going, nextXi, xi);
        eta = select(going, nextEta, eta);
        const MaskOf<T> close = size < enough;
        found = found | (going & regular & close);
        going = going & regular & !close;
    }
    return found;
}
template <class Work>
FPM_KERNEL bool project(const FaceCorners<Work>& face, Work& xi, Work& eta)
{
    return projectWhere(true, face, xi, eta);
}

/// Natural coordinate clamped to the face; values within the border width of it are placed on it.
template <class T>
FPM_KERNEL T clampedUnit(T value)
{
    const T one = T(1), inner = one - T(ContactTolerances<ScalarOf<T>>::border);
    return select(value > inner, one, select(value < -inner, -one, value));
}
/// Condition of eq. (14) of the paper: the projection point lies inside the face, borders included.
template <class T>
FPM_KERNEL MaskOf<T> isInside(T xi, T eta)
{
    const T border = T(1) + T(ContactTolerances<ScalarOf<T>>::border);
    return (magnitude(xi) < border) & (magnitude(eta) < border);
}

/// Unit normal from the tangents at a point; from the diagonals where the tangents are parallel, as
/// on the collapsed side of a wedge.
template <class T>
FPM_KERNEL Vec3<T> faceNormal(const FaceCorners<T>& face, const Vec3<T>& t1, const Vec3<T>& t2)
{
    Vec3<T> n = cross(t1, t2);
    T square = dot(n, n);
    const MaskOf<T> flat = !(square > T(1e-8) * dot(t1, t1) * dot(t2, t2));
    if (NumberTraits<T>::any(flat)) {
        const Vec3<T> d = cross(face.corner[2] - face.corner[0], face.corner[3] - face.corner[1]);
        n = {select(flat, d.x, n.x), select(flat, d.y, n.y), select(flat, d.z, n.z)};
        square = dot(n, n);
    }
    const T zero = T(0), scale = select(square > zero, T(1) / squareRoot(square), zero);
    return scale * n;
}

/// Normal gap at (xi, eta), eq. (15) of the paper, with the gap vector from the projection point
/// instead of the closest particle, and the normal there.
template <class T>
FPM_KERNEL Projection<T> gapAt(const FaceCorners<T>& face, T xi, T eta)
{
    Projection<T> out;
    out.xi = xi;
    out.eta = eta;
    Vec3<T> t1, t2;
    evaluateFace(face, xi, eta, out.offset, t1, t2);
    out.normal = faceNormal(face, t1, t2);
    out.gap = dot(out.offset, out.normal);
    return out;
}

/// Gap at the closest point of the face. On a border, which several faces share, the normal is the
/// direction to the contactor and hence the same for all of them: a contactor on a symmetry plane,
/// equally near to the faces on both sides, is pushed along that plane.
template <class T>
FPM_KERNEL Projection<T> gapAtClosest(const FaceCorners<T>& face, T xi, T eta)
{
    Projection<T> out = gapAt(face, xi, eta);
    const T one = T(1), square = dot(out.offset, out.offset);
    const MaskOf<T> inner = (magnitude(xi) < one) & (magnitude(eta) < one),
                    line = (square > T(ContactTolerances<ScalarOf<T>>::noDirection)
                                         * squareOfDiagonal(face))
                           & !inner;
    if (!NumberTraits<T>::any(line)) return out;
    const T distance = squareRoot(square), gap = select(out.gap < T(0), -distance, distance);
    const Vec3<T> n = (one / gap) * out.offset;
    out.normal = {select(line, n.x, out.normal.x), select(line, n.y, out.normal.y),
                  select(line, n.z, out.normal.z)};
    out.gap = select(line, gap, out.gap);
    return out;
}

} // namespace fpm
