#include "base/Error.h"
#include "base/Format.h"
#include "solver/backend/builtExecutors.h"
#include "solver/backend/machines.h"

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

/// The widest vectors that the processor and this build have.
std::string widest()
{
    if (std::ranges::count(builtWidths, 512) > 0 && cpuHas("avx512")) return "avx512";
    return std::ranges::count(builtWidths, 256) > 0 ? "avx2" : "scalar";
}

Machine machineFor(const Control& control)
{
    if (control.backend == "cuda") return makeCudaMachine(control);
    std::string simd = control.simd;
    if (simd == "auto") simd = widest();
    if (simd != "scalar" && !cpuHas(simd))
        throw Error(ExitCode::device, format("this processor has no {}", simd), "use simd auto;");
    return makeCpuMachine(control, simd, threadCount(control));
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
    return std::make_unique<Solver>(model, machineFor(model.control), audit);
}

} // namespace fpm
