#pragma once

#include "fields/NumberField.h"
#include "solver/backend/BackendOf.h"
#include "solver/backend/LaunchContext.h"
#include "solver/backend/machines.h"

namespace fpm {

/// All kernels for one executor and precision.
template <class Numbers, class Executor>
Machine machineOf(Executor executor, std::string description)
{
    auto backend = std::make_unique<BackendOf<Executor>>(std::move(executor));
    Executor& on = backend->executor();
    return {std::move(description), std::move(backend), numberTypes<Numbers>(),
            [&on](const SolverSetUp& setUp, SolverFields& fields, const StepSettings& settings) {
                const LaunchContext<Executor> context{on, setUp, fields, settings};
                return Launches{
                    makeElementLaunches<Numbers>(context), makeMotionLaunches<Numbers>(context),
                    makeContactLaunches<Numbers>(context), makeListLaunches<Numbers>(context)};
            }};
}

} // namespace fpm
