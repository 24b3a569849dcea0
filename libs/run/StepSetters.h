#pragma once

#include "base/Log.h"
#include "mesh/SmallElements.h"
#include "solver/Solver.h"

namespace fpm {

/// The few elements that set the time step of a run, what they cost, and the price of mass scaling
/// instead of larger elements.
struct StepSetters {
    SmallElements elements; ///< sizes are stable steps [time]
    struct Price {
        double addedMass;  ///< share of the mass of all deformable parts
        double targetStep; ///< massScaling.targetStep that adds it
        double saves;      ///< how many times fewer steps
    };
    std::vector<Price> prices; ///< at 1 % and 5 % of added mass
};

/// Of the mesh as it is read, mass scaling included; nothing where no few elements set the step.
std::optional<StepSetters> stepSetters(const Solver& solver, const Model& model);

/// Logs them, their cost and the remedies; no line where there are none.
void reportStepSetters(const std::optional<StepSetters>& setters, Log& log);

} // namespace fpm
