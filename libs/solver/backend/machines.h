#pragma once

#include "solver/Solver.h"

#include <string>

namespace fpm {

/// `simd`: scalar, avx2 or avx512, whatever the processor can.
Machine makeCpuMachine(const Control& control, const std::string& simd, int threads);
/// Throws Error(device) without a GPU that works or in a build without CUDA.
Machine makeCudaMachine(const Control& control);
/// Makes GPU `number` the one that this thread uses, and returns its name; throws as
/// makeCudaMachine, also where there is no such number.
std::string useCudaDevice(int number);

} // namespace fpm
