#pragma once

#ifndef __CUDACC__
#error "CudaExecutor.h is for translation units compiled by nvcc"
#endif

#include "base/Error.h"
#include "base/Types.h"
#include "parallel/Math.h"

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
                       : "nothing on the device can be trusted any more; start the run again");
}

/// A thread block: forEach strides over its threads, barrier waits for all of them.
class CudaTeam
{
public:
    template <class Work>
    using Number = Work;

    static constexpr bool oneThread = false;

    FPM_KERNEL explicit CudaTeam(std::byte* scratch) : scratch_(scratch) {}
    FPM_KERNEL std::byte* scratch() const { return scratch_; }
    FPM_KERNEL void barrier() const
    {
#ifdef __CUDA_ARCH__
        __syncthreads();
#endif
    }
    template <class Body>
    FPM_KERNEL void forEach(Index count, const Body& body) const
    {
#ifdef __CUDA_ARCH__
        for (Index i = Index(threadIdx.x); i < count; i += Index(blockDim.x)) body(i);
#endif
    }
    template <class Work, class Body>
    FPM_KERNEL void forEachBatch(Index count, const Body& body) const
    {
        forEach(count, body);
    }

private:
    std::byte* scratch_;
};

template <class Kernel>
__global__ void __launch_bounds__(256) launchEach(Index count, Kernel kernel)
{
    const Index i = Index(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < count) kernel(i);
}

template <class Kernel>
__global__ void __launch_bounds__(256) launchBlocks(Kernel kernel)
{
    extern __shared__ __align__(128) std::byte blockScratch[];
    kernel(CudaTeam(blockScratch), Index(blockIdx.x));
}

/// Launches on one stream of the current device. Allocation is plain cudaMalloc, at set-up only.
class CudaExecutor
{
public:
    using Team = CudaTeam;

    CudaExecutor(int, std::size_t) {}

    template <class Kernel>
    void parallelFor(Index count, const Kernel& kernel) const
    {
        if (count <= 0) return;
        launchEach<<<unsigned((count + 255) / 256), 256>>>(count, kernel);
        checkCuda(cudaGetLastError(), "kernel launch");
    }
    template <class Kernel>
    void parallelBlocks(Index count, std::size_t scratchBytes, const Kernel& kernel) const
    {
        if (count <= 0) return;
        if (cudaFuncSetAttribute(launchBlocks<Kernel>, cudaFuncAttributeMaxDynamicSharedMemorySize,
                                 int(scratchBytes))
            != cudaSuccess)
            throw Error(ExitCode::device,
                        "a patch needs " + std::to_string(scratchBytes)
                            + " bytes of shared memory, more than this GPU gives to a block",
                        "run on the CPU, or on a GPU of compute capability 9.0 or later");
        launchBlocks<<<unsigned(count), 256, scratchBytes>>>(kernel);
        checkCuda(cudaGetLastError(), "kernel launch");
    }
    void synchronize() const { checkCuda(cudaDeviceSynchronize(), "time step"); }

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
