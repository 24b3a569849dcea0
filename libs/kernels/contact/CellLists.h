#pragma once

#include "kernels/contact/PairView.h"
#include "parallel/Atomic.h"

namespace fpm {

/// Cubic cells kept in a hash table of linked lists (head, next), so that a stray node far away
/// costs nothing. Entries that share a hash by chance only lengthen a list. Cells of level l are
/// 2^l times as wide; level `levels` is one cell for all that no other would hold.
struct CellLists {
    Index* head; ///< [mask + 1], -1: empty
    Index* next; ///< [entries]
    std::uint32_t mask;
    double cellSize;
    Index levels;

    FPM_KERNEL static std::int64_t cellOf(double coordinate, double size)
    {
        const double cell = ::floor(coordinate / size);
        return cell > -1e15 && cell < 1e15 ? std::int64_t(cell) : 0; // NaN goes to cell 0
    }
    FPM_KERNEL Index* list(std::int64_t x, std::int64_t y, std::int64_t z, Index level = 0) const
    {
        const std::uint32_t key = std::uint32_t(x) * 73856093u ^ std::uint32_t(y) * 19349663u
                                  ^ std::uint32_t(z) * 83492791u
                                  ^ std::uint32_t(level) * 2654435761u;
        return head + ((key ^ (key >> 15)) & mask);
    }
    /// The list that holds the faces near a point on one level.
    template <class Precision>
    FPM_KERNEL Index first(const PairView<Precision>& pair, Index node, Index level) const
    {
        if (level == levels) return *list(0, 0, 0, level);
        double size = cellSize;
        for (Index l = 0; l < level; ++l) size += size;
        const std::size_t n = std::size_t(node);
        return *list(cellOf(double(pair.position[n]), size),
                     cellOf(double(pair.position[pair.nodeStride + n]), size),
                     cellOf(double(pair.position[2 * pair.nodeStride + n]), size), level);
    }
    FPM_KERNEL void insert(Index entry, Index* into) const
    {
        next[entry] = atomicExchangeIndex(into, entry);
    }
};

/// Enters a target face into every cell its box, inflated by its margin, touches: at most 8, on the
/// level whose cells are at least as wide as the box (`search faces`).
template <class Precision>
struct InsertFace {
    PairView<Precision> pair;
    CellLists cells;

    FPM_KERNEL void operator()(Index face) const
    {
        double least[3], most[3], widest = 0;
        const double margin = double(pair.margin(face));
        for (int c = 0; c < 3; ++c) {
            least[c] = 1e300;
            most[c] = -1e300;
            for (int k = 0; k < 4; ++k) {
                const std::size_t node = std::size_t(pair.faceNode[4 * std::size_t(face) + k]);
                const double x = double(pair.position[c * pair.nodeStride + node]);
                least[c] = x < least[c] ? x : least[c];
                most[c] = x > most[c] ? x : most[c];
            }
            least[c] -= margin;
            most[c] += margin;
            widest = most[c] - least[c] > widest ? most[c] - least[c] : widest;
        }
        double size = cells.cellSize;
        Index level = 0;
        for (; level < cells.levels && !(size > 1.000001 * widest); ++level) size += size;
        Index entry = 8 * face;
        if (level == cells.levels) {
            cells.insert(entry, cells.list(0, 0, 0, level));
            return;
        }
        std::int64_t low[3], high[3];
        for (int c = 0; c < 3; ++c) {
            low[c] = CellLists::cellOf(least[c], size);
            high[c] = CellLists::cellOf(most[c], size);
        }
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t x = low[0]; x <= high[0]; ++x)
                    cells.insert(entry++, cells.list(x, y, z, level));
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
        cells.insert(i, cells.list(cell[0], cell[1], cell[2]));
    }
};

} // namespace fpm
