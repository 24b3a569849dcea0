#pragma once

#include "parallel/CpuExecutor.h"
#include "solver/ExplicitSolver.h"
#include "solver/instances.h"

namespace fpm {

template <class Numbers, int Bits>
std::unique_ptr<Solver> makeCpu(const Model& model, int threads, bool audit, const char* simd)
{
    const std::string description =
        model.control.backend + (followsIdleCores(model.control) ? ", up to " : ", ")
        + std::to_string(threads) + (threads == 1 ? " thread, " : " threads, ") + simd + ", "
        + Numbers::name;
    // Enough for the largest patch a mesh may have (2048 nodes).
    const std::size_t scratch =
        std::max({elementScratch<typename Numbers::Work>(2048), nodeScratch(), bodyScratch(),
                  relaxationScratch(), PassListCheck::scratch(), PassSums::scratch()});
    return std::make_unique<ExplicitSolver<Numbers, CpuExecutor<Bits>>>(
        model, CpuExecutor<Bits>(threads, scratch), description, audit);
}

template <int Bits>
std::unique_ptr<Solver> makeCpuSolver(const Model& model, int threads, bool audit, const char* simd)
{
    switch (model.control.precision) {
    case Precision::single:
        return makeCpu<SinglePrecision, Bits>(model, threads, audit, simd);
    case Precision::mixed:
        return makeCpu<MixedPrecision, Bits>(model, threads, audit, simd);
    case Precision::double_:
        break;
    }
    return makeCpu<DoublePrecision, Bits>(model, threads, audit, simd);
}

} // namespace fpm
