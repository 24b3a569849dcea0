#include "bench/copy.h"
#include "parallel/CudaExecutor.h"
#include "solver/backend/machines.h"

namespace fpm::bench {

Bandwidth bandwidthOfGpu(Index count, int repeats)
{
    useCudaDevice(0); // refuses a machine without a GPU
    return bandwidth(CudaExecutor(), count, repeats);
}

} // namespace fpm::bench
