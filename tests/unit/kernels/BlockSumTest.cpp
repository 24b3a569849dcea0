#include "kernels/BlockSum.h"

#include "parallel/CpuExecutor.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

using namespace fpm;

namespace {

CpuTeam<64> team()
{
    return CpuTeam<64>(nullptr);
}

} // namespace

TEST(BlockSum, AddsEveryValueOnce)
{
    for (const Index count : {0, 1, 15, 16, 17, 255, 256}) {
        std::array<double, 512> values{};
        for (Index i = 0; i < 256; ++i) {
            values[std::size_t(i)] = i < count ? i + 1 : 1e9;
            values[std::size_t(256 + i)] = i < count ? -1 : 1e9;
        }
        std::array<double, 2 * blockSumLanes> partial{};
        blockSums(team(), 2, count, values.data(), 256, partial.data());
        EXPECT_EQ(blockSumResult(partial.data(), 0), count * (count + 1) / 2);
        EXPECT_EQ(blockSumResult(partial.data(), 1), -count);
    }
}

TEST(BlockSum, MinimumFindsTheLeastAndRefusesWhatIsNoNumber)
{
    std::array<float, 100> values;
    for (std::size_t i = 0; i < 100; ++i) values[i] = float(100 - i);
    std::array<double, blockSumLanes> partial{};
    blockMinimum(team(), 100, values.data(), partial.data());
    EXPECT_EQ(blockMinimumResult(partial.data()), 1);
    values[40] = std::numeric_limits<float>::quiet_NaN();
    for (const Index place : {0, 40, 99}) {
        std::array<float, 100> with;
        with.fill(1);
        with[std::size_t(place)] = std::numeric_limits<float>::quiet_NaN();
        blockMinimum(team(), 100, with.data(), partial.data());
        EXPECT_EQ(blockMinimumResult(partial.data()), -1);
    }
}
