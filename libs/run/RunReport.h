#pragma once

#include "base/Error.h"
#include "base/Log.h"
#include "case/CheckpointLabel.h"
#include "solver/Solver.h"

namespace fpm {

// Lines at the end of the log.

/// The ledger. No part of a sum stands beside it that could be larger.
void reportEnergies(const Energies& energies, Log& log);
/// Whether dynamic relaxation, where it is asked for, has come to rest.
void reportRest(const StepClock& clock, const Control& control, Log& log);
/// Elements that were deleted, a line a part.
void reportErosion(Solver& solver, const Model& model, Log& log);

/// The line that shows how far a run is: `seconds` after its start, or after it went on from
/// `from`.
std::string progressText(const StepClock& clock,
                         const Control& control,
                         const CheckpointLabel* from,
                         double balance,
                         std::size_t elements,
                         double seconds);

/// An error that leaves the last checkpoint good, that of step `checkpointStep`, says how to go on,
/// a lost device also where there is none (negative).
Error withWayOn(const Error& error, std::int64_t checkpointStep);

} // namespace fpm
