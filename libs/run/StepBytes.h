#pragma once

#include "model/Model.h"
#include "solver/Solver.h"

namespace fpm {

/// Bytes that the elements and nodes of one step must move to or from memory, counted array by
/// array: each value once where patches keep it in cache or shared memory, partial sums of forces
/// once out and once in. Contact, loads and rigid bodies are left out. Over the elements and the
/// time of a step it is the bandwidth the step has used.
std::size_t bytesOfStep(const Solver& solver, Precision precision);

} // namespace fpm
