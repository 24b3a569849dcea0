#pragma once

#include "kernels/contact/Friction.h"
#include "kernels/contact/RidgeFaces.h"

namespace fpm {

/// Directions normal to each other, two at most.
template <class Work>
struct Directions {
    Vec3<Work> direction[2];
    int count = 0;

    /// What of a vector is new.
    FPM_KERNEL void add(const Vec3<Work>& vector) { addPart(vector, dot(vector, vector)); }
    /// What of it lies in the plane with this normal and is new.
    FPM_KERNEL void add(const Vec3<Work>& vector, const Vec3<Work>& normal)
    {
        addPart(inPlane(vector, normal), dot(vector, vector));
    }
    FPM_KERNEL Vec3<Work> without(Vec3<Work> vector) const
    {
        for (int k = 0; k < count; ++k) vector = vector - dot(vector, direction[k]) * direction[k];
        return vector;
    }

private:
    /// `whole`: square of the vector that it is a part of; a small part would be rounding.
    FPM_KERNEL void addPart(const Vec3<Work>& vector, Work whole)
    {
        const Vec3<Work> part = without(vector);
        const Work square = dot(part, part);
        if (count < 2 && square > negligibleSquare<Work>() * whole)
            direction[count++] = (Work(1) / squareRoot(square)) * part;
    }
};

/// The faces that have a foot in common, equal partners of the contactor: the one it lies inside,
/// both at an edge, all around a corner, those that look away left out. The first is the one it is
/// tracked on, which of them that is must not matter.
template <class Precision>
struct FootFaces {
    using Work = typename Precision::Work;
    static constexpr int most = 8;

    Index face[most];
    Work xi[most], eta[most];
    Vec3<Work> normal[most]; ///< at the foot, on the face as it lies now
    int count = 0;

    FPM_KERNEL FootFaces() {} ///< none

    FPM_KERNEL
    FootFaces(const PairView<Precision>& pair, Index i, Index first, Work atXi, Work atEta)
    {
        add(pair, i, first, atXi, atEta);
        if (isOnBorder(atXi, atEta)) addOthers(pair, i, atXi, atEta);
    }
    /// At the foot of a projection; inside a face its normal is that of the face.
    FPM_KERNEL
    FootFaces(const PairView<Precision>& pair, Index i, Index first, const Projection<Work>& at)
    {
        if (isOnBorder(at.xi, at.eta)) {
            add(pair, i, first, at.xi, at.eta);
            addOthers(pair, i, at.xi, at.eta);
            return;
        }
        face[0] = first;
        xi[0] = at.xi;
        eta[0] = at.eta;
        normal[0] = at.normal;
        count = 1;
    }
    FPM_KERNEL static bool isOnBorder(Work xi, Work eta) { return isBorder(xi) || isBorder(eta); }

    /// Mean of the normals of all of them and, on planes of symmetry, of their images: what lies in
    /// all of these planes, which need not be normal to each other.
    FPM_KERNEL Vec3<Work> meanNormal(const PairView<Precision>& pair) const
    {
        Vec3<Work> mean = normal[0];
        for (int k = 1; k < count; ++k) mean += normal[k];
        Directions<Work> cancelled;
        for (int k = 0; k < count; ++k) {
            if (isBorder(xi[k])) addMirror(pair, face[k], edgeAtXi(xi[k]), cancelled);
            if (isBorder(eta[k])) addMirror(pair, face[k], edgeAtEta(eta[k]), cancelled);
        }
        return cancelled.without((Work(1) / Work(count)) * mean);
    }
    /// What a force in the first face is in another: they have it in common.
    FPM_KERNEL const Vec3<Work>& image(int, const Vec3<Work>& force) const { return force; }

private:
    FPM_KERNEL static bool isBorder(Work x) { return x * x >= Work(1); }
    FPM_KERNEL static int edgeAtXi(Work x) { return x > 0 ? 1 : 3; }
    FPM_KERNEL static int edgeAtEta(Work x) { return x > 0 ? 2 : 0; }
    FPM_KERNEL void addOthers(const PairView<Precision>& pair, Index i, Work atXi, Work atEta)
    {
        if (isBorder(atXi) && isBorder(atEta))
            addCorner(pair, i, atXi > 0 ? (atEta > 0 ? 2 : 1) : (atEta > 0 ? 3 : 0));
        else
            addEdge(pair, i, isBorder(atXi) ? edgeAtXi(atXi) : edgeAtEta(atEta));
    }

    FPM_KERNEL static void
    addMirror(const PairView<Precision>& pair, Index face, int edge, Directions<Work>& to)
    {
        const Index across = pair.neighbour[4 * std::size_t(face) + std::size_t(edge)];
        if (across < noEdge) to.add(pair.mirror(mirrorEdge(across)));
    }
    FPM_KERNEL void
    add(const PairView<Precision>& pair, Index i, Index other, Work atXi, Work atEta)
    {
        normal[count] = gapAt(pair.corners(other, pair.contactor[i]), atXi, atEta).normal;
        if (count > 0 && looksAway(pair, i, normal[count])) return;
        face[count] = other;
        xi[count] = atXi;
        eta[count] = atEta;
        ++count;
    }
    FPM_KERNEL void addEdge(const PairView<Precision>& pair, Index i, int edge)
    {
        const Index across = pair.neighbour[4 * std::size_t(face[0]) + std::size_t(edge)];
        if (across < 0) return;
        Work atXi, atEta;
        edgePoint(across & 3, shareAlong(edge, -xi[0], -eta[0]), atXi,
                  atEta); // the other way round
        add(pair, i, across / 4, atXi, atEta);
    }
    FPM_KERNEL void addCorner(const PairView<Precision>& pair, Index i, int corner)
    {
        const Index node = pair.faceNode[4 * std::size_t(face[0]) + std::size_t(corner)];
        pair.visitAround(face[0], corner, [&](Index other) {
            const Index* nodes = pair.faceNode + 4 * std::size_t(other);
            int c = 0;
            while (c < 3 && nodes[c] != node) ++c;
            if (other != face[0])
                add(pair, i, other, Work(c == 1 || c == 2 ? 1 : -1), Work(c > 1 ? 1 : -1));
            return count < most;
        });
    }
};

} // namespace fpm
