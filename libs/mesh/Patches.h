#pragma once

#include "mesh/Mesh.h"

#include <cstdint>

namespace fpm {

inline constexpr Index maxPatchElements = 256;
/// Most elements of a mesh: 8 corners each must still be numbered in 32 bits.
inline constexpr std::size_t maxElements = 0x7fffffff / 8;

/// A run of neighbouring elements of one part with its own node list: what one GPU block or one CPU
/// thread works on at a time. Interior nodes (touched by no other patch) come first; both kinds
/// ascend.
struct Patch {
    Index part;
    Index firstElement, elementCount;
    Index firstSlot; ///< its nodes are slots firstSlot ... firstSlot + nodeCount - 1
    Index interiorCount, nodeCount;
};

struct Patches {
    std::vector<Patch> patches;
    std::vector<Index> slotNode;        ///< node of each slot
    std::vector<std::uint16_t> corners; ///< [8 * element + corner]: node number inside the patch
    std::vector<Index> nodeSlotStart;   ///< slots of a node, ascending patch: CSR offsets ...
    std::vector<Index> nodeSlots;       ///< ... and slots
    /// Element corners around each slot in ascending element order: CSR over slots; entry =
    /// 8 * (element - firstElement) + corner, so that every sum has one order on every machine.
    std::vector<Index> slotCornerStart;
    std::vector<std::uint16_t> slotCorners;
};

/// Builds the lists from mesh.patchStarts; throws Error(mesh) above maxElements.
Patches makePatches(const Mesh& mesh);

/// Reorders elements inside each part (recursive coordinate bisection into compact patches of at
/// most `maxCount`, most of them a multiple of 16), sets patchStarts, and renumbers nodes: patch by
/// patch the interior ones, then all boundary nodes. Sets follow; contact surfaces, which belong to
/// one numbering, are dropped, and so are nodes without element. Returns the new number of every
/// old node (-1 = dropped).
std::vector<Index> renumber(Mesh& mesh, Index maxCount = maxPatchElements);

} // namespace fpm
