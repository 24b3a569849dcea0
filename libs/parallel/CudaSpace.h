#pragma once

#ifndef __CUDACC__
#error "CudaSpace.h is for translation units compiled by nvcc"
#endif

#include "base/Error.h"

#include <cstddef>
#include <string>

namespace fpm {

/// Turns a CUDA status into an Error; `what` names the call for the message.
inline void checkCuda(cudaError_t status, const char* what)
{
    if (status == cudaSuccess) return;
    const bool memory = status == cudaErrorMemoryAllocation;
    throw Error(memory ? ExitCode::device : ExitCode::deviceLost,
                std::string("CUDA: ") + what + ": " + cudaGetErrorString(status),
                memory ? "the model does not fit the free memory of this GPU"
                       : "nothing on the device can be trusted any more");
}

/// Memory of the current device, by plain cudaMalloc: at set-up only.
struct CudaSpace {
    /// Refuses what would not fit the device, before a part of it is allocated.
    static void requireMemory(std::size_t bytes)
    {
        std::size_t free = 0, total = 0;
        checkCuda(cudaMemGetInfo(&free, &total), "free memory");
        if (bytes <= free) return;
        const auto mebibytes = [](std::size_t n) { return std::to_string(n >> 20); };
        throw Error(ExitCode::device,
                    "the model needs " + mebibytes(bytes) + " MiB of device memory; "
                        + mebibytes(free) + " of this GPU's " + mebibytes(total) + " MiB are free",
                    "use -precision mixed, another -device, fewer elements or -backend openmp");
    }
    static void* allocate(std::size_t bytes)
    {
        void* memory = nullptr;
        checkCuda(cudaMalloc(&memory, bytes), "allocation");
        checkCuda(cudaMemset(memory, 0, bytes), "allocation");
        return memory;
    }
    static void release(void* memory) { cudaFree(memory); }
    static void toDevice(void* to, const void* from, std::size_t bytes)
    {
        checkCuda(cudaMemcpy(to, from, bytes, cudaMemcpyHostToDevice), "copy to the device");
    }
    static void toHost(void* to, const void* from, std::size_t bytes)
    {
        checkCuda(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToHost), "copy from the device");
    }
};

} // namespace fpm
