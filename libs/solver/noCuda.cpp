#include "base/Error.h"
#include "solver/instances.h"

namespace fpm {

std::unique_ptr<Solver> makeCudaSolver(const Model&, bool)
{
    throw Error(ExitCode::device, "this build has no CUDA backend",
                "use -backend openmp or serial, or build where nvcc is found");
}

std::string cudaDeviceName()
{
    throw Error(ExitCode::device, "this build has no CUDA backend");
}

} // namespace fpm
