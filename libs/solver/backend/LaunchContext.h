#pragma once

#include "solver/SolverFields.h"
#include "solver/clock/StepSettings.h"

namespace fpm {

/// What launches refer to: the executor, and what the solver owns. All outlive them.
template <class Executor>
struct LaunchContext {
    Executor& executor;
    const SolverSetUp& setUp;
    SolverFields& fields;
    const StepSettings& settings;
};

} // namespace fpm
