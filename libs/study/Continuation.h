#pragma once

#include "io/OutputFolder.h"

#include <filesystem>
#include <string>

namespace fpm {

/// Whether a run goes on from a checkpoint that an earlier start has left in its copy of the case.
struct Continuation {
    bool goesOn = false;
    std::string why;                        ///< not; empty where nothing was there
    double time = 0;                        ///< of the checkpoint
    double wallSeconds = 0, cpuSeconds = 0; ///< the run has taken up to there
};

/// What a copy has to hold beside its checkpoint.
enum class Frames { needed, notNeeded };

/// A run that was stopped goes on, and so does one to another endTime, from the last checkpoint
/// that a run from the start would pass too: not one whose time steps were cut to meet the end of
/// then. Checkpoints after it are removed from `left`; `wanted` is the case as it is to be run.
/// Both have the same inputs but for endTime, which the caller has compared.
Continuation
continuationOf(const OutputFolder& left, const std::filesystem::path& wanted, Frames frames);

} // namespace fpm
