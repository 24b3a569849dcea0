#pragma once

#include "solver/SetUp.h"

#include <array>
#include <map>

namespace fpm {

/// Which corners of its elements meet at which of its nodes, by the patch's own numbers: the same
/// for patches of one shape, as in the layers of a plate, which share one copy.
class PatchTables
{
public:
    /// Enters the tables of a patch into the data, unless they are there, and their places into its
    /// header.
    void add(SolverSetUp& data, PatchHeader& header, const Patches& patches, const Patch& patch);

private:
    using Table = std::vector<std::uint16_t>;
    struct Places {
        Index corners, cornerStarts, slotCorners;
    };
    std::map<std::array<Table, 3>, Places> known_;
};

} // namespace fpm
