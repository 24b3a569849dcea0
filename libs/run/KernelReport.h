#pragma once

#include "model/Model.h"
#include "solver/Solver.h"

namespace fpm {

/// Which kernels a run will use, a line each for logs: of parts with the same element kernel, of
/// rigid parts, of every contact pair. What a part or pair has no use for is not among them.
std::vector<std::string> kernelLines(const Solver& solver, const Model& model);

} // namespace fpm
