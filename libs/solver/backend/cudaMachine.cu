#include "base/Format.h"
#include "parallel/CudaExecutor.h"
#include "solver/backend/machineOf.h"

namespace fpm {

std::string cudaDeviceName()
{
    int count = 0;
    const cudaError_t status = cudaGetDeviceCount(&count);
    if (status != cudaSuccess || count == 0)
        throw Error(ExitCode::device,
                    format("no usable GPU: {}",
                           status == cudaSuccess ? "none found" : cudaGetErrorString(status)),
                    "use -backend openmp or serial, or check the driver with nvidia-smi");
    cudaDeviceProp properties{};
    checkCuda(cudaGetDeviceProperties(&properties, 0), "device properties");
    return properties.name;
}

Machine makeCudaMachine(const Control& control)
{
    // Refuses a machine without a GPU before anything is allocated.
    const std::string description = "cuda, " + cudaDeviceName() + ", ";
    switch (control.precision) {
    case Precision::single:
        return machineOf<SinglePrecision>(CudaExecutor(1, 0), description + SinglePrecision::name);
    case Precision::mixed:
        return machineOf<MixedPrecision>(CudaExecutor(1, 0), description + MixedPrecision::name);
    case Precision::double_:
        break;
    }
    return machineOf<DoublePrecision>(CudaExecutor(1, 0), description + DoublePrecision::name);
}

} // namespace fpm
