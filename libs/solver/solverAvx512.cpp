#include "solver/cpuInstance.h"

namespace fpm {

std::unique_ptr<Solver> makeAvx512Solver(const Model& model, int threads, bool audit)
{
    return makeCpuSolver<512>(model, threads, audit, "avx512");
}

} // namespace fpm
