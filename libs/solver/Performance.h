#pragma once

#include "application/Application.h"
#include "solver/Solver.h"

namespace fpm {

/// Logs ns per element-step and the shares of the solvers, and writes
/// postProcessing/performance/0/performance.json.
void reportPerformance(Solver& solver, const Model& model, Run& run);

/// One line on the mass that mass scaling adds; none where there is none.
void reportMassScaling(const Solver& solver, Log& log);

/// "element 17 of part rod: ..." with the smallest stable step, or the one that inverted.
std::string worstElement(Solver& solver, const Model& model);

} // namespace fpm
