#pragma once

#include "kernels/contact/PairView.h"

namespace fpm {

/// Cubic cells kept in a hash table of linked lists (head, next), so that a stray node far away
/// costs nothing. Entries that share a hash by chance only lengthen a list.
struct CellLists {
    Index* head; ///< [mask + 1], -1: empty
    Index* next; ///< [entries]
    std::uint32_t mask;
    double cellSize;

    FPM_KERNEL static std::int64_t cellOf(double coordinate, double size)
    {
        const double cell = ::floor(coordinate / size);
        return cell > -1e15 && cell < 1e15 ? std::int64_t(cell) : 0; // NaN goes to cell 0
    }
    FPM_KERNEL Index* list(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        const std::uint32_t key = std::uint32_t(x) * 73856093u ^ std::uint32_t(y) * 19349663u
                                  ^ std::uint32_t(z) * 83492791u;
        return head + ((key ^ (key >> 15)) & mask);
    }
    FPM_KERNEL void insert(Index entry, std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        next[entry] = atomicExchangeIndex(list(x, y, z), entry);
    }
};

/// Mean unit normal of the contactor's own faces: faces that look the same way are no partners.
template <class Precision>
struct ContactorNormal {
    PairView<Precision> pair;

    FPM_KERNEL void operator()(Index i) const
    {
        using Work = typename Precision::Work;
        Vec3<Work> sum{0, 0, 0};
        for (Index k = pair.ownFaceStart[i]; k < pair.ownFaceStart[i + 1]; ++k) {
            const Index* nodes = pair.ownFaceNode + 4 * std::size_t(k);
            const Vec3<Work> d1 = pair.relative(nodes[2], nodes[0]),
                             d2 = pair.relative(nodes[3], nodes[1]);
            const Vec3<Work> n = cross(d1, d2);
            const Work length = squareRoot(dot(n, n));
            if (length > 0) sum += (Work(1) / length) * n;
        }
        const Work length = squareRoot(dot(sum, sum));
        const Work scale = length > 0 ? Work(1) / length : Work(0);
        pair.ownNormal[i] = scale * sum.x;
        pair.ownNormal[pair.contactorCount + i] = scale * sum.y;
        pair.ownNormal[2 * pair.contactorCount + i] = scale * sum.z;
    }
};

/// Enters a target face into every cell its box, inflated by its margin, touches: at most 8, since
/// a cell is at least as large as the largest inflated box (`search faces`).
template <class Precision>
struct InsertFace {
    PairView<Precision> pair;
    CellLists cells;

    FPM_KERNEL void operator()(Index face) const
    {
        std::int64_t low[3], high[3];
        const double margin = double(pair.margin(face));
        for (int c = 0; c < 3; ++c) {
            double least = 1e300, most = -1e300;
            for (int k = 0; k < 4; ++k) {
                const std::size_t node = std::size_t(pair.faceNode[4 * std::size_t(face) + k]);
                const double x = double(pair.position[c * pair.nodeStride + node]);
                least = x < least ? x : least;
                most = x > most ? x : most;
            }
            low[c] = CellLists::cellOf(least - margin, cells.cellSize);
            high[c] = CellLists::cellOf(most + margin, cells.cellSize);
            if (high[c] > low[c] + 1) high[c] = low[c] + 1;
        }
        Index entry = 8 * face;
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t x = low[0]; x <= high[0]; ++x) cells.insert(entry++, x, y, z);
    }
};

/// Nearest face by true distance to the (clamped) closest point; equal distances: lower number.
template <class Precision>
struct FaceChoice {
    using Work = typename Precision::Work;
    Index face = noFace;
    Work distanceSquare = 0, xi = 0, eta = 0;

    FPM_KERNEL void consider(const PairView<Precision>& pair, Index i, Index candidate)
    {
        const FaceCorners<Work> corners = pair.corners(candidate, pair.contactor[i]);
        Work xiHere = 0, etaHere = 0;
        project(corners, xiHere, etaHere);
        xiHere = clampedUnit(xiHere);
        etaHere = clampedUnit(etaHere);
        const Projection<Work> at = gapAt(corners, xiHere, etaHere);
        // Surfaces in contact look at each other.
        if (!(dot(at.normal, pair.ownNormalOf(i)) < Work(-0.01))) return;
        const Work square = dot(at.offset, at.offset);
        const Work depth = Work(0.5) * pair.faceThickness[candidate];
        const bool within = square <= pair.reach * pair.reach || (at.gap < 0 && -at.gap <= depth);
        if (!within) return;
        if (face >= 0
            && !(square < distanceSquare || (square == distanceSquare && candidate < face)))
            return;
        face = candidate;
        distanceSquare = square;
        xi = xiHere;
        eta = etaHere;
    }
    /// A contactor in touch keeps its face where the search finds nothing better.
    FPM_KERNEL void keep(const PairView<Precision>& pair, Index i) const
    {
        const bool touching = pair.face[i] >= 0 && pair.law.spring[i] > 0;
        if (face < 0 && touching) return;
        if (face >= 0 && face == pair.face[i]) return; // tracked already, warm start kept
        pair.face[i] = face;
        pair.xi[i] = xi;
        pair.eta[i] = eta;
    }
};

/// `search faces`: the contactor tests every face entered into its own cell.
template <class Precision>
struct FindFace {
    PairView<Precision> pair;
    CellLists cells;

    FPM_KERNEL void operator()(Index i) const
    {
        const std::size_t node = std::size_t(pair.contactor[i]);
        std::int64_t cell[3];
        for (int c = 0; c < 3; ++c)
            cell[c] = CellLists::cellOf(double(pair.position[c * pair.nodeStride + node]),
                                        cells.cellSize);
        FaceChoice<Precision> choice;
        for (Index entry = *cells.list(cell[0], cell[1], cell[2]); entry >= 0;
             entry = cells.next[entry]) {
            const Index face = entry / 8;
            if (nearBox(face, pair.contactor[i])) choice.consider(pair, i, face);
        }
        choice.keep(pair, i);
    }

private:
    /// The face's box, inflated by reach (or half its thickness), holds the contactor.
    FPM_KERNEL bool nearBox(Index face, Index origin) const
    {
        using Work = typename Precision::Work;
        const FaceCorners<Work> f = pair.corners(face, origin);
        const Work margin = pair.margin(face);
        const Vec3<Work>* x = f.corner;
        return outside(x[0].x, x[1].x, x[2].x, x[3].x, margin) == 0
               && outside(x[0].y, x[1].y, x[2].y, x[3].y, margin) == 0
               && outside(x[0].z, x[1].z, x[2].z, x[3].z, margin) == 0;
    }
    template <class Work>
    FPM_KERNEL static int outside(Work a, Work b, Work c, Work d, Work margin)
    {
        const bool above = a > margin && b > margin && c > margin && d > margin;
        const bool below = a < -margin && b < -margin && c < -margin && d < -margin;
        return above || below;
    }
};

/// Enters a target node into its cell (`search closestParticle`, the paper's connected list).
template <class Precision>
struct InsertTarget {
    PairView<Precision> pair;
    CellLists cells;

    FPM_KERNEL void operator()(Index i) const
    {
        const std::size_t node = std::size_t(pair.target[i]);
        std::int64_t cell[3];
        for (int c = 0; c < 3; ++c)
            cell[c] = CellLists::cellOf(double(pair.position[c * pair.nodeStride + node]),
                                        cells.cellSize);
        cells.insert(i, cell[0], cell[1], cell[2]);
    }
};

/// The paper's search: closest target particle in the contactor's cell and its 26 neighbours (equal
/// distances: lower number), then the faces around that particle.
template <class Precision>
struct FindClosestParticle {
    PairView<Precision> pair;
    CellLists cells;

    FPM_KERNEL void operator()(Index i) const
    {
        using Work = typename Precision::Work;
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
            for (Index k = *list; k >= 0; k = cells.next[k]) {
                const Vec3<Work> r = pair.relative(pair.target[k], node);
                const Work square = dot(r, r);
                if (closest < 0 || square < best || (square == best && k < closest)) {
                    closest = k;
                    best = square;
                }
            }
        }
        FaceChoice<Precision> choice;
        if (closest >= 0)
            for (Index k = pair.targetFaceStart[closest]; k < pair.targetFaceStart[closest + 1];
                 ++k)
                choice.consider(pair, i, pair.targetFaces[k]);
        choice.keep(pair, i);
    }
};

} // namespace fpm
