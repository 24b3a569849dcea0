#pragma once

#include "base/Types.h"

namespace fpm {

// Sizes that kernels, executors and the set-up of a run agree on, each for one meaning. Those of
// sums belong to the results: they say which values are added first. `threadsPerBlock` does not.

/// Steps between two looks of the host at the clock; on a GPU they are recorded as one graph.
inline constexpr std::int64_t stepsPerGraph = 10;

/// Threads of a CUDA thread block.
inline constexpr int threadsPerBlock = 256;

/// Elements of a patch at most: a patch is the work of one team.
inline constexpr Index patchCapacity = 256;

/// Nodes of the model whose sums one team forms.
inline constexpr Index nodeBlock = 256;

/// Contactors of a pass, or contact nodes of the model, that are one team's or one search's work.
inline constexpr Index contactBlock = 256;

/// Least and largest values over a whole model are formed by so many lanes of one team, then by so
/// many groups of lanes; the same in any order.
inline constexpr Index reductionLanes = 256, reductionGroups = 16;

/// Blocks of `size` that hold `count`.
constexpr Index blocksOf(Index count, Index size)
{
    return count / size + (count % size != 0);
}

static_assert(reductionLanes % reductionGroups == 0);

} // namespace fpm
