#include "base/Format.h"
#include "solver/cudaInstance.h"

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

std::unique_ptr<Solver> makeCudaSolver(const Model& model, bool audit)
{
    cudaDeviceName(); // refuses a machine without a GPU before anything is allocated
    switch (model.control.precision) {
    case Precision::single:
        return makeCudaSingle(model, audit);
    case Precision::mixed:
        return makeCudaMixed(model, audit);
    case Precision::double_:
        break;
    }
    return makeCudaDouble(model, audit);
}

} // namespace fpm
