#pragma once

#include "kernels/contact/FaceChoice.h"

namespace fpm {

/// Mean unit normal of the contactor's own faces: faces that look the same way are no partners.
/// Zero where they look all ways, as at the edge of a knife.
template <class Precision>
struct ContactorNormal {
    PairView<Precision> pair;

    FPM_KERNEL void operator()(Index i) const
    {
        using Work = typename Precision::Work;
        Vec3<Work> sum{0, 0, 0};
        Work count = 0;
        for (Index k = pair.ownFaceStart[i]; k < pair.ownFaceStart[i + 1]; ++k) {
            const Index* nodes = pair.ownFaceNode + 4 * std::size_t(pair.ownFaces[k]);
            const Vec3<Work> d1 = pair.relative(nodes[2], nodes[0]),
                             d2 = pair.relative(nodes[3], nodes[1]);
            const Vec3<Work> n = cross(d1, d2);
            const Work length = squareRoot(dot(n, n));
            if (length > 0) sum += (Work(1) / length) * n;
            count += 1;
        }
        const Work length = squareRoot(dot(sum, sum));
        const Work scale = length > Work(0.2) * count ? Work(1) / length : Work(0);
        pair.setOwnNormal(i, scale * sum);
    }
};

/// Nodes of a pass that search: those of the blocks that are due, or all.
struct NodeBlocks {
    static constexpr Index size = 256;
    static constexpr Index blocks(Index nodes) { return (nodes + size - 1) / size; }
    const Index* list;       ///< numbers of blocks
    const std::int64_t* due; ///< how many; null: all there are
    const StepClock* clock;  ///< not null: none where no step follows

    FPM_KERNEL bool any() const { return (!due || *due > 0) && (!clock || clock->mayStep()); }
    /// Of indices below size * blocks(nodes); -1: none.
    FPM_KERNEL Index node(Index i) const
    {
        if (!any()) return -1;
        if (!due) return i;
        return i / size < *due ? size * list[i / size] + i % size : -1;
    }
};

/// A kernel over nodes, for those in blocks only.
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

/// A kernel over whatever a search needs, where there is one.
template <class Kernel>
struct WhereSearched {
    NodeBlocks blocks;
    Kernel kernel;
    FPM_KERNEL void operator()(Index i) const
    {
        if (blocks.any()) kernel(i);
    }
};

/// What a search found, entered into the slots of one node.
template <class Precision>
struct SlotChoice {
    using Work = typename Precision::Work;
    const PairView<Precision>& pair;
    Index node; ///< number among the pair's nodes

    FPM_KERNEL void enter(NearestFaces<Work>& found, Around around) const
    {
        if (found.crowded) atomicAdd64(pair.counts + countCrowded, 1);
        const int slots = int(pair.contactorCount / pair.nodeCount);
        bool placed[maxSlots] = {};
        for (int slot = 0; slot < slots; ++slot) { // a body keeps its slot, with its history
            const Index i = node + slot * pair.nodeCount, face = pair.face[i];
            if (face < 0) continue;
            int match = 0;
            while (match < found.count && found.component[match] != pair.componentOf(face)) ++match;
            const bool touching = pair.law.spring[i] > 0;
            if (match < found.count) {
                update(i, found.best[match], touching);
                placed[match] = true;
            } else if (!touching) // in touch it keeps its face where nothing better is found
                pair.face[i] = noFace;
        }
        for (int match = 0; match < found.count; ++match)
            for (int slot = 0; slot < slots && !placed[match]; ++slot) {
                const Index i = node + slot * pair.nodeCount;
                if (pair.face[i] >= 0) continue;
                update(i, found.best[match], false);
                forgive(i, found.best[match].gap);
                placed[match] = true;
            }
        for (int slot = 0; slot < slots; ++slot) pair.around[node + slot * pair.nodeCount] = around;
    }

private:
    /// Whoever comes from outside is found outside. What is first seen inside came in sideways or
    /// was let go: to push it out would create the energy of the spring, so its depth is forgiven.
    FPM_KERNEL void forgive(Index i, Work gap) const
    {
        pair.overlap[i] = 0;
        if (pair.injected) pair.injected[pair.contactorCount + i] = 0; // see relievedGap
        if (!(gap < 0)) return;
        pair.overlap[i] =
            notLess(pair.fadeTime > 0 ? -gap / pair.forgivenShare(pair.clock->time) : -gap);
        atomicAdd64(pair.counts + countInside, 1);
    }
    FPM_KERNEL void update(Index i, const Candidate<Work>& found, bool touching) const
    {
        if (found.face == pair.face[i]) return; // tracked already, warm start kept
        if (touching) {
            const FacePoint<Work> now = closestPoint(pair.corners(pair.face[i], pair.contactor[i]),
                                                     pair.xi[i], pair.eta[i]);
            // As far away, such as on the edge between the two: no reason to change.
            if (!(found.point.square < Work(0.9998) * now.square)) return;
            if (found.point.square < Work(0.98) * now.square
                && now.square > Work(1e-8) * pair.reach * pair.reach)
                atomicAdd64(pair.counts + countMistaken, 1);
        }
        pair.face[i] = found.face;
        pair.xi[i] = found.point.xi;
        pair.eta[i] = found.point.eta;
    }
};

/// `search faces`: the node tries every face entered into its own cells and those around them.
template <class Precision>
struct FindFace {
    using Work = typename Precision::Work;
    PairView<Precision> pair;
    CellLists cells;

    FPM_KERNEL void operator()(Index node) const
    {
        NearestFaces<Work> found;
        const int slots = int(pair.contactorCount / pair.nodeCount);
        Index partner[mostPartners];
        int partners = 0;
        cells.forEachFace(pair, pair.contactor[node], [&](Index face) {
            Candidate<Work> candidate;
            if (!isPartner(pair, node, face, candidate)) return;
            found.add(candidate, pair.componentOf(face), slots);
            if (partners < mostPartners) partner[partners] = face;
            ++partners;
        });
        SlotChoice<Precision>{pair, node}.enter(found, around(node, found, partner, partners));
    }

private:
    static constexpr int mostPartners = 12;

    FPM_KERNEL Around around(Index node,
                             const NearestFaces<Work>& found,
                             const Index (&partner)[mostPartners],
                             int partners) const
    {
        if (partners > mostPartners) return aroundIntricate; // too many to tell
        if (found.count == 0) return aroundCurved; // in touch deeper than the search looks
        Around result = aroundFlat;
        for (int p = 0; partners > 1 && p < partners; ++p)
            for (int k = 0; k < found.count; ++k) {
                const Index best = found.best[k].face;
                if (found.component[k] != pair.componentOf(partner[p]) || best == partner[p])
                    continue;
                const Work cosine = dot(normalOf(node, best), normalOf(node, partner[p]));
                if (!(cosine > Work(0.5)) || apart(best, partner[p])) return aroundIntricate;
                if (cosine < Work(0.9998)) result = aroundCurved;
            }
        return result;
    }
    FPM_KERNEL Vec3<Work> normalOf(Index node, Index face) const
    {
        return gapAt(pair.corners(face, pair.contactor[node]), Work(0), Work(0)).normal;
    }
    /// No common node, and a free edge at one of them.
    FPM_KERNEL bool apart(Index a, Index b) const
    {
        const std::size_t first = 4 * std::size_t(a), second = 4 * std::size_t(b);
        bool free = false;
        for (int k = 0; k < 4; ++k) {
            for (int l = 0; l < 4; ++l)
                if (pair.faceNode[first + k] == pair.faceNode[second + l]) return false;
            free = free || pair.neighbour[first + k] == freeEdge
                   || pair.neighbour[second + k] == freeEdge;
        }
        return free;
    }
};

/// The paper's search: closest target particle in the contactor's cell and its 26 neighbours (equal
/// distances: lower number), then the faces around that particle.
template <class Precision>
struct FindClosestParticle {
    using Work = typename Precision::Work;
    PairView<Precision> pair;
    CellLists cells;

    FPM_KERNEL void operator()(Index i) const
    {
        const Index closest = closestTarget(i);
        if (closest >= 0 && pair.cold && hasCorner(pair.face[i], closest))
            return; // the faces around it are at hand, and projected on at every step
        NearestFaces<Work> found;
        if (closest >= 0)
            pair.visitAround(pair.targetCorner[closest] / 4, pair.targetCorner[closest] % 4,
                             [&](Index face) {
                                 Candidate<Work> candidate;
                                 if (isPartner(pair, i, face, candidate))
                                     found.add(candidate, 0, 1);
                                 return true;
                             });
        SlotChoice<Precision>{pair, i}.enter(found, aroundCurved);
    }

private:
    FPM_KERNEL bool hasCorner(Index face, Index target) const
    {
        const Index* corner = pair.faceNode + 4 * std::size_t(face < 0 ? 0 : face);
        const Index node = pair.targetNode(target);
        return face >= 0
               && (corner[0] == node || corner[1] == node || corner[2] == node
                   || corner[3] == node);
    }
    FPM_KERNEL Index closestTarget(Index i) const
    {
        const Index node = pair.contactor[i];
        std::int64_t cell[3];
        for (int c = 0; c < 3; ++c)
            cell[c] = CellLists::cellOf(
                double(pair.position[c * pair.nodeStride + std::size_t(node)]), cells.cellSize);
        Index closest = -1;
        Work best = 0;
        for (int near = 0; near < 27; ++near) {
            const Index* list = cells.list(cell[0] + near % 3 - 1, cell[1] + near / 3 % 3 - 1,
                                           cell[2] + near / 9 - 1);
            for (Index k = *list; k >= 0; k = cells.entries[k].next) {
                const Vec3<Work> r = pair.relative(pair.targetNode(k), node);
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
