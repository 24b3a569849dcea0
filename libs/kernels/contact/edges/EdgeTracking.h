#pragma once

#include "kernels/contact/distribute/ForceSum.h"
#include "kernels/contact/edges/EdgePassView.h"

namespace fpm {

// Narrow phase of edge contact. A pair closes where the closest points of the two lines are inside
// both segments and the normal is inside the cones of both wedges: then no separating axis of the
// two wedges is shallower than that of the edges (Gottschalk, Lin and Manocha 1996). Once closed it
// is held until it opens, also where the normal turns a little out of a cone, so that its spring
// loses no energy. Where the closest points come to a joint, the pair of the next segments takes
// over force and friction.

/// First kernel of a step: what each pair does.
template <class Numbers>
struct TrackEdges {
    using Work = typename Numbers::Work;
    EdgePassView<Numbers> edges;

    FPM_KERNEL void operator()(Index i) const
    {
        if (edges.pass.clock->running) edges.phase[i] = phaseOf(i);
    }
    FPM_KERNEL EdgePhase phaseOf(Index i) const
    {
        if (edges.pass.face[i] < 0) return phaseApart;
        const EdgePair<Numbers> pair(edges, i);
        const Work gap = pair.at.gap;
        const bool tooDeep = -gap > edges.deepest(pair.first, pair.second);
        if (edges.state[i] == edgesClosed) {
            if (pair.at.sineSquare > 0 && gap >= 0) return phaseOpens;
            if (!pair.at.mayHold() || tooDeep) return phaseLost;
            if (pair.at.isInner()) return phaseStays;
            return pair.isBeyond() ? phaseLost : phaseLeaves;
        }
        if (!pair.at.mayClose() || tooDeep || !(gap < edges.pass.reach)) return phaseApart;
        if (gap >= 0) return phaseOpposite;
        return edges.state[i] == edgesReleased ? phaseReleased : phaseEnters;
    }
};

/// Second kernel: where a pair that leaves goes on.
template <class Numbers>
struct PassEdgesOn {
    EdgePassView<Numbers> edges;

    FPM_KERNEL void operator()(Index i) const
    {
        if (!edges.pass.clock->running || edges.phase[i] != phaseLeaves) return;
        Index to = toNone;
        edges.visitNeighbours(
            i,
            EdgePair<Numbers>(edges, i).at, [&](Index slot, bool) __attribute__((always_inline)) {
                if (to < 0 && edges.phase[slot] == phaseEnters) to = slot;
            });
        edges.passedOn[i] = to;
    }
};

/// Whether nodes of a pair are held by faces of the other body, so that the edges would count
/// twice: an end of either segment lies over a face, flat against the normal of the crossing (25
/// degrees), and is at least half as deep.
/// `faces`: the passes of nodes against faces of the same pair, in which `contactor` are the ends.
template <class Numbers>
struct NodesAtEdges {
    using Work = typename Numbers::Work;
    struct Side {
        const Index* contactor; ///< [2 * segment + end], -1: none; null: no such pass
        ContactPassView<Numbers> faces;
    };
    Side side[2];

    FPM_KERNEL bool holds(const EdgePassView<Numbers>& edges, const EdgePair<Numbers>& pair) const
    {
        const Work gap = pair.at.gap, near = Work(0.01) * edges.pass.reach,
                   level = (gap < 0 ? Work(0.5) * gap : gap) + near;
        for (int k = 0; k < 2; ++k) {
            if (!side[k].contactor) continue;
            for (int end = 0; end < 4; ++end) {
                const Index segment = end < 2 ? pair.first : pair.second,
                            other = end < 2 ? pair.second : pair.first,
                            base = side[k].contactor[2 * segment + (end & 1)];
                const Vec3<Work> out = end < 2 ? -pair.at.normal : pair.at.normal;
                if (base >= 0 && isHeld(edges, side[k].faces, base, other, level, out)) return true;
            }
        }
        return false;
    }

private:
    FPM_KERNEL static bool isHeld(const EdgePassView<Numbers>& edges,
                                  const ContactPassView<Numbers>& faces,
                                  Index base,
                                  Index other,
                                  Work level,
                                  const Vec3<Work>& out)
    {
        for (Index i = base; i < faces.contactorCount; i += faces.nodeCount) {
            const Index face = faces.face[i];
            if (face < 0) continue;
            if (faces.faceComponent && faces.faceComponent[face] != edges.pass.componentOf(other))
                continue;
            const Projection<Work> at =
                gapAt(faces.corners(face, faces.contactor[i]), faces.xi[i], faces.eta[i]);
            const Work aside = dot(at.offset, at.offset) - at.gap * at.gap,
                       most = Work(1e-3) * faces.reach;
            if (at.gap <= level && aside < most * most && dot(at.normal, out) > Work(0.9))
                return true;
        }
        return false;
    }
};

/// Third kernel: what becomes of pairs that enter. It takes over what a neighbour passes on; waits
/// while nodes or a neighbour hold the two; or closes, from outside or at a depth that is forgiven.
template <class Numbers>
struct EnterEdges {
    using Work = typename Numbers::Work;
    EdgePassView<Numbers> edges;
    NodesAtEdges<Numbers> nodes;

    FPM_KERNEL void operator()(Index i) const
    {
        if (!edges.pass.clock->running) return;
        const bool enters = edges.phase[i] == phaseEnters;
        if (!enters && edges.phase[i] != phaseOpposite) return;
        const EdgePair<Numbers> pair(edges, i);
        edges.passedOn[i] = enters                     ? enter(i, pair)
                            : nodes.holds(edges, pair) ? heldByNodes
                                                       : toNone;
    }

private:
    FPM_KERNEL Index enter(Index i, const EdgePair<Numbers>& pair) const
    {
        Index from = toNone;
        bool taken = false, swapped = false;
        edges.visitNeighbours(
            i, pair.at, [&](Index slot, bool other) __attribute__((always_inline)) {
                const std::uint8_t phase = edges.phase[slot];
                if (phase == phaseLeaves && edges.passedOn[slot] == i && from < 0) {
                    from = slot;
                    swapped = other;
                } else if (phase == phaseStays || phase == phaseLeaves)
                    taken = true;
            });
        if (from >= 0) {
            takeOver(i, pair, from, swapped);
            return from;
        }
        return taken || nodes.holds(edges, pair) ? heldByNodes : toNone;
    }

    FPM_KERNEL void takeOver(Index i, const EdgePair<Numbers>& pair, Index from, bool swapped) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        const EdgePair<Numbers> old(edges, from);
        const Work s = pass.xi[from], t = pass.eta[from];
        pass.xi[i] = swapped ? moved(old.second, old.b, t, pair.first, pair.a)
                             : moved(old.first, old.a, s, pair.first, pair.a);
        pass.eta[i] = swapped ? moved(old.first, old.a, s, pair.second, pair.b)
                              : moved(old.second, old.b, t, pair.second, pair.b);
        pass.overlap[i] = pass.overlap[from];
        pass.law.springEnergy[i] = pass.law.springEnergy[from];
        pass.law.touch.handOver(from, i);
        pass.law.slipDamping.handOver(from, i);
        if (pass.heldStiffness) pass.heldStiffness[i] = pass.heldStiffness[from];
        if (pass.injected)
            pass.injected[pass.contactorCount + i] = pass.injected[pass.contactorCount + from];
        if (pass.law.damps()) pass.law.dampingForce[i] = pass.law.dampingForce[from];
        if (!pass.law.friction.acts()) return;
        const Vec3<Work> force = old.frame().vector(pass.law.storedForce(from));
        const Work sign = swapped ? Work(-1) : Work(1);
        pass.law.store(i, pair.frame().components(
                              turnedPlane(sign * force, sign * old.at.normal, pair.at.normal)));
    }
    /// A place on a segment as a place on the next one, beyond their joint by the same length.
    FPM_KERNEL Work moved(Index from,
                          const EdgeSegment<Work>& there,
                          Work share,
                          Index to,
                          const EdgeSegment<Work>& here) const
    {
        if (from == to) return share;
        const Index end = edges.next[2 * from + 1] / 2 == to ? 1 : 0;
        const Work left = end == 1 ? Work(1) - share : share,
                   width = squareRoot(dot(there.along, there.along) / dot(here.along, here.along));
        return (edges.next[2 * from + end] & 1) ? Work(1) + left * width : -left * width;
    }
};

/// Depth of each pair that crosses inside before the run, 0 of all others; they count as closed
/// from outside.
template <class Numbers>
struct MeasureEdgeOverlap {
    EdgePassView<Numbers> edges;
    NodesAtEdges<Numbers> nodes;
    float* depth; ///< [contactor]

    FPM_KERNEL void operator()(Index i) const
    {
        depth[i] = 0;
        edges.state[i] = edgesApart;
        if (TrackEdges<Numbers>{edges}.phaseOf(i) != phaseEnters) return;
        const EdgePair<Numbers> pair(edges, i);
        if (nodes.holds(edges, pair)) return;
        depth[i] = notLess(-pair.at.gap);
        edges.pass.xi[i] = pair.at.s;
        edges.pass.eta[i] = pair.at.t;
        edges.state[i] = edgesOpen;
    }
};

} // namespace fpm
