#pragma once

// What the backend uses of CUDA's language and runtime, for g++ and a processor. Included before
// anything else (-include) where nvcc would include cuda_runtime.h. Names, values and errors are
// CUDA's own; README.md says what differs and what this can show.

#include "support/cudaStandIn/Device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

// After the standard library, which asks for them too. All code takes the path of the device.
#define __CUDACC__ 13
#define __CUDA_ARCH__ 900
#define __host__
#define __device__
#define __global__
#define __shared__
#define __forceinline__ inline __attribute__((always_inline))
#define __launch_bounds__(...)
#define __align__(bytes) __attribute__((aligned(bytes)))

using cudaStandIn::dim3;
using cudaStandIn::uint3;

/// Set for the thread that runs.
inline uint3 threadIdx, blockIdx;
inline dim3 blockDim, gridDim;

/// Lets the other threads of the block run up to here.
void __syncthreads();

inline unsigned long long atomicAdd(unsigned long long* target, unsigned long long value)
{
    return std::exchange(*target, *target + value);
}
inline int atomicExch(int* target, int value)
{
    return std::exchange(*target, value);
}

enum cudaError_t {
    cudaSuccess = 0,
    cudaErrorInvalidValue = 1,
    cudaErrorMemoryAllocation = 2,
    cudaErrorInvalidConfiguration = 9,
    cudaErrorInvalidMemcpyDirection = 21,
    cudaErrorInvalidDevice = 101,
    cudaErrorInvalidResourceHandle = 400,
    cudaErrorNotReady = 600,
    cudaErrorLaunchFailure = 719,
    cudaErrorStreamCaptureUnsupported = 900,
    cudaErrorStreamCaptureInvalidated = 901,
    cudaErrorStreamCaptureImplicit = 906
};
enum cudaMemcpyKind { cudaMemcpyHostToDevice = 1, cudaMemcpyDeviceToHost = 2 };
enum cudaStreamCaptureMode { cudaStreamCaptureModeThreadLocal = 1 };
enum cudaFuncAttribute { cudaFuncAttributeMaxDynamicSharedMemorySize = 8 };
enum cudaDeviceAttr { cudaDevAttrMaxSharedMemoryPerBlockOptin = 97 };

struct CUstream_st;
struct CUevent_st;
struct CUgraph_st;
struct CUgraphExec_st;
using cudaStream_t = CUstream_st*;
using cudaEvent_t = CUevent_st*;
using cudaGraph_t = CUgraph_st*;
using cudaGraphExec_t = CUgraphExec_st*;

struct cudaDeviceProp {
    char name[256];
};
struct cudaLaunchAttribute {
    int id;
};
struct cudaLaunchConfig_t {
    dim3 gridDim, blockDim;
    std::size_t dynamicSmemBytes;
    cudaStream_t stream;
    cudaLaunchAttribute* attrs;
    unsigned numAttrs;
};

const char* cudaGetErrorString(cudaError_t error);
cudaError_t cudaGetDeviceCount(int* count);
cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int device);
cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int device);
cudaError_t cudaGetDevice(int* device);
cudaError_t cudaSetDevice(int device);

cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* total);
cudaError_t cudaMalloc(void** memory, std::size_t bytes);
cudaError_t cudaFree(void* memory);
cudaError_t cudaMemset(void* memory, int value, std::size_t bytes);
cudaError_t cudaMemcpy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind);

cudaError_t cudaStreamCreate(cudaStream_t* stream);
cudaError_t cudaStreamDestroy(cudaStream_t stream);
cudaError_t cudaStreamSynchronize(cudaStream_t stream);
cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode mode);
cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph);
cudaError_t
cudaGraphInstantiate(cudaGraphExec_t* executable, cudaGraph_t graph, unsigned long long flags);
cudaError_t cudaGraphLaunch(cudaGraphExec_t executable, cudaStream_t stream);
cudaError_t cudaGraphDestroy(cudaGraph_t graph);
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t executable);

cudaError_t cudaEventCreate(cudaEvent_t* event);
cudaError_t cudaEventDestroy(cudaEvent_t event);
cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream);
cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t begin, cudaEvent_t end);

namespace cudaStandIn {

cudaError_t enqueue(const cudaLaunchConfig_t& config, Launch launch);

/// What each thread of a launch does: the kernel as this compiler made it, or its replacement.
template <class... Expected>
std::function<void()> threadOf(void (*kernel)(Expected...),
                               const std::tuple<Expected...>& arguments)
{
    if (!replacement) return [kernel, arguments] { std::apply(kernel, arguments); };
    return [body = replacement(reinterpret_cast<const void*>(kernel)), arguments] {
        std::apply(
            [body](const Expected&... argument) {
                const unsigned char* const places[] = {
                    reinterpret_cast<const unsigned char*>(&argument)...};
                body(places);
            },
            arguments);
    };
}
cudaError_t allowSharedBytes(const void* kernel, cudaFuncAttribute attribute, int bytes);

} // namespace cudaStandIn

template <class Kernel>
cudaError_t cudaFuncSetAttribute(Kernel* kernel, cudaFuncAttribute attribute, int bytes)
{
    return cudaStandIn::allowSharedBytes(reinterpret_cast<const void*>(kernel), attribute, bytes);
}

template <class... Expected, class... Actual>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* config,
                               void (*kernel)(Expected...),
                               Actual&&... actual)
{
    static_assert((std::is_trivially_copyable_v<Expected> && ...),
                  "arguments of a kernel are copied as bytes");
    static_assert(cudaStandIn::argumentBytes<Expected...>() <= cudaStandIn::mostArgumentBytes,
                  "arguments of a kernel take 4 KiB at most");
    std::tuple<Expected...> arguments(std::forward<Actual>(actual)...);
    cudaStandIn::Launch launch;
    launch.function = reinterpret_cast<const void*>(kernel);
    launch.kernel = cudaStandIn::Known<Expected...>::kernel;
    std::apply(
        [&](Expected&... argument) {
            (__builtin_clear_padding(&argument), ...);
            (launch.addWords(&argument, sizeof argument), ...);
        },
        arguments);
    launch.thread = cudaStandIn::threadOf(kernel, arguments);
    return cudaStandIn::enqueue(*config, std::move(launch));
}
