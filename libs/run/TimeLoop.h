#pragma once

#include "application/Application.h"
#include "solver/Solver.h"

namespace fpm {

/// Runs a started solver to the end time: histories, frames, energy balance, progress line; writes
/// `status` and postProcessing/performance. Throws Error(numericalStop) after writing why.txt when
/// an element inverts or the balance is lost, Error(stopped) on SIGINT or SIGTERM. `maxSteps` >= 0
/// ends the run early.
void runTimeLoop(Solver& solver, const Model& model, Run& run, std::int64_t maxSteps = -1);

/// What -dryRun prints: kernels this scene needs and those it leaves out, counts, the first time
/// step and what limits it, and the forecast of steps, frames, disk, memory and time (measured over
/// a few steps).
void reportDryRun(Solver& solver, const Model& model, Run& run);

} // namespace fpm
