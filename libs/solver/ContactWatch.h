#pragma once

#include "base/Log.h"
#include "solver/Solver.h"

#include <vector>

namespace fpm {

/// Says which contactors lie inside their target before the run.
void reportOverlaps(const Solver& solver, const Model& model, Log& log);

/// Warns of what contact lost or had to correct.
void reportContact(Solver& solver, const Model& model, Log& log);

/// Warns, once a pair (`warned`), of edges that pass through the other surface between their nodes.
void watchEdges(Solver& solver, const Model& model, std::vector<bool>& warned, Log& log);

} // namespace fpm
