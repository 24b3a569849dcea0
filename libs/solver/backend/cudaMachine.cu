#include "base/Format.h"
#include "parallel/CudaExecutor.h"
#include "solver/backend/builtExecutors.h"
#include "solver/backend/machineOf.h"

namespace fpm {

namespace {

/// "0 NVIDIA H200, 1 NVIDIA H200"
std::string deviceNames(int count)
{
    std::string all;
    for (int number = 0; number < count; ++number) {
        cudaDeviceProp properties{};
        checkCuda(cudaGetDeviceProperties(&properties, number), "device properties");
        all += format("{}{} {}", number > 0 ? ", " : "", number, properties.name);
    }
    return all;
}

template <class Numbers>
Machine machineFor(const std::string& description)
{
    if constexpr (isBuiltPrecision<Numbers>())
        return machineOf<Numbers>(CudaExecutor(), description + Numbers::name);
    else
        throw Error(ExitCode::device,
                    format("this build has no kernels in {} precision", Numbers::name),
                    "configure it with other FPM_PRECISIONS");
}

} // namespace

std::string useCudaDevice(int number)
{
    int count = 0;
    const cudaError_t status = cudaGetDeviceCount(&count);
    if (status != cudaSuccess || count == 0)
        throw Error(ExitCode::device,
                    format("no usable GPU: {}",
                           status == cudaSuccess ? "none found" : cudaGetErrorString(status)),
                    "use -backend openmp or serial, or check the driver with nvidia-smi");
    if (number >= count)
        throw Error(ExitCode::device,
                    format("no GPU {}; this machine has {}", number, deviceNames(count)),
                    "give one of these numbers as -device, or as device in system/controlDict");
    checkCuda(cudaSetDevice(number), "choice of the device");
    cudaDeviceProp properties{};
    checkCuda(cudaGetDeviceProperties(&properties, number), "device properties");
    return properties.name;
}

Machine makeCudaMachine(const Control& control)
{
    // Refuses a machine without this GPU before anything is allocated.
    const std::string description = "cuda, " + useCudaDevice(control.device) + ", ";
    switch (control.precision) {
    case Precision::single:
        return machineFor<SinglePrecision>(description);
    case Precision::mixed:
        return machineFor<MixedPrecision>(description);
    case Precision::double_:
        break;
    }
    return machineFor<DoublePrecision>(description);
}

} // namespace fpm
