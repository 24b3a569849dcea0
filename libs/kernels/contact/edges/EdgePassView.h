#pragma once

#include "kernels/contact/ContactPassView.h"
#include "kernels/contact/edges/EdgeGeometry.h"

namespace fpm {

/// Partners that one segment may have at once: it crosses both edges of a wire, and where two
/// segments meet, the next ones are near.
inline constexpr int edgeSlots = 8;

/// What the pair of a slot was at the last step.
enum EdgeState : std::uint8_t {
    edgesApart,   ///< no crossing: nothing is known of a side
    edgesOpen,    ///< they crossed each other outside
    edgesClosed,  ///< they bear, or their depth is forgiven
    edgesReleased ///< too deep; without force until they have separated
};

/// What it does in this step.
enum EdgePhase : std::uint8_t {
    phaseApart,
    phaseOpposite, ///< crossing, open
    phaseReleased, ///< crossing inside, released before
    phaseEnters,   ///< crossing inside, and was not closed
    phaseStays,    ///< closed
    phaseLeaves,   ///< closed, its closest points beyond an end
    phaseOpens,    ///< closed before, now outside
    phaseLost      ///< closed before: too deep, almost parallel, or too far beyond an end
};

/// Values of `passedOn` that are no slot.
inline constexpr Index toNone = -1, heldByNodes = -2;

/// Segments of the sharp edges of the surfaces of a pair, as a pass: contactor i is the segment
/// i % nodeCount with one of its partners, the number of which is `face`; `xi` and `eta` are the
/// places on the two. Segments of both sides are numbered as one, and a pair belongs to the lower.
template <class Numbers>
struct EdgePassView {
    using Work = typename Numbers::Work;

    ContactPassView<Numbers> pass; ///< a segment is a face there, with its stiffness and thickness
    const Index* node;             ///< [6 * segment]: its ends, and two far corners of either face
    const Index* next;   ///< [2 * segment + end]: 2 * segment + end that the edge goes on with, -1:
                         ///< none
    Index firstTarget;   ///< segments from here on are partners
    Work queryHalf;      ///< half of the distance of the points from which a segment searches
    std::uint8_t* state; ///< as EdgeState
    std::uint8_t* phase; ///< as EdgePhase
    Index* passedOn;     ///< of a pair that leaves, the slot it goes on in; of one that enters, the
                         ///< slot it comes from

    FPM_KERNEL Index segmentOf(Index i) const { return i % pass.nodeCount; }
    FPM_KERNEL Index nodeOf(Index segment, int k) const
    {
        return node[6 * std::size_t(segment) + std::size_t(k)];
    }
    FPM_KERNEL EdgeSegment<Work> segment(Index number, Index origin) const
    {
        const Index* n = node + 6 * std::size_t(number);
        return {pass.relative(n[0], origin), pass.relative(n[1], origin),
                pass.relative(n[2], origin) + pass.relative(n[3], origin),
                pass.relative(n[4], origin) + pass.relative(n[5], origin)};
    }
    FPM_KERNEL Vec3<Work> velocityAt(Index number, Work share) const
    {
        const Vec3<Work> from = pass.velocityOf(nodeOf(number, 0)),
                         to = pass.velocityOf(nodeOf(number, 1));
        return from + share * (to - from);
    }
    /// Half the lesser thickness behind the two: the depth at which they are released.
    FPM_KERNEL Work deepest(Index a, Index b) const
    {
        const Work ofA = Work(pass.faceThickness[a]), ofB = Work(pass.faceThickness[b]);
        return Work(0.5) * (ofA < ofB ? ofA : ofB);
    }
    /// Slot of a pair of segments; -1: none has it.
    FPM_KERNEL Index slotOf(Index p, Index q) const
    {
        const Index lower = p < q ? p : q, upper = p < q ? q : p;
        for (Index i = lower; i < pass.contactorCount; i += pass.nodeCount)
            if (pass.face[i] == upper) return i;
        return -1;
    }
    /// Calls visit(slot, swapped) for the slots of the pairs in which one or both of the edges go
    /// on beyond their nearer end; swapped: there the other edge is the contactor.
    template <class Visit>
    FPM_KERNEL void visitNeighbours(Index i, const EdgeCrossing<Work>& at, const Visit& visit) const
    {
        const Index a = segmentOf(i), b = pass.face[i];
        const Index nextA = next[2 * a + (at.s < Work(0.5) ? 0 : 1)],
                    nextB = next[2 * b + (at.t < Work(0.5) ? 0 : 1)];
        for (int k = 1; k < 4; ++k) {
            if (((k & 1) && nextA < 0) || ((k & 2) && nextB < 0)) continue;
            const Index p = k & 1 ? nextA / 2 : a, q = k & 2 ? nextB / 2 : b;
            const Index slot = slotOf(p, q);
            if (slot >= 0) visit(slot, p > q);
        }
    }
};

/// A pair of segments at the present positions.
template <class Numbers>
struct EdgePair {
    using Work = typename Numbers::Work;
    Index first, second;
    EdgeSegment<Work> a, b;
    EdgeCrossing<Work> at;

    FPM_KERNEL EdgePair(const EdgePassView<Numbers>& edges, Index i)
        : first(edges.segmentOf(i)),
          second(edges.pass.face[i]),
          a(edges.segment(first, edges.nodeOf(first, 0))),
          b(edges.segment(second, edges.nodeOf(first, 0))),
          at(a, b)
    {
    }
    FPM_KERNEL EdgeFrame<Work> frame() const { return {a, b, at.normal}; }
    /// Whether it lies further beyond an end than it is deep, and than a fiftieth of the segment.
    FPM_KERNEL bool isBeyond() const
    {
        return isBeyond(at.s, dot(a.along, a.along)) || isBeyond(at.t, dot(b.along, b.along));
    }

private:
    FPM_KERNEL bool isBeyond(Work share, Work square) const
    {
        const Work over = share < 0 ? -share : share - Work(1);
        return over > Work(0.02) && over * over * square > at.gap * at.gap;
    }
};

} // namespace fpm
