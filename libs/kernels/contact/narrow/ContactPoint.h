#pragma once

#include "kernels/contact/narrow/Ridge.h"

namespace fpm {

/// What a contactor is in contact with in one step, the result of the narrow phase: the faces that
/// bear it and their shares, gap and normal. One face inside it; on an edge or a corner those that
/// share the projection point, with equal weights; inside a ridge those that are about as near,
/// with the weights of RidgeDepth. Nothing depends on which of them is tracked. Stiffness, mass,
/// slip, force and couple are sums over the weighted faces.
template <class Work>
struct ContactPoint {
    static constexpr int most = 8;

    Vec3<Work> normal; ///< unit, outward
    Work gap;          ///< negative inside; inside a ridge the depth of RidgeDepth
    bool beyond;       ///< it left the surface over a free edge
    int count;         ///< faces; the first is the one it is tracked on
    Index face[most];
    Index planes[most];     ///< of symmetry in which the face's image is meant, as FaceImage
    Vec3<Work> shift[most]; ///< of the contactor's image
    Work xi[most], eta[most], weight[most];
    Vec3<Work> push[most]; ///< normal force on each for a unit of stiffness times depth,
                           ///< derivatives of the gap

    /// One face, whose closest point is `at`.
    FPM_KERNEL ContactPoint(Index tracked, const Projection<Work>& at, bool isBeyond)
        : normal(at.normal),
          gap(at.gap),
          beyond(isBeyond),
          count(1)
    {
        face[0] = tracked;
        planes[0] = 0;
        shift[0] = {0, 0, 0};
        xi[0] = at.xi;
        eta[0] = at.eta;
        weight[0] = 1;
        push[0] = at.normal;
    }

    /// Corners of a face relative to the contactor, or to its image that the face meets.
    template <class Numbers>
    FPM_KERNEL FaceCorners<Work> corners(const ContactPassView<Numbers>& pass, Index i, int k) const
    {
        const FaceCorners<Work> out = pass.corners(face[k], pass.contactor[i]);
        return planes[k] == 0 ? out : shifted(out, shift[k]);
    }
    FPM_KERNEL bool isOnBorder() const
    {
        return xi[0] * xi[0] >= Work(1) || eta[0] * eta[0] >= Work(1);
    }
    /// Adds the faces that share a projection point on the border, without those that do not oppose
    /// the contactor; such a one is kept only where none does.
    template <class Numbers>
    FPM_KERNEL void addSharers(const ContactPassView<Numbers>& pass, Index i)
    {
        if (count > 1 || !isOnBorder()) return;
        const bool onXi = xi[0] * xi[0] >= Work(1), onEta = eta[0] * eta[0] >= Work(1);
        if (onXi && onEta)
            addFan(pass, i);
        else
            addAcross(pass, i, onXi ? (xi[0] > 0 ? 1 : 3) : (eta[0] > 0 ? 2 : 0));
        if (count == 1) return;
        if (isNotOpposing(pass, i,
                          gapAt(pass.corners(face[0], pass.contactor[i]), xi[0], eta[0]).normal))
            leaveOutFirst();
        const Work part = Work(1) / Work(count);
        for (int k = 0; k < count; ++k) {
            weight[k] = part;
            push[k] = part * normal;
        }
    }
    /// Blends the face that is tracked with others that are about as near, inside a ridge.
    FPM_KERNEL void blend(const RidgeFaces<Work>& near)
    {
        RidgeDepth<Work> depth;
        depth.add(-gap, normal);
        for (int k = 0; k < near.count; ++k) depth.add(-near.gap[k], near.normal[k]);
        depth.solve();
        gap = -depth.depth;
        Vec3<Work> sum{0, 0, 0};
        int kept = 0;
        for (int k = 0; k <= near.count; ++k) {
            if (k > 0 && !(depth.weight[k] > 0)) continue;
            if (k > 0) {
                face[kept] = near.face[k - 1].face;
                planes[kept] = near.face[k - 1].planes;
                shift[kept] = near.shift[k - 1];
                xi[kept] = near.xi[k - 1];
                eta[kept] = near.eta[k - 1];
            }
            weight[kept] = depth.weight[k];
            push[kept] = depth.derivative(k) * depth.normal[k];
            sum += push[kept++];
        }
        count = kept;
        normal = (Work(1) / squareRoot(dot(sum, sum))) * sum;
    }

private:
    template <class Numbers>
    FPM_KERNEL void addAcross(const ContactPassView<Numbers>& pass, Index i, int edge)
    {
        const Index across = pass.neighbour[4 * std::size_t(face[0]) + std::size_t(edge)];
        if (across < 0) return;
        Work otherXi, otherEta;
        edgePoint(across & 3, shareAlong(edge, -xi[0], -eta[0]), otherXi,
                  otherEta); // the edge runs in the opposite direction there
        add(pass, i, across / 4, otherXi, otherEta);
    }
    template <class Numbers>
    FPM_KERNEL void addFan(const ContactPassView<Numbers>& pass, Index i)
    {
        const int corner = xi[0] > 0 ? (eta[0] > 0 ? 2 : 1) : (eta[0] > 0 ? 3 : 0);
        const Index first = face[0],
                    node = pass.faceNode[4 * std::size_t(first) + std::size_t(corner)];
        pass.visitAround(
            first, corner, [&](Index other) __attribute__((always_inline)) {
                if (other == first) return true;
                const Index* nodes = pass.faceNode + 4 * std::size_t(other);
                int c = 0;
                while (c < 3 && nodes[c] != node) ++c;
                add(pass, i, other, Work(c == 1 || c == 2 ? 1 : -1), Work(c > 1 ? 1 : -1));
                return count < most;
            });
    }
    template <class Numbers>
    FPM_KERNEL void
    add(const ContactPassView<Numbers>& pass, Index i, Index other, Work atXi, Work atEta)
    {
        if (isNotOpposing(pass, i,
                          gapAt(pass.corners(other, pass.contactor[i]), atXi, atEta).normal))
            return;
        face[count] = other;
        planes[count] = 0;
        xi[count] = atXi;
        eta[count] = atEta;
        ++count;
    }
    FPM_KERNEL void leaveOutFirst()
    {
        --count;
        face[0] = face[count];
        xi[0] = xi[count];
        eta[0] = eta[count];
    }
};

} // namespace fpm
