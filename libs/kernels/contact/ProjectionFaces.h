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

/// Where a contactor is tracked: face and foot on it.
template <class Work>
struct Place {
    Index face;
    Work xi, eta;
};

/// Whether a place of a face is on its border, which it has in common with others.
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
/// The edge at which a place on the border lies.
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

/// A place on an edge as the face across it has it, where there is one.
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
              out.eta); // the other way round
    return true;
}

/// The others of the faces that have a place on the border of one in common: across an edge, around
/// a corner.
template <class Numbers>
struct FacesAroundProjection {
    using Work = typename Numbers::Work;
    const ContactPassView<Numbers>& pass;
    Index i; ///< contactor

    /// visit(place, normal there) for those that do not look away, until it says false.
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
        pass.visitAround(projection.face, corner, [&](Index other) {
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

/// The faces that have a foot in common, equal partners of the contactor: the one it lies inside,
/// both at an edge, all around a corner, those that look away left out. The first is the one it is
/// tracked on, which of them that is must not matter: one that looks away only where all of them
/// do.
template <class Numbers>
struct ProjectionFaces {
    using Work = typename Numbers::Work;
    static constexpr int most = 8;

    Index face[most];
    Work xi[most], eta[most];
    Vec3<Work> normal[most]; ///< at the foot, on the face as it lies now
    int count = 0;

    FPM_KERNEL ProjectionFaces() {} ///< none

    FPM_KERNEL
    ProjectionFaces(const ContactPassView<Numbers>& pass, Index i, const Place<Work>& projection)
    {
        addAll(pass, i, projection);
    }
    /// At the foot of a projection; inside a face its normal is that of the face.
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

    /// Mean of the normals of all of them and, on planes of symmetry, of their images: what lies in
    /// all of these planes, which need not be normal to each other.
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
    /// What a force in the first face is in another: they have it in common.
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
