#pragma once

#include "base/Log.h"
#include "solver/Solver.h"

namespace fpm {

// Lines at the end of the log.

/// The ledger. No part of a sum stands beside it that could be larger.
void reportEnergies(const Energies& energies, Log& log);
/// Whether dynamic relaxation, where it is asked for, has come to rest.
void reportRest(const StepClock& clock, const Control& control, Log& log);
/// Elements that were deleted, a line a part.
void reportErosion(Solver& solver, const Model& model, Log& log);

} // namespace fpm
