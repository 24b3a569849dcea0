#include "base/Error.h"
#include "base/Format.h"
#include "solver/IdleCores.h"
#include "solver/instances.h"

#include <omp.h>

namespace fpm {

namespace {

bool cpuHas(const std::string& simd)
{
    if (simd == "avx512")
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
               && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

} // namespace

int threadCount(const Control& control)
{
    if (control.backend != "openmp") return 1;
    if (control.threads > 0) return control.threads;
    return followsIdleCores(control) ? int(ownCores().size()) : omp_get_max_threads();
}

std::unique_ptr<Solver> makeSolver(const Model& model, bool audit)
{
    const Control& control = model.control;
    if (control.backend == "cuda") return makeCudaSolver(model, audit);
    std::string simd = control.simd;
    if (simd == "auto") simd = cpuHas("avx512") ? "avx512" : "avx2";
    if (!cpuHas(simd))
        throw Error(ExitCode::device, format("this processor has no {}", simd), "use simd auto;");
    if (simd == "avx512") return makeAvx512Solver(model, threadCount(control), audit);
    if (simd == "avx2") return makeAvx2Solver(model, threadCount(control), audit);
    return makeScalarSolver(model, threadCount(control), audit);
}

} // namespace fpm
