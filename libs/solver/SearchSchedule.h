#pragma once

#include "solver/SolverData.h"

namespace fpm {

/// When passes of contact pairs have to search again. Their lists are valid while no contactor and
/// no face of theirs can have come closer by more than the reach: by the largest way of the
/// contactors plus that of the target since the last search and in the coming steps (method of
/// Verlet). Each pass has ways of its own: what is far from an impact need not search for its sake.
class SearchSchedule
{
public:
    /// What ContactTravel found, [block][2]: squares of the way since the positions were
    /// remembered, and of the speed.
    using Travel = std::vector<double>;

    struct Plan {
        std::vector<std::size_t> due; ///< passes to be searched now
        std::int64_t steps;           ///< that may follow; at least one
    };

    SearchSchedule() = default;
    explicit SearchSchedule(const SolverData& data);

    /// Plans `steps` steps of `timeStep` at most; what is due counts as searched from now on. With
    /// anything due, the positions are to be remembered.
    Plan plan(const Travel& travel, double timeStep, std::int64_t steps);
    /// All passes have searched, the positions are remembered.
    void restart();

private:
    struct Pass {
        std::size_t number;
        double reach;
        std::vector<Index> contactorBlocks, targetBlocks;
        double way = 0; ///< between its last search and the remembered positions
    };
    std::vector<Pass> passes_;
};

} // namespace fpm
