#pragma once

#include "solver/Solver.h"

#include <string>

namespace fpm {

/// `simd`: scalar, avx2 or avx512, whatever the processor can.
Machine makeCpuMachine(const Control& control, const std::string& simd, int threads);
/// Throws Error(device) without a GPU that works or in a build without CUDA.
Machine makeCudaMachine(const Control& control);
/// Name of the GPU; throws as makeCudaMachine.
std::string cudaDeviceName();

} // namespace fpm
