// The stand-in refuses what a GPU would refuse and shows what a GPU would do differently: else the
// emulated parity tests would say little.

#include "parallel/Array.h"
#include "parallel/Atomic.h"
#include "parallel/CudaExecutor.h"

#include <gtest/gtest.h>

namespace fpm::standInTest {
namespace {

template <class T>
using Device = Array<T, CudaSpace>;

constexpr int threads = threadsPerBlock;
constexpr std::size_t blockBytes = threads * sizeof(Index);

template <class Body>
std::string messageOf(const Body& body)
{
    try {
        body();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

class StandIn : public testing::Test
{
protected:
    ~StandIn() override { cudaStandIn::reset(); }
    /// What the executor says of a kernel of one block.
    template <class Kernel>
    std::string failureOf(const Kernel& kernel, std::size_t scratch = blockBytes)
    {
        return messageOf([&] {
            executor.parallelBlocks(1, scratch, kernel);
            executor.synchronize();
        });
    }
    CudaExecutor executor;
};

/// Every thread writes its number and reads that of the thread on the other side.
struct Exchange {
    bool barrier;
    Index* out;
    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        auto* numbers = reinterpret_cast<Index*>(team.scratch());
        team.forEach(threads, [&](Index i) { numbers[i] = i; });
        if (barrier) team.barrier();
        team.forEach(threads, [&](Index i) { out[i] = numbers[threads - 1 - i]; });
    }
};

TEST_F(StandIn, AMissingBarrierShows)
{
    Device<Index> out(threads);
    std::vector<Index> expected(threads);
    for (Index i = 0; i < threads; ++i) expected[std::size_t(i)] = threads - 1 - i;
    executor.parallelBlocks(1, blockBytes, Exchange{true, out.data()});
    EXPECT_EQ(out.toHost(), expected);
    executor.parallelBlocks(1, blockBytes, Exchange{false, out.data()});
    EXPECT_NE(out.toHost(), expected);
}

struct HalfWaits {
    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        if (threadIdx.x % 2 == 0) team.barrier();
    }
};
struct Nothing {
    FPM_KERNEL void operator()(Index) const {}
};

TEST_F(StandIn, ABarrierThatSomeThreadsMissFailsThisAndAllThatFollows)
{
    EXPECT_NE(failureOf(HalfWaits{}).find("128 of 256 threads wait at a barrier"),
              std::string::npos);
    EXPECT_NE(messageOf([&] { executor.parallelFor(1, Nothing{}); }), "");
    EXPECT_NE(messageOf([&] { CudaSpace::allocate(8); }), "");
}

struct Ticket {
    std::int64_t* next;
    std::int64_t* order;
    FPM_KERNEL void operator()(Index i) const
    {
        order[i] = std::int64_t(atomicAdd(reinterpret_cast<unsigned long long*>(next), 1));
    }
};

TEST_F(StandIn, ThreadsAndBlocksComeInNoOrder)
{
    Device<std::int64_t> next(1), order(2048);
    executor.parallelFor(2048, Ticket{next.data(), order.data()});
    const std::vector<std::int64_t> first = order.toHost();
    EXPECT_FALSE(std::is_sorted(first.begin(), first.begin() + threads));
    std::vector<std::int64_t> blocks;
    for (std::size_t i = 0; i < 2048; i += threads) blocks.push_back(first[i] / threads);
    EXPECT_FALSE(std::is_sorted(blocks.begin(), blocks.end()));
    next.fromHost({0});
    executor.parallelFor(2048, Ticket{next.data(), order.data()});
    EXPECT_NE(order.toHost(), first);
}

struct WriteBehind {
    std::size_t at;
    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        team.forEach(1, [&](Index) { team.scratch()[at] = std::byte(7); });
    }
};

TEST_F(StandIn, SharedMemoryEndsWhereTheLaunchSaid)
{
    EXPECT_EQ(failureOf(WriteBehind{blockBytes - 1}), "");
    EXPECT_NE(failureOf(WriteBehind{blockBytes}).find("behind the 1024 bytes"), std::string::npos);
    cudaStandIn::reset();
    EXPECT_DEATH(failureOf(WriteBehind{blockBytes + 4096}), "");
}

struct ReadShared {
    double* out;
    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        const double* values = reinterpret_cast<const double*>(team.scratch());
        team.forEach(1, [&](Index) { out[0] = values[5]; });
    }
};

TEST_F(StandIn, WhatNobodyWroteIsNotZero)
{
    Device<double> out(1);
    executor.parallelBlocks(1, blockBytes, ReadShared{out.data()});
    EXPECT_NE(out.toHost()[0], out.toHost()[0]);
    void* fresh = nullptr;
    double value = 0;
    ASSERT_EQ(cudaMalloc(&fresh, sizeof value), cudaSuccess);
    ASSERT_EQ(cudaMemcpy(&value, fresh, sizeof value, cudaMemcpyDeviceToHost), cudaSuccess);
    EXPECT_NE(value, value);
    EXPECT_EQ(cudaFree(fresh), cudaSuccess);
}

TEST_F(StandIn, SharedMemoryHasALimit)
{
    EXPECT_EQ(failureOf(WriteBehind{0}, 227 * 1024), "");
    EXPECT_NE(failureOf(WriteBehind{0}, 227 * 1024 + 1).find("a patch needs"), std::string::npos);
}

TEST_F(StandIn, AKernelThatFailedIsNotTooLittleSharedMemory)
{
    EXPECT_NE(failureOf(HalfWaits{}), "");
    EXPECT_NE(failureOf(WriteBehind{0}).find("shared memory of a kernel: 128 of 256 threads wait"),
              std::string::npos);
}

struct Store {
    Index* out;
    Index at, value;
    FPM_KERNEL void operator()(Index) const { out[at] = value; }
};

TEST_F(StandIn, TheHostCannotTouchDeviceMemory)
{
    Device<Index> out(4);
    EXPECT_DEATH(out.data()[0] = 1, "");
    executor.parallelFor(1, Store{out.data(), 0, 1});
    executor.synchronize();
    EXPECT_DEATH(out.data()[0] = 1, "");
}

TEST_F(StandIn, KernelsCannotLeaveAnArray)
{
    const auto store = [&](Index size, Index at) {
        Device<Index> out{std::size_t(size)};
        executor.parallelFor(1, Store{out.data(), at, 1});
        executor.synchronize();
    };
    EXPECT_DEATH(store(4, 4), "");
    EXPECT_DEATH(store(5, 8), "");
    EXPECT_DEATH(store(4, -2000), "");
    store(5, 5); // in the bytes that fill up sixteen
    EXPECT_NE(cudaStandIn::lastFault().find("beside an allocation of 20 bytes"), std::string::npos);
    cudaStandIn::reset();
    store(4, -1);
    EXPECT_NE(cudaStandIn::lastFault(), "");
}

TEST_F(StandIn, ArgumentsHoldNoAddressOfTheHostNorOfFreedMemory)
{
    std::vector<Index> host(4);
    EXPECT_NE(messageOf([&] {
                  executor.parallelFor(1, Store{host.data(), 0, 1});
              }).find("address of the host"),
              std::string::npos);
    cudaStandIn::reset();
    Index* freed = Device<Index>(4).data();
    EXPECT_NE(messageOf([&] { executor.parallelFor(1, Store{freed, 0, 1}); }), "");
}

TEST_F(StandIn, ALaunchRunsWhenTheHostWaitsForIt)
{
    Device<Index> out(1);
    const auto launches = [] {
        std::size_t sum = 0;
        for (const auto& [name, kernel] : cudaStandIn::kernels()) sum += kernel.launches;
        return sum;
    };
    const std::size_t before = launches();
    executor.parallelFor(1, Store{out.data(), 0, 3});
    EXPECT_EQ(launches(), before);
    executor.synchronize();
    EXPECT_EQ(launches(), before + 1);
    executor.parallelFor(1, Store{out.data(), 0, 4});
    EXPECT_EQ(out.toHost()[0], 4); // a copy waits for what was launched before it
}

struct Count {
    Index* out;
    Index step;
    FPM_KERNEL void operator()(Index) const { out[0] += step; }
};

TEST_F(StandIn, AGraphReplaysWhatWasRecorded)
{
    Device<Index> out(1);
    Index step = 1;
    const auto ten = [&] {
        executor.repeat(
            stepsPerGraph, [] {},
            [&] {
                executor.parallelFor(1, Count{out.data(), step});
            });
    };
    ten(); // launched plainly, as a sample
    ten(); // recorded and replayed
    EXPECT_EQ(out.toHost()[0], 20);
    step = 100;
    ten();
    EXPECT_EQ(out.toHost()[0], 30);
    executor.forgetSteps();
    ten();
    EXPECT_EQ(out.toHost()[0], 1030);
}

TEST_F(StandIn, AnExceptionInTheStepsEndsTheRecording)
{
    Device<Index> out(1);
    const auto steps = [&](bool fails) {
        executor.repeat(
            stepsPerGraph, [] {},
            [&] {
                if (fails) throw Error(ExitCode::internal, "on the way");
                executor.parallelFor(1, Count{out.data(), 1});
            });
    };
    steps(false); // launched plainly, as a sample
    EXPECT_EQ(messageOf([&] { steps(true); }), "on the way");
    steps(false);
    EXPECT_EQ(out.toHost()[0], 2 * stepsPerGraph);
}

TEST_F(StandIn, WhatCannotBeRecordedFailsAndEndsTheRecording)
{
    Device<Index> out(1);
    cudaStream_t stream = nullptr;
    cudaGraph_t graph = nullptr;
    void* more = nullptr;
    Index value = 0;
    ASSERT_EQ(cudaStreamCreate(&stream), cudaSuccess);
    const auto recording = [&](const auto& body) {
        EXPECT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
        EXPECT_NE(body(), cudaSuccess);
        EXPECT_EQ(cudaStreamEndCapture(stream, &graph), cudaErrorStreamCaptureInvalidated);
    };
    recording([&] { return cudaMalloc(&more, 8); });
    recording([&] { return cudaFree(out.data()); });
    recording([&] { return cudaMemset(out.data(), 0, 4); });
    recording([&] { return cudaMemcpy(&value, out.data(), 4, cudaMemcpyDeviceToHost); });
    recording([&] { return cudaStreamSynchronize(stream); });
    EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
}

__global__ void nothing(Store) {}

TEST_F(StandIn, ImpossibleLaunchesAndCopiesFail)
{
    const auto launch = [](dim3 grid, dim3 block, std::size_t shared) {
        cudaLaunchConfig_t shape{};
        shape.gridDim = grid;
        shape.blockDim = block;
        shape.dynamicSmemBytes = shared;
        return cudaLaunchKernelEx(&shape, nothing, Store{});
    };
    EXPECT_EQ(launch(1, 1024, 0), cudaSuccess);
    EXPECT_EQ(launch(1, 1025, 0), cudaErrorInvalidConfiguration);
    EXPECT_EQ(launch(0, 32, 0), cudaErrorInvalidConfiguration);
    EXPECT_EQ(launch(2147483648u, 32, 0), cudaErrorInvalidConfiguration);
    EXPECT_EQ(launch(1, 32, 48 * 1024 + 1), cudaErrorInvalidValue);
    Device<Index> out(2);
    Index values[4] = {};
    EXPECT_NE(cudaMemcpy(out.data(), values, 16, cudaMemcpyHostToDevice), cudaSuccess);
    EXPECT_NE(cudaMemcpy(values, out.data(), 8, cudaMemcpyHostToDevice), cudaSuccess);
    EXPECT_NE(cudaFree(values), cudaSuccess);
}

TEST_F(StandIn, AModelThatDoesNotFitIsRefused)
{
    EXPECT_NE(messageOf([] { CudaSpace::allocate(std::size_t(5) << 30); }).find("out of memory"),
              std::string::npos);
}

TEST_F(StandIn, AModelThatWouldNotFitIsRefusedBeforeAnythingIsAllocated)
{
    std::size_t before = 0, free = 0, total = 0;
    ASSERT_EQ(cudaMemGetInfo(&before, &total), cudaSuccess);
    Device<double> held(1000);
    ASSERT_EQ(cudaMemGetInfo(&free, &total), cudaSuccess);
    EXPECT_EQ(free, before - held.bytes());
    EXPECT_EQ(messageOf([=] { CudaSpace::requireMemory(free); }), "");
    EXPECT_NE(messageOf([=] { CudaSpace::requireMemory(free + 1); }).find("4096 MiB are free"),
              std::string::npos);
}

} // namespace
} // namespace fpm::standInTest
