#pragma once

#include "kernels/contact/ContactPassView.h"
#include "parallel/Atomic.h"

namespace fpm {

/// Entry of a linked list: the next entry (-1 ends the list) and the cell it was entered for.
struct CellEntry {
    Index next;
    std::uint32_t cell;
};

/// Cell lists of the broad phase: cubic cells of eqs. (12) and (13) of the paper, kept in a hash
/// table of linked lists instead of a bounding box, so that a stray node far away costs no memory.
/// Cells of level l are 2^l times as wide. A face is entered once, in the cell of the centre of its
/// bounding box, on a level whose cells are at least half as wide as that box: every point inside
/// the box finds the face in its own cell or in one of the 26 adjacent ones. Level `levels` is a
/// single cell for all faces that are too large for the others. Cells that share a list by hash
/// collision are told apart by the cell stored with each entry.
struct CellLists {
    Index* head; ///< [mask + 1] first entries of the lists, -1: empty; then one value per level:
                 ///< the list of the last level, and for the others -1 where the level has no entry
    CellEntry* entries; ///< [faces or target nodes]
    std::uint32_t mask;
    double cellSize;
    Index levels;
    static constexpr Index mostLevels = 31;

    /// Index of a cell along one axis, eq. (13) of the paper.
    FPM_KERNEL static std::int64_t cellOf(double coordinate, double size)
    {
        const double cell = ::floor(coordinate / size);
        return cell > -1e15 && cell < 1e15 ? std::int64_t(cell) : 0; // a NaN is entered in cell 0
    }
    /// List of a cell, the index of eq. (12) hashed. Cells that are neighbours along x have
    /// neighbouring lists.
    FPM_KERNEL Index* list(std::int64_t x, std::int64_t y, std::int64_t z, Index level = 0) const
    {
        const std::uint32_t row = std::uint32_t(y) * 19349663u ^ std::uint32_t(z) * 83492791u
                                  ^ std::uint32_t(level) * 2654435761u;
        return head + (((row ^ (row >> 15)) + std::uint32_t(x)) & mask);
    }
    /// Key that distinguishes a cell from its neighbours, from all other levels and from most other
    /// cells.
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

    /// Broad phase: calls found(face) for every face whose bounding box, as it was entered, holds
    /// the node, and for some others.
    template <class Numbers, class Found>
    FPM_KERNEL void
    forEachFace(const ContactPassView<Numbers>& pass, Index node, const Found& found) const
    {
        double x[3];
        for (int c = 0; c < 3; ++c)
            x[c] = double(pass.position[c * pass.nodeStride + std::size_t(node)]);
        forEachEntry(x, found);
    }
    /// The same for a point.
    template <class Found>
    FPM_KERNEL void forEachEntry(const double (&point)[3], const Found& found) const
    {
        double size = cellSize;
        for (Index level = 0; level < levels; ++level, size += size) {
            if (*listOfLevel(level) < 0) continue;
            std::int64_t cell[3];
            for (int c = 0; c < 3; ++c) cell[c] = cellOf(point[c], size);
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
    /// Enters a box into the cell of its middle, on the first level whose cells are at least half
    /// as wide.
    FPM_KERNEL void insertBox(Index entry, const double (&middle)[3], double widest) const
    {
        double size = cellSize;
        Index level = 0;
        for (; level < levels && !(2 * size > 1.000001 * widest); ++level) size += size;
        Index* last = listOfLevel(level);
        if (level == levels) {
            insert(entry, last, 0);
            return;
        }
        std::int64_t cell[3];
        for (int c = 0; c < 3; ++c) cell[c] = cellOf(middle[c], size);
        insert(entry, list(cell[0], cell[1], cell[2], level),
               nameOf(cell[0], cell[1], cell[2], level));
        // Any entry: it only marks the level as used.
        if (atomicLoadIndex(last) < 0) atomicExchangeIndex(last, entry);
    }
    FPM_KERNEL void insert(Index entry, Index* into, std::uint32_t cell) const
    {
        entries[entry] = {atomicExchangeIndex(into, entry), cell};
    }
};

/// Enters a target face into the cell of the centre of its bounding box, margin included, on the
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
        cells.insertBox(face, middle, widest);
    }
};

/// Enters a target node into its cell (`search closestParticle`, the connected list of the paper's
/// section 3.2.2).
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
