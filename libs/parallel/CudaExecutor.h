#pragma once

#ifndef __CUDACC__
#error "CudaExecutor.h is for translation units compiled by nvcc"
#endif

#include "base/Types.h"
#include "parallel/CudaSpace.h"
#include "parallel/LaunchSizes.h"
#include "parallel/Math.h"

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace fpm {

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
__global__ void __launch_bounds__(threadsPerBlock) launchEach(Index count, Kernel kernel)
{
    const Index i = Index(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < count) kernel(i);
}

/// Threads of a block, and blocks that a multiprocessor should hold at once, where a kernel states
/// them: registers are shared.
template <class Kernel>
constexpr int threadsOf()
{
    if constexpr (requires { Kernel::threads; })
        return Kernel::threads;
    else
        return threadsPerBlock;
}
template <class Kernel>
constexpr int blocksPerProcessor()
{
    if constexpr (requires { Kernel::blocksPerProcessor; })
        return Kernel::blocksPerProcessor;
    else
        return 1;
}

template <class Kernel>
__global__ void __launch_bounds__(threadsOf<Kernel>(), blocksPerProcessor<Kernel>())
    launchBlocks(Kernel kernel)
{
    extern __shared__ __align__(128) std::byte blockScratch[];
    kernel(CudaTeam(blockScratch), Index(blockIdx.x));
}

/// Deleters of what CUDA hands out as plain pointers.
struct CudaRelease {
    void operator()(cudaStream_t stream) const { cudaStreamDestroy(stream); }
    void operator()(cudaEvent_t event) const { cudaEventDestroy(event); }
    void operator()(cudaGraph_t graph) const { cudaGraphDestroy(graph); }
    void operator()(cudaGraphExec_t graph) const { cudaGraphExecDestroy(graph); }
};
template <class Handle>
using CudaOwned = std::unique_ptr<std::remove_pointer_t<Handle>, CudaRelease>;

/// Records what is launched on a stream, until end() or, where that is not reached, until it goes:
/// a stream that goes on recording would refuse all that follows, and its own end.
class CudaCapture
{
public:
    explicit CudaCapture(cudaStream_t stream) : stream_(stream)
    {
        checkCuda(cudaStreamBeginCapture(stream_, cudaStreamCaptureModeThreadLocal), "graph");
    }
    CudaCapture(const CudaCapture&) = delete;
    ~CudaCapture()
    {
        cudaGraph_t left = nullptr;
        if (stream_ && cudaStreamEndCapture(stream_, &left) == cudaSuccess) cudaGraphDestroy(left);
    }
    CudaOwned<cudaGraph_t> end()
    {
        cudaGraph_t graph = nullptr;
        checkCuda(cudaStreamEndCapture(std::exchange(stream_, nullptr), &graph), "graph");
        return CudaOwned<cudaGraph_t>(graph);
    }

private:
    cudaStream_t stream_; ///< null after the end
};

/// Launches on one stream of the current device.
class CudaExecutor
{
public:
    using Team = CudaTeam;
    using MemorySpace = CudaSpace;
    static constexpr bool sharesMemory = false;

    CudaExecutor()
    {
        cudaStream_t stream = nullptr;
        // A blocking stream: the plain copies of toDevice and toHost keep their order with it.
        checkCuda(cudaStreamCreate(&stream), "stream");
        stream_.reset(stream);
    }

    template <class Kernel>
    void parallelFor(Index count, const Kernel& kernel) const
    {
        if (count <= 0) return;
        launch(launchEach<Kernel>, unsigned(blocksOf(count, threadsPerBlock)), threadsPerBlock, 0,
               count, kernel);
    }
    template <class Kernel>
    void parallelBlocks(Index count, std::size_t scratchBytes, const Kernel& kernel) const
    {
        if (count <= 0) return;
        const cudaError_t status = cudaFuncSetAttribute(
            launchBlocks<Kernel>, cudaFuncAttributeMaxDynamicSharedMemorySize, int(scratchBytes));
        if (status != cudaSuccess) refuseShared(scratchBytes, status);
        launch(launchBlocks<Kernel>, unsigned(count), threadsOf<Kernel>(), scratchBytes, kernel);
    }
    void synchronize() const { checkCuda(cudaStreamSynchronize(stream_.get()), "time step"); }
    static bool alone() { return false; }
    /// Any thread may work any block.
    static int threads() { return 0; }
    static void useThreads(int) {}
    static Index firstBlock(int, Index) { return 0; }

    /// begin(), then step() `count` times. Full runs of stepsPerGraph are recorded once as a graph
    /// and replayed, so what they launch may not change until forgetSteps. One replay in
    /// samplePeriod is launched plainly instead, to be timed.
    template <class Begin, class Step>
    void repeat(std::int64_t count, const Begin& begin, const Step& step)
    {
        const bool full = count == stepsPerGraph;
        if (full && ++replays_ % samplePeriod != 1) {
            if (!graph_) record(begin, step);
            checkCuda(cudaGraphLaunch(graph_.get(), stream_.get()), "graph launch");
            stepsDone_ += count;
            return;
        }
        sampling_ = full;
        begin();
        for (std::int64_t i = 0; i < count; ++i) step();
        stepsDone_ += count;
        if (sampling_) {
            stepsTimed_ += count;
            readSamples();
        }
        sampling_ = false;
    }
    /// What the steps launch has changed: another array, another size.
    void forgetSteps() { graph_.reset(); }

    /// Seconds the device spends on what body launches, added in the steps that are sampled.
    template <class Body>
    void timed(double& seconds, const Body& body)
    {
        if (!sampling_) return body();
        samples_.push_back({&seconds, stamp(), {}});
        const std::size_t mine = samples_.size() - 1;
        body();
        samples_[mine].end = stamp();
    }
    /// All steps over those whose parts were timed.
    double timedScale() const
    {
        return stepsTimed_ > 0 ? double(stepsDone_) / double(stepsTimed_) : 1;
    }

private:
    static constexpr std::int64_t samplePeriod = 32; ///< replays

    struct Sample {
        double* seconds;
        CudaOwned<cudaEvent_t> begin, end;
    };

    /// kernel<<<blocks, threads, scratchBytes>>>(arguments...) as a call of the runtime, so
    /// that no syntax of nvcc's own is needed: any compiler and any runtime of these names will do.
    template <class... Expected, class... Arguments>
    void launch(void (*kernel)(Expected...),
                unsigned blocks,
                unsigned threads,
                std::size_t scratchBytes,
                const Arguments&... arguments) const
    {
        cudaLaunchConfig_t shape{};
        shape.gridDim = dim3(blocks);
        shape.blockDim = dim3(threads);
        shape.dynamicSmemBytes = scratchBytes;
        shape.stream = stream_.get();
        checkCuda(cudaLaunchKernelEx(&shape, kernel, arguments...), "kernel launch");
    }
    /// Says why a kernel cannot have its shared memory: the GPU gives a block less, or something
    /// else.
    static void refuseShared(std::size_t bytes, cudaError_t status)
    {
        int device = 0, most = 0;
        checkCuda(cudaGetDevice(&device), "current device");
        checkCuda(cudaDeviceGetAttribute(&most, cudaDevAttrMaxSharedMemoryPerBlockOptin, device),
                  "device attribute");
        if (bytes <= std::size_t(most)) checkCuda(status, "shared memory of a kernel");
        throw Error(ExitCode::device,
                    "a patch needs " + std::to_string(bytes)
                        + " bytes of shared memory, this GPU "
                          "gives "
                        + std::to_string(most) + " to a block",
                    "run on the CPU, or on a GPU of compute capability 9.0 or later");
    }
    CudaOwned<cudaEvent_t> stamp() const
    {
        cudaEvent_t event = nullptr;
        checkCuda(cudaEventCreate(&event), "event");
        CudaOwned<cudaEvent_t> owned(event);
        checkCuda(cudaEventRecord(event, stream_.get()), "event");
        return owned;
    }
    template <class Begin, class Step>
    void record(const Begin& begin, const Step& step)
    {
        CudaCapture capture(stream_.get());
        begin();
        for (std::int64_t i = 0; i < stepsPerGraph; ++i) step();
        const CudaOwned<cudaGraph_t> graph = capture.end();
        cudaGraphExec_t executable = nullptr;
        checkCuda(cudaGraphInstantiate(&executable, graph.get(), 0), "graph");
        graph_.reset(executable);
    }
    void readSamples()
    {
        synchronize();
        for (const Sample& sample : samples_) {
            float milliseconds = 0;
            checkCuda(cudaEventElapsedTime(&milliseconds, sample.begin.get(), sample.end.get()),
                      "event");
            *sample.seconds += 1e-3 * double(milliseconds);
        }
        samples_.clear();
    }

    CudaOwned<cudaStream_t> stream_;
    CudaOwned<cudaGraphExec_t> graph_; ///< stepsPerGraph steps
    std::vector<Sample> samples_;
    bool sampling_ = false;
    std::int64_t replays_ = 0, stepsDone_ = 0, stepsTimed_ = 0;
};

} // namespace fpm
