#include "solver/cpuInstance.h"

namespace fpm {

std::unique_ptr<Solver> makeAvx2Solver(const Model& model, int threads, bool audit)
{
    return makeCpuSolver<256>(model, threads, audit, "avx2");
}

} // namespace fpm
