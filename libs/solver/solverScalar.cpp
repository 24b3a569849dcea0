#include "solver/cpuInstance.h"

namespace fpm {

std::unique_ptr<Solver> makeScalarSolver(const Model& model, int threads, bool audit)
{
    return makeCpuSolver<64>(model, threads, audit, "scalar");
}

} // namespace fpm
