// The calls of the CUDA runtime. Included by force: cudaStandIn.h.

#include <cstdio>
#include <memory>

using namespace cudaStandIn;

struct CUgraph_st {
    std::vector<std::shared_ptr<const Launch>> launches;
};
struct CUgraphExec_st {
    std::vector<std::shared_ptr<const Launch>> launches;
};
struct CUstream_st {
    cudaGraph_t capture = nullptr; ///< what is being recorded
    bool broken = false;           ///< by a call that cannot be recorded
};
struct CUevent_st {
    std::chrono::steady_clock::time_point time;
    bool reached = false;
};

namespace {

using Work = std::function<void()>;

/// What was asked for and has not begun. One queue: streams that wait for each other's copies.
std::vector<Work>& queue()
{
    static std::vector<Work> all;
    return all;
}
std::map<const void*, std::size_t>& allowedShared()
{
    static std::map<const void*, std::size_t> all;
    return all;
}
cudaStream_t capturing = nullptr;
/// Two that share all there is; which one works shows in its name alone.
constexpr int devices = 2;
int currentDevice = 0;

/// A failed kernel fails everything after it.
cudaError_t state()
{
    return lastFault().empty() ? cudaSuccess : cudaErrorLaunchFailure;
}

/// Runs what waits.
cudaError_t finish()
{
    if (queue().empty()) return state();
    std::vector<Work> work;
    work.swap(queue());
    memory::open();
    for (const Work& piece : work)
        if (state() == cudaSuccess) piece();
    memory::close();
    return state();
}

/// The error of a call that would wait for a stream, or touch memory, while one records.
bool refused(cudaError_t& error, cudaError_t reason = cudaErrorStreamCaptureUnsupported)
{
    if (!capturing) return false;
    capturing->broken = true;
    error = reason;
    return true;
}

void add(const std::shared_ptr<const Launch>& launch)
{
    queue().push_back([launch] { run(*launch); });
}

cudaError_t check(const cudaLaunchConfig_t& config, const Launch& launch)
{
    const dim3 &grid = config.gridDim, &block = config.blockDim;
    if (grid.x == 0 || grid.x > 2147483647u || grid.y != 1 || grid.z != 1 || block.x == 0
        || block.x > mostThreads || block.y != 1 || block.z != 1)
        return cudaErrorInvalidConfiguration;
    const auto allowed = allowedShared().find(launch.function);
    if (config.dynamicSmemBytes
        > (allowed == allowedShared().end() ? usualSharedBytes : allowed->second))
        return cudaErrorInvalidValue;
    return cudaSuccess;
}

} // namespace

cudaError_t cudaStandIn::enqueue(const cudaLaunchConfig_t& config, Launch launch)
{
    if (const cudaError_t error = check(config, launch); error != cudaSuccess) return error;
    if (state() != cudaSuccess) return state();
    for (const std::uintptr_t word : launch.words)
        if (memory::forbidden(word)) {
            fault("an argument holds an address of the host or of freed memory, of "
                  + launch.kernel->name);
            return state();
        }
    launch.words.clear();
    launch.grid = config.gridDim;
    launch.block = config.blockDim;
    launch.sharedBytes = config.dynamicSmemBytes;
    auto ready = std::make_shared<const Launch>(std::move(launch));
    if (config.stream && config.stream->capture)
        config.stream->capture->launches.push_back(ready);
    else
        add(ready);
    return cudaSuccess;
}

cudaError_t
cudaStandIn::allowSharedBytes(const void* kernel, cudaFuncAttribute attribute, int bytes)
{
    if (state() != cudaSuccess) return state();
    if (attribute != cudaFuncAttributeMaxDynamicSharedMemorySize || bytes < 0
        || std::size_t(bytes) > mostSharedBytes)
        return cudaErrorInvalidValue;
    allowedShared()[kernel] = std::size_t(bytes);
    return cudaSuccess;
}

const char* cudaGetErrorString(cudaError_t error)
{
    switch (error) {
    case cudaSuccess:
        return "no error";
    case cudaErrorInvalidValue:
        return "invalid argument";
    case cudaErrorMemoryAllocation:
        return "out of memory";
    case cudaErrorInvalidConfiguration:
        return "invalid configuration argument";
    case cudaErrorInvalidDevice:
        return "invalid device ordinal";
    case cudaErrorInvalidMemcpyDirection:
        return "invalid copy direction for memcpy";
    case cudaErrorInvalidResourceHandle:
        return "invalid resource handle";
    case cudaErrorNotReady:
        return "device not ready";
    case cudaErrorLaunchFailure:
        return lastFault().c_str();
    case cudaErrorStreamCaptureUnsupported:
        return "operation not permitted when stream is capturing";
    case cudaErrorStreamCaptureInvalidated:
        return "operation failed due to a previous error during capture";
    case cudaErrorStreamCaptureImplicit:
        return "operation would make the legacy stream depend on a capturing blocking stream";
    }
    return "unrecognized error code";
}

cudaError_t cudaGetDeviceCount(int* count)
{
    *count = devices;
    return cudaSuccess;
}

cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int device)
{
    if (device < 0 || device >= devices) return cudaErrorInvalidDevice;
    std::snprintf(properties->name, sizeof properties->name, "%s emulated by the processor",
                  device == 0 ? "first" : "second");
    return cudaSuccess;
}

cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int device)
{
    if (device < 0 || device >= devices || attribute != cudaDevAttrMaxSharedMemoryPerBlockOptin)
        return cudaErrorInvalidValue;
    *value = int(mostSharedBytes);
    return cudaSuccess;
}

cudaError_t cudaGetDevice(int* device)
{
    *device = currentDevice;
    return cudaSuccess;
}

cudaError_t cudaSetDevice(int device)
{
    if (device < 0 || device >= devices) return cudaErrorInvalidDevice;
    currentDevice = device;
    return cudaSuccess;
}

cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* total)
{
    *free = memory::free();
    *total = memoryBytes;
    return state();
}

cudaError_t cudaMalloc(void** allocated, std::size_t bytes)
{
    cudaError_t error;
    if (refused(error)) return error;
    *allocated = bytes > 0 ? memory::allocate(bytes) : nullptr;
    return bytes > 0 && !*allocated ? cudaErrorMemoryAllocation : state();
}

cudaError_t cudaFree(void* freed)
{
    cudaError_t error;
    if (!freed) return cudaSuccess;
    if (refused(error)) return error;
    finish();
    if (!memory::release(freed)) return cudaErrorInvalidValue;
    return state();
}

cudaError_t cudaMemset(void* to, int value, std::size_t bytes)
{
    cudaError_t error;
    if (refused(error, cudaErrorStreamCaptureImplicit)) return error;
    if (!memory::holds(to, bytes)) return cudaErrorInvalidValue;
    queue().push_back([=] { std::memset(to, value, bytes); });
    return state();
}

cudaError_t cudaMemcpy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind)
{
    cudaError_t error;
    if (refused(error, cudaErrorStreamCaptureImplicit)) return error;
    const bool toDevice = memory::holds(to, bytes), fromDevice = memory::holds(from, bytes);
    if (toDevice != (kind == cudaMemcpyHostToDevice)
        || fromDevice != (kind == cudaMemcpyDeviceToHost))
        return cudaErrorInvalidValue;
    queue().push_back([=] { std::memcpy(to, from, bytes); });
    return finish();
}

cudaError_t cudaStreamCreate(cudaStream_t* stream)
{
    *stream = new CUstream_st;
    return state();
}

cudaError_t cudaStreamDestroy(cudaStream_t stream)
{
    delete stream;
    return state();
}

cudaError_t cudaStreamSynchronize(cudaStream_t)
{
    cudaError_t error;
    return refused(error) ? error : finish();
}

cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode)
{
    if (!stream || stream->capture) return cudaErrorInvalidValue;
    stream->capture = new CUgraph_st;
    stream->broken = false;
    capturing = stream;
    return state();
}

cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph)
{
    if (!stream || !stream->capture) return cudaErrorInvalidValue;
    *graph = std::exchange(stream->capture, nullptr);
    capturing = nullptr;
    if (!stream->broken) return state();
    delete std::exchange(*graph, nullptr);
    return cudaErrorStreamCaptureInvalidated;
}

cudaError_t cudaGraphInstantiate(cudaGraphExec_t* executable, cudaGraph_t graph, unsigned long long)
{
    if (!graph) return cudaErrorInvalidValue;
    *executable = new CUgraphExec_st{graph->launches};
    return state();
}

cudaError_t cudaGraphLaunch(cudaGraphExec_t executable, cudaStream_t stream)
{
    if (!executable || (stream && stream->capture)) return cudaErrorInvalidValue;
    for (const auto& launch : executable->launches) add(launch);
    return state();
}

cudaError_t cudaGraphDestroy(cudaGraph_t graph)
{
    delete graph;
    return cudaSuccess;
}

cudaError_t cudaGraphExecDestroy(cudaGraphExec_t executable)
{
    delete executable;
    return cudaSuccess;
}

cudaError_t cudaEventCreate(cudaEvent_t* event)
{
    *event = new CUevent_st;
    return state();
}

cudaError_t cudaEventDestroy(cudaEvent_t event)
{
    finish(); // the queue may still name it
    delete event;
    return state();
}

cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream)
{
    if (!event) return cudaErrorInvalidResourceHandle;
    event->reached = false;
    if (stream && stream->capture) return cudaSuccess; // recorded events have no time
    queue().push_back([event] {
        event->time = std::chrono::steady_clock::now();
        event->reached = true;
    });
    return state();
}

cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t begin, cudaEvent_t end)
{
    if (!begin->reached || !end->reached) return cudaErrorNotReady;
    *milliseconds = std::chrono::duration<float, std::milli>(end->time - begin->time).count();
    return state();
}
