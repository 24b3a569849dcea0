#pragma once

#include "base/Log.h"
#include "solver/Solver.h"

#include <filesystem>

namespace fpm {

/// What a run will need, from its time step and from what one frame holds.
struct RunForecast {
    double step = 0;         ///< the step, as far as it is known [time]
    double steps = 0;        ///< in all; each frame ends one
    double ownSteps = 0;     ///< were there no frames
    double frames = 0;       ///< the one at the start included
    double frameBytes = 0;   ///< one on the disk: file and folder
    double historyBytes = 0; ///< all tables together
    double stateBytes = 0;   ///< checkpoints: one, where they are written by the clock alone
    double freeBytes = 0;    ///< on the disk of the case
    double peakBytes = 0;    ///< memory of this process, at the most
    double memoryBytes = 0;  ///< of the machine that nothing else uses
    double diskBytes() const { return frames * frameBytes + historyBytes + stateBytes; }
    double frameSeconds() const; ///< for all frames, written through to the disk
};

/// `step`: the time step to count with; `maxSteps` >= 0: the run ends by then. From time `from` on.
RunForecast forecastRun(Solver& solver,
                        const Model& model,
                        const std::filesystem::path& caseRoot,
                        double step,
                        std::int64_t maxSteps,
                        double from = 0);

/// Step of a started solver that has made none: of its elements alone, or as controlDict gives it.
double firstStep(const Solver& solver, const Model& model);

/// Step that the last bounds allow, where no frame cuts it short.
double steadyStep(const StepClock& clock, const Control& control);

/// Steps, frames, disk and memory in lines; warns where frames cost more than steps, where the disk
/// cannot hold them and where the memory is too small. `secondsAStep` 0: not known yet.
void reportForecast(const RunForecast& forecast, double secondsAStep, Log& log);

/// The same once the first frame is written, with the elements that set the step; a disk that is
/// too small is an Error(fileIo).
void reportStart(Solver& solver,
                 const Model& model,
                 const std::filesystem::path& caseRoot,
                 std::int64_t maxSteps,
                 Log& log);

/// Why a run will not come to its end in any time that matters; empty where it will. With
/// `maxSteps` >= 0 it ends by these.
std::string endlessReason(const StepClock& clock, const Control& control, std::int64_t maxSteps);

/// Steps to `due` from the present time, at least 1, and no more than an integer holds.
std::int64_t stepsUntil(const StepClock& clock, double due);

} // namespace fpm
