#pragma once

#include "parallel/Vec3.h"

namespace fpm {

/// A target face seen from a contactor: corner positions minus the contactor's position.
template <class Work>
struct FaceCorners {
    Vec3<Work> corner[4];
};

template <class Work>
struct Projection {
    Work xi, eta;
    Vec3<Work> normal; ///< outward unit normal at (xi, eta)
    Vec3<Work> offset; ///< contactor minus point on the face
    Work gap;          ///< offset . normal, negative when penetrating
};

template <class Work>
FPM_KERNEL void shapeFunctions(Work xi, Work eta, Work (&n)[4])
{
    const Work q = Work(0.25);
    n[0] = q * (1 - xi) * (1 - eta);
    n[1] = q * (1 + xi) * (1 - eta);
    n[2] = q * (1 + xi) * (1 + eta);
    n[3] = q * (1 - xi) * (1 + eta);
}

/// Position and tangents of the bilinear face at (xi, eta); `offset` is contactor minus point.
template <class Work>
FPM_KERNEL void evaluateFace(const FaceCorners<Work>& face,
                             Work xi,
                             Work eta,
                             Vec3<Work>& offset,
                             Vec3<Work>& t1,
                             Vec3<Work>& t2)
{
    Work n[4];
    shapeFunctions(xi, eta, n);
    const Vec3<Work>* x = face.corner;
    offset = -(n[0] * x[0] + n[1] * x[1] + n[2] * x[2] + n[3] * x[3]);
    const Work q = Work(0.25);
    t1 = (q * (1 - eta)) * (x[1] - x[0]) + (q * (1 + eta)) * (x[2] - x[3]);
    t2 = (q * (1 - xi)) * (x[3] - x[0]) + (q * (1 + xi)) * (x[2] - x[1]);
}

/// One Newton step towards r . t1 = r . t2 = 0 (method of closest-point projection onto a bilinear
/// quadrilateral; curvature terms dropped where they make the matrix indefinite). Returns the size
/// of the step in natural coordinates, steps limited to 1; -1: no step, the face is degenerate
/// here.
template <class Work>
FPM_KERNEL Work projectionStep(const FaceCorners<Work>& face, Work& xi, Work& eta)
{
    Vec3<Work> r, t1, t2;
    evaluateFace(face, xi, eta, r, t1, t2);
    const Vec3<Work>* x = face.corner;
    const Vec3<Work> twist = Work(0.25) * ((x[0] - x[1]) + (x[2] - x[3]));
    const Work a = dot(t1, t1), c = dot(t2, t2), plain = dot(t1, t2), bend = dot(r, twist);
    Work b = plain - bend;
    Work determinant = a * c - b * b;
    if (!(determinant > Work(1e-3) * a * c)) {
        b = plain;
        determinant = a * c - b * b;
        if (!(determinant > Work(1e-12) * a * c)) return Work(-1);
    }
    const Work f = dot(r, t1), g = dot(r, t2);
    Work dXi = (f * c - g * b) / determinant, dEta = (g * a - f * b) / determinant;
    dXi = dXi > 1 ? Work(1) : (dXi < -1 ? Work(-1) : dXi);
    dEta = dEta > 1 ? Work(1) : (dEta < -1 ? Work(-1) : dEta);
    xi += dXi;
    eta += dEta;
    return (dXi < 0 ? -dXi : dXi) + (dEta < 0 ? -dEta : dEta);
}

/// Projection from a start value; (xi, eta) may end outside [-1, 1]. False where it did not
/// converge.
template <class Work>
FPM_KERNEL bool project(const FaceCorners<Work>& face, Work& xi, Work& eta)
{
    // The step after this one would be of the order of its square: rounding.
    const Work enough = sizeof(Work) == 8 ? Work(1e-7) : Work(1e-4);
    for (int iteration = 0; iteration < 10; ++iteration) {
        const Work step = projectionStep(face, xi, eta);
        if (step < 0) return false;
        if (step < enough) return true;
    }
    return false;
}

template <class Work>
FPM_KERNEL Work clampedUnit(Work value)
{
    return value > 1 ? Work(1) : (value < -1 ? Work(-1) : value);
}

/// Unit normal from the tangents at a point; that of the diagonals where the tangents are parallel,
/// as on the collapsed side of a wedge.
template <class Work>
FPM_KERNEL Vec3<Work>
faceNormal(const FaceCorners<Work>& face, const Vec3<Work>& t1, const Vec3<Work>& t2)
{
    Vec3<Work> n = cross(t1, t2);
    Work square = dot(n, n);
    if (!(square > Work(1e-8) * dot(t1, t1) * dot(t2, t2))) {
        n = cross(face.corner[2] - face.corner[0], face.corner[3] - face.corner[1]);
        square = dot(n, n);
    }
    return (square > 0 ? Work(1) / squareRoot(square) : Work(0)) * n;
}

/// Gap and normal at (xi, eta).
template <class Work>
FPM_KERNEL Projection<Work> gapAt(const FaceCorners<Work>& face, Work xi, Work eta)
{
    Projection<Work> out;
    out.xi = xi;
    out.eta = eta;
    Vec3<Work> t1, t2;
    evaluateFace(face, xi, eta, out.offset, t1, t2);
    out.normal = faceNormal(face, t1, t2);
    out.gap = dot(out.offset, out.normal);
    return out;
}

} // namespace fpm
