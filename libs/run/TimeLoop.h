#pragma once

#include "base/Log.h"
#include "solver/Solver.h"

#include <filesystem>

namespace fpm {

struct RunOptions {
    std::int64_t maxSteps = -1; ///< where not negative, the run ends after so many
    bool strict = false;        ///< what the run finds fault with is an Error(unhealthy)
};

/// Runs a started solver to the end time: histories, frames, energy balance, progress line; writes
/// `status`, performance and health into the folder `caseRoot`, whose lock the caller holds. Throws
/// Error(numericalStop) after writing why.txt when an element inverts or the balance is lost,
/// Error(stopped) on SIGINT or SIGTERM.
void runTimeLoop(Solver& solver,
                 const Model& model,
                 const std::filesystem::path& caseRoot,
                 const RunOptions& options,
                 Log& log);

/// What -dryRun prints: kernels this scene needs and those it leaves out, counts, the first time
/// step and what limits it, and the forecast of steps, frames, disk, memory and time (measured over
/// a few steps).
void reportDryRun(Solver& solver,
                  const Model& model,
                  const std::filesystem::path& caseRoot,
                  Log& log);

} // namespace fpm
