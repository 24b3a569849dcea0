#pragma once

#include "application/Application.h"
#include "solver/Solver.h"

namespace fpm {

/// Logs ns per element-step and the shares of the solvers, and writes
/// postProcessing/performance/0/performance.json.
void reportPerformance(Solver& solver, const Model& model, Run& run);

/// "element 17 of part rod: ..." with the smallest stable step, or the one that inverted.
std::string worstElement(Solver& solver, const Model& model);

} // namespace fpm
