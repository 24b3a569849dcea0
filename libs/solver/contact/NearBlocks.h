#pragma once

#include "solver/SetUp.h"

namespace fpm {

/// Neighbour blocks: which blocks of contact nodes the list check has to compare (ListCheck). For
/// every pass that searches faces; the host rebuilds them with all lists of a pass.
class NearBlocks
{
public:
    /// Positions of the contact nodes, in three planes.
    using Positions = std::vector<double>;

    /// Lists of blocks of contact nodes, one after the other.
    struct BlockLists {
        std::vector<Index> starts{0}, blocks; ///< CSR
    };
    struct Pass {
        std::size_t number = 0; ///< among all passes
        double reach = 0;
        double thickness = 0;                 ///< the largest of the target
        std::vector<Index> contactor, target; ///< contact nodes
        std::size_t nodesEach = 1;            ///< of a contactor: a segment of an edge has two
        std::vector<Index> faces;             ///< [4 * face + corner], contact nodes
        std::vector<Index> allOwn, allTarget; ///< blocks of contact nodes of either side
        BlockLists own, near; ///< of each block of contactors: its own, the target's near it
    };

    NearBlocks() = default;
    explicit NearBlocks(const SolverSetUp& data);

    const std::vector<Pass>& passes() const { return passes_; }
    /// Rebuilds the neighbours of a pass (of passes()), whose lists were rebuilt at these
    /// positions.
    void rebuild(std::size_t place, const Positions& positions);
    /// Neighbours of a pass as they were; `blocks` may be longer than starts say. Throws
    /// Error(checkpoint) for numbers that no rebuild makes.
    void
    restore(std::size_t place, const std::vector<Index>& starts, const std::vector<Index>& blocks);
    /// Blocks of contact nodes that contactors of more than one thread may push until the pass is
    /// rebuilt, 1 each. Thread t has the blocks of contactors from starts[t] on.
    std::vector<std::uint8_t> sharedBlocks(std::size_t place,
                                           const std::vector<Index>& starts) const;

private:
    std::vector<Pass> passes_;
};

} // namespace fpm
