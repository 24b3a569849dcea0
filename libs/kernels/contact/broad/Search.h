#pragma once

#include "kernels/contact/narrow/FaceChoice.h"

namespace fpm {

/// Mean unit normal of the contactor's own faces; faces whose normal does not oppose it are no
/// partners. Zero where the own normals cancel, as on the edge of a thin blade.
template <class Numbers>
struct ContactorNormal {
    ContactPassView<Numbers> pass;

    FPM_KERNEL void operator()(Index i) const
    {
        using Work = typename Numbers::Work;
        Vec3<Work> sum{0, 0, 0};
        Work count = 0;
        for (Index k = pass.ownFaceStart[i]; k < pass.ownFaceStart[i + 1]; ++k) {
            const Index* nodes = pass.ownFaceNode + 4 * std::size_t(pass.ownFaces[k]);
            const Vec3<Work> d1 = pass.relative(nodes[2], nodes[0]),
                             d2 = pass.relative(nodes[3], nodes[1]);
            const Vec3<Work> n = cross(d1, d2);
            const Work length = squareRoot(dot(n, n));
            if (length > 0) sum += (Work(1) / length) * n;
            count += 1;
        }
        const Work length = squareRoot(dot(sum, sum));
        const Work scale = length > Work(0.2) * count ? Work(1) / length : Work(0);
        pass.setOwnNormal(i, scale * sum);
    }
};

/// Nodes of a pass to be searched: those of the blocks due, or all.
struct NodeBlocks {
    static constexpr Index blocks(Index nodes) { return blocksOf(nodes, contactBlock); }
    const Index* list;       ///< numbers of blocks
    const std::int64_t* due; ///< number of blocks due; null: all blocks
    const StepClock* clock;  ///< null: unconditional; otherwise no search where no step follows

    FPM_KERNEL bool any() const { return (!due || *due > 0) && (!clock || clock->mayStep()); }
    /// Node for an index below contactBlock * blocks(nodes); -1: none.
    FPM_KERNEL Index node(Index i) const
    {
        if (!any()) return -1;
        if (!due) return i;
        return i / contactBlock < *due ? contactBlock * list[i / contactBlock] + i % contactBlock
                                       : -1;
    }
};

/// Runs a kernel over nodes for the nodes of the blocks due only.
template <class Kernel>
struct InBlocks {
    NodeBlocks blocks;
    Index nodeCount;
    Kernel kernel;
    FPM_KERNEL void operator()(Index i) const
    {
        const Index node = blocks.node(i);
        if (node >= 0 && node < nodeCount) kernel(node);
    }
};
template <class Kernel>
InBlocks(NodeBlocks, Index, Kernel) -> InBlocks<Kernel>;

/// Runs a kernel that a search needs, only where there is a search.
template <class Kernel>
struct WhereSearched {
    NodeBlocks blocks;
    Kernel kernel;
    FPM_KERNEL void operator()(Index i) const
    {
        if (blocks.any()) kernel(i);
    }
};
template <class Kernel>
WhereSearched(NodeBlocks, Kernel) -> WhereSearched<Kernel>;

/// Enters the result of a search into the slots of one node.
template <class Numbers>
struct SlotChoice {
    using Work = typename Numbers::Work;
    const ContactPassView<Numbers>& pass;
    Index node; ///< number among the nodes of the pass

    FPM_KERNEL void enter(NearestFaces<Work>& found, Around around) const
    {
        if (found.crowded) atomicAdd64(pass.counts + countCrowded, 1);
        const int slots = int(pass.contactorCount / pass.nodeCount);
        bool placed[maxSlots] = {};
        for (int slot = 0; slot < slots; ++slot) { // a body keeps its slot, with its history
            const Index i = node + slot * pass.nodeCount, face = pass.face[i];
            if (face < 0) continue;
            int match = 0;
            while (match < found.count && found.component[match] != pass.componentOf(face)) ++match;
            const bool touching = pass.law.springEnergy[i] > 0;
            if (match < found.count) {
                // What was lifted over an edge stays there (EdgeLift).
                if (pass.overlap[i] > 0)
                    EdgeLift<Numbers>{pass, i}.lift(found.best[match], normalOf(i));
                update(i, found.best[match], touching);
                placed[match] = true;
            } else if (!touching) // in contact it keeps its face where no nearer one is found
                pass.face[i] = noFace;
        }
        for (int match = 0; match < found.count; ++match)
            for (int slot = 0; slot < slots && !placed[match]; ++slot) {
                const Index i = node + slot * pass.nodeCount;
                if (pass.face[i] >= 0) continue;
                EdgeLift<Numbers>{pass, i}.lift(found.best[match], {0, 0, 0});
                update(i, found.best[match], false);
                forgive(i, found.best[match].gap);
                placed[match] = true;
            }
        for (int slot = 0; slot < slots; ++slot) pass.around[node + slot * pass.nodeCount] = around;
    }

private:
    /// A contactor that approaches from outside is found outside. One that is first found inside
    /// has entered over an edge or was released: pushing it out would create the energy of the
    /// spring, so its depth is forgiven.
    FPM_KERNEL void forgive(Index i, Work gap) const
    {
        pass.overlap[i] = 0;
        if (pass.injected) pass.injected[pass.contactorCount + i] = 0; // see relievedGap
        if (!(gap < 0)) return;
        pass.overlap[i] =
            notLess(pass.fadeTime > 0 ? -gap / pass.forgivenShare(pass.clock->time) : -gap);
        atomicAdd64(pass.counts + countInside, 1);
    }
    /// Normal of the face on which a contactor is tracked.
    FPM_KERNEL Vec3<Work> normalOf(Index i) const
    {
        const FaceCorners<Work> corners = pass.corners(pass.face[i], pass.contactor[i]);
        const FacePoint<Work> point = closestPoint(corners, pass.xi[i], pass.eta[i]);
        return gapAt(corners, point.xi, point.eta).normal;
    }
    FPM_KERNEL void update(Index i, const Candidate<Work>& found, bool touching) const
    {
        if (found.face == pass.face[i]) return; // tracked already: the warm start is kept
        if (touching) {
            const FacePoint<Work> now = closestPoint(pass.corners(pass.face[i], pass.contactor[i]),
                                                     pass.xi[i], pass.eta[i]);
            // Equally near, such as on the edge between the two: no reason to change.
            if (!(found.point.square < Work(0.9998) * now.square)) return;
            if (found.point.square < Work(0.98) * now.square
                && now.square > Work(1e-8) * pass.reach * pass.reach)
                atomicAdd64(pass.counts + countMistaken, 1);
        }
        pass.face[i] = found.face;
        pass.xi[i] = found.point.xi;
        pass.eta[i] = found.point.eta;
    }
};

/// `search faces`: tests every face entered into the node's own cells and those around them.
template <class Numbers>
struct FindFace {
    using Work = typename Numbers::Work;
    ContactPassView<Numbers> pass;
    CellLists cells;

    FPM_KERNEL void operator()(Index node) const
    {
        NearestFaces<Work> found;
        const int slots = int(pass.contactorCount / pass.nodeCount);
        Index partner[mostPartners];
        int partners = 0;
        cells.forEachFace(
            pass, pass.contactor[node], [&](Index face) __attribute__((always_inline)) {
                Candidate<Work> candidate;
                if (!isPartner(pass, node, face, candidate)) return;
                found.add(candidate, pass.componentOf(face), slots);
                if (partners < mostPartners) partner[partners] = face;
                ++partners;
            });
        SlotChoice<Numbers>{pass, node}.enter(found, around(node, found, partner, partners));
    }

private:
    static constexpr int mostPartners = 12;

    FPM_KERNEL Around around(Index node,
                             const NearestFaces<Work>& found,
                             const Index (&partner)[mostPartners],
                             int partners) const
    {
        if (partners > mostPartners) return aroundIntricate; // more than the table holds
        if (found.count == 0) return aroundCurved; // in contact, deeper than the search reaches
        Around result = aroundFlat;
        for (int p = 0; partners > 1 && p < partners; ++p)
            for (int k = 0; k < found.count; ++k) {
                const Index best = found.best[k].face;
                if (found.component[k] != pass.componentOf(partner[p]) || best == partner[p])
                    continue;
                const Work cosine = dot(normalOf(node, best), normalOf(node, partner[p]));
                if (!(cosine > Work(0.5)) || apart(best, partner[p])) return aroundIntricate;
                if (cosine < Work(0.9998)) result = aroundCurved;
            }
        return result;
    }
    FPM_KERNEL Vec3<Work> normalOf(Index node, Index face) const
    {
        return gapAt(pass.corners(face, pass.contactor[node]), Work(0), Work(0)).normal;
    }
    /// Whether two faces share no node, and one of them has a free edge.
    FPM_KERNEL bool apart(Index a, Index b) const
    {
        const std::size_t first = 4 * std::size_t(a), second = 4 * std::size_t(b);
        bool free = false;
        for (int k = 0; k < 4; ++k) {
            for (int l = 0; l < 4; ++l)
                if (pass.faceNode[first + k] == pass.faceNode[second + l]) return false;
            free = free || pass.neighbour[first + k] == freeEdge
                   || pass.neighbour[second + k] == freeEdge;
        }
        return free;
    }
};

/// Search of the paper's section 3.2.3: closest target particle in the contactor's cell and its 26
/// neighbours (of equal distances the lower number), then the faces around that particle.
template <class Numbers>
struct FindClosestParticle {
    using Work = typename Numbers::Work;
    ContactPassView<Numbers> pass;
    CellLists cells;

    FPM_KERNEL void operator()(Index i) const
    {
        const Index closest = closestTarget(i);
        if (closest >= 0 && pass.cold && hasCorner(pass.face[i], closest))
            return; // the faces around it are known, and each step projects onto all of them
        NearestFaces<Work> found;
        if (closest >= 0)
            pass.visitAround(
                pass.targetCorner[closest] / 4,
                pass.targetCorner[closest] % 4, [&](Index face) __attribute__((always_inline)) {
                    Candidate<Work> candidate;
                    if (isPartner(pass, i, face, candidate)) found.add(candidate, 0, 1);
                    return true;
                });
        SlotChoice<Numbers>{pass, i}.enter(found, aroundCurved);
    }

private:
    FPM_KERNEL bool hasCorner(Index face, Index target) const
    {
        const Index* corner = pass.faceNode + 4 * std::size_t(face < 0 ? 0 : face);
        const Index node = pass.targetNode(target);
        return face >= 0
               && (corner[0] == node || corner[1] == node || corner[2] == node
                   || corner[3] == node);
    }
    FPM_KERNEL Index closestTarget(Index i) const
    {
        const Index node = pass.contactor[i];
        std::int64_t cell[3];
        for (int c = 0; c < 3; ++c)
            cell[c] = CellLists::cellOf(
                double(pass.position[c * pass.nodeStride + std::size_t(node)]), cells.cellSize);
        Index closest = -1;
        Work best = 0;
        for (int near = 0; near < 27; ++near) {
            const Index* list = cells.list(cell[0] + near % 3 - 1, cell[1] + near / 3 % 3 - 1,
                                           cell[2] + near / 9 - 1);
            for (Index k = *list; k >= 0; k = cells.entries[k].next) {
                const Vec3<Work> r = pass.relative(pass.targetNode(k), node);
                const Work square = dot(r, r);
                if (closest < 0 || square < best || (square == best && k < closest)) {
                    closest = k;
                    best = square;
                }
            }
        }
        return closest;
    }
};

} // namespace fpm
