#include "base/Error.h"
#include "solver/backend/machines.h"

namespace fpm {

Machine makeCudaMachine(const Control&)
{
    throw Error(ExitCode::device, "this build has no CUDA backend",
                "use -backend openmp or serial, or build where nvcc is found");
}

std::string cudaDeviceName()
{
    throw Error(ExitCode::device, "this build has no CUDA backend");
}

} // namespace fpm
