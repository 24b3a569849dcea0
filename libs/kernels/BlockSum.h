#pragma once

#include "base/Types.h"
#include "parallel/Math.h"

namespace fpm {

/// Sums over a block in one fixed order on every backend: 16 running sums over every 16th value,
/// ascending, then the 16 in order. `partial`: 16 doubles per quantity.
inline constexpr int blockSumLanes = 16;

constexpr std::size_t blockSumScratch(int quantities)
{
    return std::size_t(quantities) * blockSumLanes * sizeof(double);
}

/// First half: values[k * stride + i], i < count, of `quantities` quantities. A barrier follows.
template <class Team, class Work>
FPM_KERNEL void blockSums(const Team& team,
                          int quantities,
                          Index count,
                          const Work* values,
                          Index stride,
                          double* partial)
{
    if constexpr (Team::oneThread) { // the same sums, neighbouring lanes together in one register
        for (int k = 0; k < quantities; ++k) {
            const Work* mine = values + std::size_t(k) * stride;
            double sums[blockSumLanes] = {};
            Index i = 0;
            for (; i + blockSumLanes <= count; i += blockSumLanes)
                for (int lane = 0; lane < blockSumLanes; ++lane)
                    sums[lane] += double(mine[i + lane]);
            for (int lane = 0; i + lane < count; ++lane) sums[lane] += double(mine[i + lane]);
            for (int lane = 0; lane < blockSumLanes; ++lane)
                partial[k * blockSumLanes + lane] = sums[lane];
        }
    } else
        team.forEach(quantities * blockSumLanes, [=](Index lane) {
            const Work* mine = values + std::size_t(lane / blockSumLanes) * stride;
            double sum = 0;
            for (Index i = lane % blockSumLanes; i < count; i += blockSumLanes)
                sum += double(mine[i]);
            partial[lane] = sum;
        });
}
FPM_KERNEL double blockSumResult(const double* partial, int quantity)
{
    const double* mine = partial + quantity * blockSumLanes;
    double sum = mine[0];
    for (int lane = 1; lane < blockSumLanes; ++lane) sum += mine[lane];
    return sum;
}

/// Smallest value of a block in the same two halves; a NaN anywhere gives -1.
template <class Team, class Work>
FPM_KERNEL void blockMinimum(const Team& team, Index count, const Work* values, double* partial)
{
    team.forEach(blockSumLanes, [=](Index lane) {
        double least = 1e300;
        for (Index i = lane; i < count; i += blockSumLanes) {
            const double value = double(values[i]);
            least = value == value ? (value < least ? value : least) : -1.0;
        }
        partial[lane] = least;
    });
}
FPM_KERNEL double blockMinimumResult(const double* partial)
{
    double least = partial[0];
    for (int lane = 1; lane < blockSumLanes; ++lane)
        if (partial[lane] < least) least = partial[lane];
    return least;
}

} // namespace fpm
