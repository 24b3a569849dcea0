#include "solver/elements/PatchTables.h"

#include <algorithm>

namespace fpm {

static_assert(patchCapacity == maxPatchElements, "patches of a mesh fit the kernels' tables");

namespace {

using Table = std::vector<std::uint16_t>;

/// In tiles of 8. Places beyond the last element repeat it: harmless work, no branch in the kernel.
Table tiledCorners(const Patches& patches, const Patch& patch)
{
    const Index stride = (patch.elementCount + tileWidth - 1) / tileWidth * tileWidth;
    Table out(8 * std::size_t(stride));
    for (Index e = 0; e < stride; ++e) {
        const Index element = patch.firstElement + std::min(e, patch.elementCount - 1);
        for (Index corner = 0; corner < 8; ++corner)
            out[inTiles(e, 8) + std::size_t(corner * tileWidth)] =
                patches.corners[8 * std::size_t(element) + std::size_t(corner)];
    }
    return out;
}

Index append(std::vector<std::uint16_t>& to, const Table& table)
{
    const Index place = Index(to.size());
    to.insert(to.end(), table.begin(), table.end());
    return place;
}

} // namespace

void PatchTables::add(SolverSetUp& data,
                      PatchHeader& header,
                      const Patches& patches,
                      const Patch& patch)
{
    std::array<Table, 3> tables{tiledCorners(patches, patch), {}, {}};
    const auto starts = patches.slotCornerStart.begin() + patch.firstSlot;
    for (Index slot = 0; slot <= patch.nodeCount; ++slot)
        tables[1].push_back(std::uint16_t(starts[slot] - starts[0]));
    for (Index k = starts[0]; k < starts[patch.nodeCount]; ++k) {
        const std::uint16_t entry = patches.slotCorners[std::size_t(k)];
        tables[2].push_back(std::uint16_t((entry & 7) * patchCapacity + (entry >> 3)));
    }
    auto found = known_.find(tables);
    if (found == known_.end()) {
        const Places places{append(data.elements.corners, tables[0]),
                            append(data.elements.cornerStarts, tables[1]),
                            append(data.elements.slotCorners, tables[2])};
        found = known_.emplace(std::move(tables), places).first;
    }
    header.corners = found->second.corners;
    header.cornerStarts = found->second.cornerStarts;
    header.slotCorners = found->second.slotCorners;
}

} // namespace fpm
