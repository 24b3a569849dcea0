#include "bench/copy.h"
#include "parallel/CudaExecutor.h"
#include "solver/backend/machines.h"

namespace fpm::bench {

Bandwidth bandwidthOfGpu(Index count, int repeats)
{
    cudaDeviceName(); // refuses a machine without a GPU
    return bandwidth(CudaExecutor(1, 0), count, repeats);
}

} // namespace fpm::bench
