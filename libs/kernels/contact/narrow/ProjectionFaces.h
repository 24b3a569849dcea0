#pragma once

#include "kernels/contact/law/Friction.h"
#include "kernels/contact/narrow/RidgeFaces.h"

namespace fpm {

/// Up to two directions normal to each other.
template <class Work>
struct Directions {
    Vec3<Work> direction[2];
    int count = 0;

    /// Adds the direction of the part of a vector that is normal to those held.
    FPM_KERNEL void add(const Vec3<Work>& vector) { addPart(vector, dot(vector, vector)); }
    /// Adds the direction of its part in the plane with this normal, likewise.
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
    /// `whole`: square of the full vector; a part that is small against it would be rounding.
    FPM_KERNEL void addPart(const Vec3<Work>& vector, Work whole)
    {
        const Vec3<Work> part = without(vector);
        const Work square = dot(part, part);
        if (count < 2 && square > negligibleSquare<Work>() * whole)
            direction[count++] = (Work(1) / squareRoot(square)) * part;
    }
};

/// Projection point of a contactor: face and natural coordinates.
template <class Work>
struct Place {
    Index face;
    Work xi, eta;
};

/// Whether a point of a face lies on its border, which neighbouring faces share.
template <class Work>
FPM_KERNEL bool isOnBorder(Work xi)
{
    return xi * xi >= Work(1);
}
template <class Work>
FPM_KERNEL bool isOnBorder(Work xi, Work eta)
{
    return isOnBorder(xi) || isOnBorder(eta);
}
/// Edge on which a border point lies.
template <class Work>
FPM_KERNEL int edgeAtXi(Work xi)
{
    return xi > 0 ? 1 : 3;
}
template <class Work>
FPM_KERNEL int edgeAtEta(Work eta)
{
    return eta > 0 ? 2 : 0;
}

/// Point on an edge in the coordinates of the face across it; false where there is none.
template <class Numbers>
FPM_KERNEL bool placeAcross(const ContactPassView<Numbers>& pass,
                            const Place<typename Numbers::Work>& place,
                            int edge,
                            Place<typename Numbers::Work>& out)
{
    const Index across = pass.neighbour[4 * std::size_t(place.face) + std::size_t(edge)];
    if (across < 0) return false;
    out.face = across / 4;
    edgePoint(across & 3, shareAlong(edge, -place.xi, -place.eta), out.xi,
              out.eta); // the edge runs in the opposite direction there
    return true;
}

/// The other faces that share a projection point on the border of one: the face across an edge, all
/// faces around a corner.
template <class Numbers>
struct FacesAroundProjection {
    using Work = typename Numbers::Work;
    const ContactPassView<Numbers>& pass;
    Index i; ///< contactor

    /// Calls visit(point, normal there) for those whose normal opposes the contactor's, until it
    /// returns false.
    template <class Visit>
    FPM_KERNEL void forEach(const Place<Work>& projection, const Visit& visit) const
    {
        const bool onXi = isOnBorder(projection.xi), onEta = isOnBorder(projection.eta);
        if (onXi && onEta)
            visitCorner(projection, visit);
        else if (onXi || onEta)
            visitEdge(projection, onXi ? edgeAtXi(projection.xi) : edgeAtEta(projection.eta),
                      visit);
    }

private:
    template <class Visit>
    FPM_KERNEL void visitEdge(const Place<Work>& projection, int edge, const Visit& visit) const
    {
        Place<Work> other;
        if (placeAcross(pass, projection, edge, other)) visitPlace(other, visit);
    }
    template <class Visit>
    FPM_KERNEL void visitCorner(const Place<Work>& projection, const Visit& visit) const
    {
        const int corner =
            projection.xi > 0 ? (projection.eta > 0 ? 2 : 1) : (projection.eta > 0 ? 3 : 0);
        const Index node = pass.faceNode[4 * std::size_t(projection.face) + std::size_t(corner)];
        pass.visitAround(
            projection.face, corner, [&](Index other) __attribute__((always_inline)) {
                const Index* nodes = pass.faceNode + 4 * std::size_t(other);
                int c = 0;
                while (c < 3 && nodes[c] != node) ++c;
                return other == projection.face
                       || visitPlace({other, Work(c == 1 || c == 2 ? 1 : -1), Work(c > 1 ? 1 : -1)},
                                     visit);
            });
    }
    template <class Visit>
    FPM_KERNEL bool visitPlace(const Place<Work>& place, const Visit& visit) const
    {
        const Vec3<Work> normal =
            gapAt(pass.corners(place.face, pass.contactor[i]), place.xi, place.eta).normal;
        return isNotOpposing(pass, i, normal) || visit(place, normal);
    }
};

/// The faces that share a projection point and are equal partners of the contactor: one face for a
/// point inside, two at an edge, all around a corner, without those whose normal does not oppose
/// the contactor's. The first is the face it is tracked on; results must not depend on which of
/// them that is. A face that does not oppose the contactor is kept only where none does.
template <class Numbers>
struct ProjectionFaces {
    using Work = typename Numbers::Work;
    static constexpr int most = 8;

    Index face[most];
    Work xi[most], eta[most];
    Vec3<Work> normal[most]; ///< at the projection point, on the face in its current position
    int count = 0;

    FPM_KERNEL ProjectionFaces() {} ///< none

    FPM_KERNEL
    ProjectionFaces(const ContactPassView<Numbers>& pass, Index i, const Place<Work>& projection)
    {
        addAll(pass, i, projection);
    }
    /// At the point of a projection; inside a face the normal is that of the face.
    FPM_KERNEL
    ProjectionFaces(const ContactPassView<Numbers>& pass,
                    Index i,
                    Index first,
                    const Projection<Work>& at)
    {
        if (isOnBorder(at.xi, at.eta))
            addAll(pass, i, {first, at.xi, at.eta});
        else
            add({first, at.xi, at.eta}, at.normal);
    }

    /// Mean of the normals of all these faces and, on symmetry planes, of their mirror images: the
    /// part that lies in all of these planes, which need not be normal to each other.
    FPM_KERNEL Vec3<Work> meanNormal(const ContactPassView<Numbers>& pass) const
    {
        Vec3<Work> mean = normal[0];
        for (int k = 1; k < count; ++k) mean += normal[k];
        Directions<Work> cancelled;
        for (int k = 0; k < count; ++k) {
            if (isOnBorder(xi[k])) addMirror(pass, face[k], edgeAtXi(xi[k]), cancelled);
            if (isOnBorder(eta[k])) addMirror(pass, face[k], edgeAtEta(eta[k]), cancelled);
        }
        return cancelled.without((Work(1) / Work(count)) * mean);
    }
    /// Image of a force on the first face at another; at a common projection point they are equal.
    FPM_KERNEL const Vec3<Work>& image(int, const Vec3<Work>& force) const { return force; }

private:
    FPM_KERNEL static void
    addMirror(const ContactPassView<Numbers>& pass, Index face, int edge, Directions<Work>& to)
    {
        const Index across = pass.neighbour[4 * std::size_t(face) + std::size_t(edge)];
        if (across < noEdge) to.add(pass.mirror(mirrorEdge(across)));
    }
    FPM_KERNEL void
    addAll(const ContactPassView<Numbers>& pass, Index i, const Place<Work>& projection)
    {
        add(projection,
            gapAt(pass.corners(projection.face, pass.contactor[i]), projection.xi, projection.eta)
                .normal);
        FacesAroundProjection<Numbers>{pass, i}.forEach(
            projection, [&](const Place<Work>& other, const Vec3<Work>& there) {
                add(other, there);
                return count < most;
            });
        if (count > 1 && isNotOpposing(pass, i, normal[0])) leaveOut(0);
    }
    FPM_KERNEL void leaveOut(int k)
    {
        --count;
        face[k] = face[count];
        xi[k] = xi[count];
        eta[k] = eta[count];
        normal[k] = normal[count];
    }
    FPM_KERNEL void add(const Place<Work>& place, const Vec3<Work>& there)
    {
        face[count] = place.face;
        xi[count] = place.xi;
        eta[count] = place.eta;
        normal[count] = there;
        ++count;
    }
};

} // namespace fpm
