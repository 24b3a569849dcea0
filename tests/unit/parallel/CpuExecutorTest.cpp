#include "parallel/CpuExecutor.h"

#include "parallel/Array.h"
#include "parallel/Atomic.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

using namespace fpm;

namespace {

/// Counts the visits of each index.
struct Visit {
    int* count;
    FPM_KERNEL void operator()(Index i) const { ++count[i]; }
};

/// Sums i over a block of 100 in scratch and stores it.
struct BlockWork {
    double* out;
    template <class Team>
    void operator()(const Team& team, Index block) const
    {
        double* scratch = reinterpret_cast<double*>(team.scratch());
        team.forEach(100, [=](Index i) { scratch[i] = block * 100 + i; });
        team.barrier();
        team.forEach(
            1, [=, this](Index) { out[block] = std::accumulate(scratch, scratch + 100, 0.0); });
        team.barrier();
    }
};

struct Tally {
    std::int64_t* sum;
    FPM_KERNEL void operator()(Index i) const { atomicAdd64(sum, i % 2 ? i : -i); }
};

using Four = CpuExecutor<256>;

} // namespace

TEST(CpuExecutor, VisitsEveryIndexOnceOnAnyNumberOfThreads)
{
    for (const int threads : {1, 2, 5})
        for (const Index count : {0, 1, 1000}) {
            std::vector<int> visits(1001, 0);
            Four(threads, 0).parallelFor(count, Visit{visits.data()});
            for (Index i = 0; i < 1001; ++i) EXPECT_EQ(visits[std::size_t(i)], i < count ? 1 : 0);
        }
}

TEST(CpuExecutor, GivesEachBlockScratchOfItsOwn)
{
    for (const int threads : {1, 3}) {
        std::vector<double> out(50, 0);
        const Four executor(threads, 100 * sizeof(double));
        executor.parallelBlocks(50, 100 * sizeof(double), BlockWork{out.data()});
        for (std::size_t block = 0; block < 50; ++block)
            EXPECT_EQ(out[block], 100.0 * 100.0 * double(block) + 4950);
    }
}

TEST(CpuExecutor, SharesTheBlocksAmongTheThreadsItIsToUse)
{
    Four executor(3, 100 * sizeof(double));
    for (const auto& [asked, used] : {std::pair{2, 2}, {1, 1}, {8, 3}, {0, 1}}) {
        executor.useThreads(asked);
        EXPECT_EQ(executor.threads(), used);
        EXPECT_EQ(executor.firstBlock(used, 50), 50);
        std::vector<double> out(50, 0);
        executor.parallelBlocks(50, 100 * sizeof(double), BlockWork{out.data()});
        for (std::size_t block = 0; block < 50; ++block)
            EXPECT_EQ(out[block], 100.0 * 100.0 * double(block) + 4950);
    }
}

TEST(CpuExecutor, IntegerSumsOfManyThreadsHaveNoOrder)
{
    std::int64_t sum = 0;
    Four(4, 0).parallelFor(100001, Tally{&sum});
    EXPECT_EQ(sum, -50000);
}

TEST(CpuExecutor, ExchangeReturnsWhatWasThere)
{
    Index head = 7;
    EXPECT_EQ(atomicExchangeIndex(&head, 9), 7);
    EXPECT_EQ(head, 9);
}

TEST(CpuExecutor, BatchesOfATeamFillTheRegister)
{
    const CpuTeam<256> wide(nullptr);
    std::vector<Index> starts;
    wide.forEachBatch<double>(10, [&](Index first) { starts.push_back(first); });
    EXPECT_EQ(starts, (std::vector<Index>{0, 4, 8}));
    starts.clear();
    wide.forEachBatch<float>(10, [&](Index first) { starts.push_back(first); });
    EXPECT_EQ(starts, (std::vector<Index>{0, 8}));
    static_assert(std::is_same_v<CpuTeam<64>::Number<double>, double>);
    static_assert(std::is_same_v<CpuTeam<64>::Number<float>, float>);
}

TEST(Array, IsZeroAtFirstAndAlignedForVectors)
{
    const Array<double, HostSpace> array(1000);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % 64, 0u);
    for (const double value : array.toHost()) EXPECT_EQ(value, 0);
}

TEST(Array, BringsBackWhatItWasGiven)
{
    const std::vector<int> values{3, 1, 4, 1, 5};
    Array<int, HostSpace> array(values);
    EXPECT_EQ(array.toHost(), values);
    EXPECT_EQ(array.bytes(), 5 * sizeof(int));
}

TEST(Array, MovesWithoutCopyingAndLeavesAnEmptyArray)
{
    Array<int, HostSpace> first(std::vector<int>{1, 2});
    const int* memory = first.data();
    Array<int, HostSpace> second(std::move(first));
    EXPECT_EQ(second.data(), memory);
    EXPECT_EQ(first.size(), 0u);
    Array<int, HostSpace> third;
    third = std::move(second);
    EXPECT_EQ(third.data(), memory);
    EXPECT_EQ(third.toHost(), (std::vector<int>{1, 2}));
}

TEST(Array, MayBeEmpty)
{
    Array<double, HostSpace> none(std::size_t(0));
    EXPECT_EQ(none.data(), nullptr);
    none.fromHost({});
    EXPECT_TRUE(none.toHost().empty());
}
