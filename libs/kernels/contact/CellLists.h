#pragma once

#include "kernels/contact/ContactPassView.h"
#include "parallel/Atomic.h"

namespace fpm {

/// An entry of a list: the next one, -1: none, and the cell it was entered for.
struct CellEntry {
    Index next;
    std::uint32_t cell;
};

/// Cubic cells kept in a hash table of linked lists, so that a stray node far away costs nothing.
/// Cells of level l are 2^l times as wide. A face is entered once, where the middle of its box
/// lies, on a level whose cells are half as wide as the box or wider: whoever is in the box finds
/// it in his own cell or one of the 26 around. Level `levels` is one cell for all that no other
/// would hold. Entries that share a list by chance are told apart by their cells.
struct CellLists {
    Index* head; ///< [mask + 1], -1: empty; then one a level: that of the last level, and for
                 ///< the others -1 where the level is empty
    CellEntry* entries; ///< [faces or target nodes]
    std::uint32_t mask;
    double cellSize;
    Index levels;
    static constexpr Index mostLevels = 31;

    FPM_KERNEL static std::int64_t cellOf(double coordinate, double size)
    {
        const double cell = ::floor(coordinate / size);
        return cell > -1e15 && cell < 1e15 ? std::int64_t(cell) : 0; // NaN goes to cell 0
    }
    /// Cells in a row along x have lists side by side.
    FPM_KERNEL Index* list(std::int64_t x, std::int64_t y, std::int64_t z, Index level = 0) const
    {
        const std::uint32_t row = std::uint32_t(y) * 19349663u ^ std::uint32_t(z) * 83492791u
                                  ^ std::uint32_t(level) * 2654435761u;
        return head + (((row ^ (row >> 15)) + std::uint32_t(x)) & mask);
    }
    /// Tells a cell from its neighbours, from all other levels and from most others.
    FPM_KERNEL static std::uint32_t
    nameOf(std::int64_t x, std::int64_t y, std::int64_t z, Index level)
    {
        return (std::uint32_t(x) & 511u) | (std::uint32_t(y) & 511u) << 9
               | (std::uint32_t(z) & 511u) << 18 | std::uint32_t(level) << 27;
    }
    FPM_KERNEL Index* listOfLevel(Index level) const
    {
        return head + (std::size_t(mask) + 1 + level);
    }

    /// found(face) for the faces whose boxes, as they were entered, hold the node, and others.
    template <class Numbers, class Found>
    FPM_KERNEL void
    forEachFace(const ContactPassView<Numbers>& pass, Index node, const Found& found) const
    {
        double size = cellSize;
        for (Index level = 0; level < levels; ++level, size += size) {
            if (*listOfLevel(level) < 0) continue;
            std::int64_t cell[3];
            for (int c = 0; c < 3; ++c)
                cell[c] =
                    cellOf(double(pass.position[c * pass.nodeStride + std::size_t(node)]), size);
            for (int near = 0; near < 27; ++near) {
                const std::int64_t x = cell[0] + near % 3 - 1, y = cell[1] + near / 3 % 3 - 1,
                                   z = cell[2] + near / 9 - 1;
                const std::uint32_t name = nameOf(x, y, z, level);
                for (Index face = *list(x, y, z, level); face >= 0; face = entries[face].next)
                    if (entries[face].cell == name) found(face);
            }
        }
        for (Index face = *listOfLevel(levels); face >= 0; face = entries[face].next) found(face);
    }
    FPM_KERNEL void insert(Index entry, Index* into, std::uint32_t cell) const
    {
        entries[entry] = {atomicExchangeIndex(into, entry), cell};
    }
};

/// Enters a target face into the cell where the middle of its box lies, its margin included, on the
/// first level whose cells are at least half as wide as the box (`search faces`).
template <class Numbers>
struct InsertFace {
    ContactPassView<Numbers> pass;
    CellLists cells;

    FPM_KERNEL void operator()(Index face) const
    {
        double middle[3], widest = 0;
        const double margin = double(pass.margin(face));
        for (int c = 0; c < 3; ++c) {
            double least = 1e300, most = -1e300;
            for (int k = 0; k < 4; ++k) {
                const std::size_t node = std::size_t(pass.faceNode[4 * std::size_t(face) + k]);
                const double x = double(pass.position[c * pass.nodeStride + node]);
                least = x < least ? x : least;
                most = x > most ? x : most;
            }
            middle[c] = 0.5 * (least + most);
            const double wide = most - least + 2 * margin;
            widest = wide > widest ? wide : widest;
        }
        double size = cells.cellSize;
        Index level = 0;
        for (; level < cells.levels && !(2 * size > 1.000001 * widest); ++level) size += size;
        Index* last = cells.listOfLevel(level);
        if (level == cells.levels) {
            cells.insert(face, last, 0);
            return;
        }
        std::int64_t cell[3];
        for (int c = 0; c < 3; ++c) cell[c] = CellLists::cellOf(middle[c], size);
        cells.insert(face, cells.list(cell[0], cell[1], cell[2], level),
                     CellLists::nameOf(cell[0], cell[1], cell[2], level));
        if (atomicLoadIndex(last) < 0) atomicExchangeIndex(last, face); // whichever: there are some
    }
};

/// Enters a target node into its cell (`search closestParticle`, the paper's connected list).
template <class Numbers>
struct InsertTarget {
    ContactPassView<Numbers> pass;
    CellLists cells;

    FPM_KERNEL void operator()(Index i) const
    {
        const std::size_t node = std::size_t(pass.targetNode(i));
        std::int64_t cell[3];
        for (int c = 0; c < 3; ++c)
            cell[c] = CellLists::cellOf(double(pass.position[c * pass.nodeStride + node]),
                                        cells.cellSize);
        cells.insert(i, cells.list(cell[0], cell[1], cell[2]), 0);
    }
};

} // namespace fpm
