#pragma once

#include "solver/Solver.h"

#include <string>

namespace fpm {

/// Doors to the translation units of each vector width and of CUDA.
std::unique_ptr<Solver> makeScalarSolver(const Model& model, int threads, bool audit);
std::unique_ptr<Solver> makeAvx2Solver(const Model& model, int threads, bool audit);
std::unique_ptr<Solver> makeAvx512Solver(const Model& model, int threads, bool audit);
std::unique_ptr<Solver> makeCudaSolver(const Model& model, bool audit);
/// Name of the GPU; throws Error(device) when there is none that works.
std::string cudaDeviceName();

} // namespace fpm
