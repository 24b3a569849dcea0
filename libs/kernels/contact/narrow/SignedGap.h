#pragma once

#include "kernels/contact/ContactPassView.h"
#include "kernels/contact/narrow/ClosestPoint.h"

namespace fpm {

/// Arc cosine to 2e-8 (double) from + - * and a root, with equal bits on all backends (Abramowitz
/// and Stegun 4.4.46).
template <class Work>
FPM_KERNEL Work arcCosine(Work cosine)
{
    const Work c = cosine > 1 ? Work(1) : cosine < -1 ? Work(-1) : cosine, x = c < 0 ? -c : c;
    Work p = Work(-0.0012624911);
    p = fusedMultiplyAdd(p, x, Work(0.0066700901));
    p = fusedMultiplyAdd(p, x, Work(-0.0170881256));
    p = fusedMultiplyAdd(p, x, Work(0.0308918810));
    p = fusedMultiplyAdd(p, x, Work(-0.0501743046));
    p = fusedMultiplyAdd(p, x, Work(0.0889789874));
    p = fusedMultiplyAdd(p, x, Work(-0.2145988016));
    p = fusedMultiplyAdd(p, x, Work(1.5707963050));
    p = p * squareRoot(1 - x);
    return c < 0 ? Work(3.14159265358979324) - p : p;
}

/// Whether a face does not oppose the contactor: normals of surfaces in contact point against each
/// other, n . n_c < 0. False where the contactor has no mean normal.
template <class Numbers>
FPM_KERNEL bool isNotOpposing(const ContactPassView<Numbers>& pass,
                              Index contactor,
                              const Vec3<typename Numbers::Work>& normal)
{
    const auto own = pass.ownNormalOf(contactor);
    using Work = typename Numbers::Work;
    return dot(own, own) > 0 && !(dot(normal, own) < ContactTolerances<Work>::opposing);
}

/// Signed distance to the surface at the closest point of one face. Inside the face it is measured
/// along the normal, eq. (15) of the paper. On an edge or corner the angle-weighted pseudo-normal
/// gives the sign (Baerentzen and Aanaes 2005) and the gap is the distance itself, with the
/// direction to the closest point as normal: the force is the gradient of k gap^2 / 2 there too.
/// For a contactor the surface ends at its free edges and where its faces no longer oppose it.
template <class Numbers>
struct SignedGap {
    using Work = typename Numbers::Work;
    const ContactPassView<Numbers>& pass;
    Index contactor;

    FPM_KERNEL FaceCorners<Work> corners(Index face) const
    {
        return pass.corners(face, pass.contactor[contactor]);
    }

    /// `beyond`: receives whether the contactor lies off the surface, over a free edge.
    FPM_KERNEL Projection<Work>
    at(Index face, const FaceCorners<Work>& here, const FacePoint<Work>& point, bool& beyond) const
    {
        beyond = false;
        if (point.where == insideFace) return gapAtClosest(here, point.xi, point.eta);
        Projection<Work> out = gapAt(here, point.xi, point.eta);
        Vec3<Work> pseudo = out.normal;
        if (point.where < firstCorner)
            edge(face, here, point, out.offset, pseudo, beyond);
        else
            pseudo = fan(face, point.where - firstCorner, out.offset, beyond);
        const Work weight = dot(pseudo, pseudo);
        if (!(weight > 0)) return out;
        const Work square = dot(out.offset, out.offset);
        if (square > ContactTolerances<Work>::noDirection * squareOfDiagonal(here)) {
            const Work distance = squareRoot(square);
            out.gap = dot(out.offset, pseudo) < 0 ? -distance : distance;
            out.normal = (Work(1) / out.gap) * out.offset;
        } else { // the direction of the offset would be rounding
            out.normal = (Work(1) / squareRoot(weight)) * pseudo;
            out.gap = dot(out.offset, out.normal);
        }
        return out;
    }

private:
    /// Sum of the normals of the two faces at a point of their common edge.
    FPM_KERNEL void edge(Index face,
                         const FaceCorners<Work>& here,
                         const FacePoint<Work>& point,
                         Vec3<Work>& offset,
                         Vec3<Work>& pseudo,
                         bool& beyond) const
    {
        const Index across = pass.neighbour[4 * std::size_t(face) + std::size_t(point.where)];
        if (across <= noEdge) return;
        if (across < 0) {
            beyond = trim(here, point.where, pseudo, offset);
            return;
        }
        const FaceCorners<Work> other = corners(across / 4);
        Work xi, eta;
        edgePoint(across & 3, shareAlong(point.where, -point.xi, -point.eta), xi,
                  eta); // the edge runs in the opposite direction there
        const Vec3<Work> normal = gapAt(other, xi, eta).normal;
        if (isNotOpposing(pass, contactor, normal))
            beyond = trim(here, point.where, pseudo, offset);
        else
            pseudo += normal;
    }

    /// Angle-weighted sum of the normals of all faces around a corner of `face`.
    FPM_KERNEL Vec3<Work> fan(Index face, int corner, Vec3<Work>& offset, bool& beyond) const
    {
        Vec3<Work> sum{0, 0, 0};
        const Index node = pass.faceNode[4 * std::size_t(face) + std::size_t(corner)];
        pass.visitAround(
            face, corner, [&](Index number) __attribute__((always_inline)) {
                const FaceCorners<Work> f = corners(number);
                const int c = cornerOf(number, node);
                const Vec3<Work> normal = cornerNormal(f, c);
                if (number != face && isNotOpposing(pass, contactor, normal)) return true;
                const Vec3<Work> a = f.corner[(c + 1) & 3] - f.corner[c],
                                 b = f.corner[(c + 3) & 3] - f.corner[c];
                const Work sizes = dot(a, a) * dot(b, b);
                if (sizes > 0)
                    sum = multiplyAdd(arcCosine(dot(a, b) / squareRoot(sizes)), normal, sum);
                for (int e = c; e < c + 4; e += 3) {
                    const Index across =
                        pass.neighbour[4 * std::size_t(number) + std::size_t(e & 3)];
                    const bool ends =
                        across == freeEdge
                        || (across >= 0 && across / 4 != face
                            && isNotOpposing(
                                pass, contactor,
                                cornerNormal(corners(across / 4), cornerOf(across / 4, node))));
                    if (ends) beyond = trim(f, e & 3, normal, offset) || beyond;
                }
                return true;
            });
        return sum;
    }

    FPM_KERNEL int cornerOf(Index face, Index node) const
    {
        const Index* nodes = pass.faceNode + 4 * std::size_t(face);
        return nodes[0] == node ? 0 : nodes[1] == node ? 1 : nodes[2] == node ? 2 : 3;
    }
    FPM_KERNEL static Vec3<Work> cornerNormal(const FaceCorners<Work>& f, int c)
    {
        return faceNormal(f, f.corner[(c + 1) & 3] - f.corner[c],
                          f.corner[(c + 3) & 3] - f.corner[c]);
    }

    /// Removes from the offset the part beyond an edge where the surface ends, which is no
    /// distance. True where that part exceeds both the margin and the remaining offset, the depth:
    /// a contactor stays in contact until it is further out than in.
    FPM_KERNEL static bool
    trim(const FaceCorners<Work>& f, int edge, const Vec3<Work>& normal, Vec3<Work>& offset)
    {
        const Vec3<Work>* x = f.corner;
        const int end = (edge + 1) & 3, far = (edge + 2) & 3, last = (edge + 3) & 3;
        const Vec3<Work> outwards = cross(x[end] - x[edge], normal);
        const Work twoWidths = dot((x[edge] - x[last]) + (x[end] - x[far]), outwards),
                   over = dot(offset, outwards), square = dot(outwards, outwards);
        if (!(over > 0)) return false;
        offset = multiplyAdd(-over / square, outwards, offset);
        return over > Work(0.25) * ContactTolerances<Work>::beyondEdge * twoWidths
               && over * over > square * dot(offset, offset);
    }
};

} // namespace fpm
