#pragma once

#include "kernels/contact/Search.h"
#include "solver/SolverData.h"

namespace fpm {

/// When contactors have to search again. What a search found is valid while no contactor and no
/// face can have come closer by more than the reach: by the largest way of the one plus that of the
/// other since the search and in the coming steps (method of Verlet). Judged for every block of
/// contactor nodes, with those target nodes that were near it when the pass was searched as a
/// whole: what is far from an impact does not search for its sake.
class SearchSchedule
{
public:
    /// Contactor nodes of a pass that search together.
    static constexpr Index blockSize = NodeBlocks::size;

    /// What ContactTravel found, [block of contact nodes][2]: squares of the way since the
    /// positions were remembered, and of the speed.
    using Travel = std::vector<double>;
    /// Positions of the contact nodes, in three planes.
    using Positions = std::vector<double>;

    struct Due {
        std::size_t pass;
        std::vector<Index> blocks; ///< empty: all of them, and `arrange` is asked for
    };
    struct Plan {
        std::vector<Due> due; ///< to be searched now; then the positions are to be remembered
        std::int64_t steps;   ///< that may follow; at least one
    };

    SearchSchedule() = default;
    explicit SearchSchedule(const SolverData& data);

    /// Plans `steps` steps of `timeStep` at most; what is due counts as searched from now on.
    Plan plan(const Travel& travel, double timeStep, std::int64_t steps);
    /// The pass was searched as a whole at these positions.
    void arrange(std::size_t pass, const Positions& positions);
    /// Blocks of contact nodes that contactors of more than one thread may push until the pass is
    /// arranged again, 1 each. Thread t has the blocks of contactors from starts[t] on.
    std::vector<std::uint8_t> sharedBlocks(std::size_t pass,
                                           const std::vector<Index>& starts) const;

private:
    struct Block {
        std::vector<Index> own, near; ///< blocks of contact nodes: its own, the target's near it
        double way = 0;               ///< between its last search and the remembered positions
    };
    struct Pass {
        std::size_t number = 0;
        double reach = 0;
        double thickness = 0;                 ///< the largest of the target
        std::vector<Index> contactor, target; ///< contact nodes
        std::vector<Index> faces;             ///< [4 * face + corner], contact nodes
        std::vector<Index> own, all;          ///< blocks of contact nodes of either side
        std::vector<Block> blocks;
        double way = 0; ///< of all, since it was arranged
    };
    void remember(const Travel& travel, const std::vector<Due>& due);

    std::vector<Pass> passes_;
};

} // namespace fpm
