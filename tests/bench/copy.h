#pragma once

#include "base/Types.h"
#include "parallel/Array.h"
#include "parallel/Math.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace fpm::bench {

struct CopyValue {
    const double* from;
    double* to;
    FPM_KERNEL void operator()(Index i) const { to[i] = from[i]; }
};
struct TriadValue {
    const double *a, *b;
    double* to;
    FPM_KERNEL void operator()(Index i) const { to[i] = fusedMultiplyAdd(3.0, b[i], a[i]); }
};

/// Bytes read and written a second, medians.
struct Bandwidth {
    double copy = 0, triad = 0;
};

/// Copies and adds arrays of `count` numbers, each far larger than any cache, `repeats` times by
/// turns.
template <class Executor>
Bandwidth bandwidth(const Executor& executor, Index count, int repeats)
{
    // Values that are not zero, so that no page stays shared.
    using Space = typename Executor::MemorySpace;
    const Array<double, Space> a(std::vector<double>(std::size_t(count), 1.0)),
        b(std::vector<double>(std::size_t(count), 2.0));
    Array<double, Space> to(std::vector<double>(std::size_t(count), 3.0));
    const auto seconds = [&](const auto& kernel) {
        executor.synchronize();
        const auto begin = std::chrono::steady_clock::now();
        executor.parallelFor(count, kernel);
        executor.synchronize();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    std::vector<double> copies, triads;
    for (int repeat = -1; repeat < repeats; ++repeat) { // the first warms up
        const double copy = seconds(CopyValue{a.data(), to.data()}),
                     triad = seconds(TriadValue{a.data(), b.data(), to.data()});
        if (repeat < 0) continue;
        copies.push_back(copy);
        triads.push_back(triad);
    }
    const auto median = [](std::vector<double>& times) {
        std::sort(times.begin(), times.end());
        return times[times.size() / 2];
    };
    const double bytes = double(count) * sizeof(double);
    return {2 * bytes / median(copies), 3 * bytes / median(triads)};
}

/// On the GPU; throws Error(device) where there is none.
Bandwidth bandwidthOfGpu(Index count, int repeats);

} // namespace fpm::bench
