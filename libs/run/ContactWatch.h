#pragma once

#include "base/Log.h"
#include "solver/Solver.h"

namespace fpm {

/// Says which contactors lie inside their target before the run.
void reportOverlaps(const Solver& solver, const Model& model, Log& log);

/// Warns of what contact lost or had to correct.
void reportContact(Solver& solver, const Model& model, Log& log);

} // namespace fpm
