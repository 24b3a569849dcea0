#include "base/Error.h"
#include "bench/copy.h"
#include "parallel/CpuExecutor.h"

namespace fpm::bench {

Bandwidth bandwidthOfGpu(Index, int)
{
    throw Error(ExitCode::device, "this build has no CUDA backend", "build with FPM_CUDA=ON");
}

} // namespace fpm::bench
