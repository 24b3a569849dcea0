#pragma once

#include "parallel/CudaExecutor.h"
#include "solver/ExplicitSolver.h"
#include "solver/instances.h"

namespace fpm {

template <class Numbers>
std::unique_ptr<Solver> makeCuda(const Model& model, bool audit)
{
    return std::make_unique<ExplicitSolver<Numbers, CudaExecutor>>(
        model, CudaExecutor(1, 0), "cuda, " + cudaDeviceName() + ", " + Numbers::name, audit);
}

std::unique_ptr<Solver> makeCudaDouble(const Model& model, bool audit);
std::unique_ptr<Solver> makeCudaMixed(const Model& model, bool audit);
std::unique_ptr<Solver> makeCudaSingle(const Model& model, bool audit);

} // namespace fpm
