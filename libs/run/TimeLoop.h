#pragma once

#include "base/Log.h"
#include "run/Checkpoint.h"
#include "run/ControlWatch.h"
#include "solver/Solver.h"

#include <chrono>
#include <filesystem>

namespace fpm {

struct RunOptions {
    std::int64_t maxSteps = -1; ///< where not negative, the run ends after so many
    bool strict = false;        ///< what the run finds fault with is an Error(unhealthy)
    bool waitsForRoom = false;  ///< on a full disk, in place of Error(fileIo)
    /// What the solver was restored from; null: it was started.
    const Checkpoint* from = nullptr;
    RunInputs inputs = {};      ///< stored in checkpoints
    ControlSource control = {}; ///< read again while the run goes on
    /// What maxWallTime counts from.
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
};

/// Runs a started or restored solver to the end time: histories, frames, checkpoints, energy
/// balance, progress line; writes `status`, performance and health into the folder `caseRoot`,
/// whose lock the caller holds. Throws Error(numericalStop) after writing why.txt when an element
/// inverts or the balance is lost, Error(stopped) once a checkpoint is written on a signal, at
/// maxWallTime or as stopAt says.
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
