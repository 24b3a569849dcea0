#pragma once

#include "base/Types.h"
#include "parallel/Batch.h"
#include "parallel/HostSpace.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

namespace fpm {

/// One thread that plays a whole GPU block: forEach is a loop, barrier nothing. Batches of a patch
/// hold as many numbers as `Bits` of a vector register (64: one double, plain scalar code).
template <int Bits>
class CpuTeam
{
public:
    template <class Work>
    using Number = std::conditional_t<Bits == 64, Work, Batch<Work, Bits / int(8 * sizeof(Work))>>;

    static constexpr bool oneThread = true;

    explicit CpuTeam(std::byte* scratch) : scratch_(scratch) {}
    std::byte* scratch() const { return scratch_; }
    FPM_KERNEL void barrier() const {}

    template <class Body>
    FPM_KERNEL void forEach(Index count, const Body& body) const
    {
        for (Index i = 0; i < count; ++i) body(i);
    }
    /// body(first) for runs of Number<Work>::lanes indices; the last run may pass beyond `count`.
    template <class Work, class Body>
    FPM_KERNEL void forEachBatch(Index count, const Body& body) const
    {
        for (Index i = 0; i < count; i += NumberTraits<Number<Work>>::lanes) body(i);
    }

private:
    std::byte* scratch_;
};

/// Loops on one or more CPU threads.
template <int Bits>
class CpuExecutor
{
public:
    using Team = CpuTeam<Bits>;
    using MemorySpace = HostSpace;
    /// The host may read what the kernels wrote, without waiting.
    static constexpr bool sharesMemory = true;

    CpuExecutor(int threads, std::size_t scratchBytes) : threads_(threads)
    {
        for (int thread = 0; thread < threads; ++thread)
            scratch_.emplace_back(
                static_cast<std::byte*>(HostSpace::allocate(scratchBytes + 4096)));
    }

    /// kernel(i) for i < count.
    template <class Kernel>
    void parallelFor(Index count, const Kernel& kernel) const
    {
        if (threads_ == 1 || count < smallLoop) {
            for (Index i = 0; i < count; ++i) kernel(i);
            return;
        }
#pragma omp parallel for schedule(static) num_threads(threads_)
        for (Index i = 0; i < count; ++i) kernel(i);
    }

    /// kernel(team, block) for block < count; each thread works whole blocks with its own scratch.
    template <class Kernel>
    void parallelBlocks(Index count, std::size_t, const Kernel& kernel) const
    {
        if (threads_ == 1 || count == 1) {
            const Team team(scratch_[0].get());
            for (Index block = 0; block < count; ++block) kernel(team, block);
            return;
        }
#pragma omp parallel num_threads(threads_)
        {
            const Team team(scratch_[std::size_t(omp_get_thread_num())].get());
            // There may be fewer threads than requested.
            for (int part = omp_get_thread_num(); part < threads_; part += omp_get_num_threads()) {
                const Index end = firstBlock(part + 1, count);
                for (Index block = firstBlock(part, count); block < end; ++block)
                    kernel(team, block);
            }
        }
    }
    /// Threads that share the blocks of parallelBlocks, each those from its first to the next
    /// one's.
    int threads() const
    {
        return threads_;
    }
    /// From now on; at most those it was made with.
    void useThreads(int threads)
    {
        threads_ = std::clamp(threads, 1, int(scratch_.size()));
    }
    Index firstBlock(int thread, Index count) const
    {
        return Index(std::int64_t(count) * thread / threads_);
    }

    void synchronize() const {}
    /// One index after the other: nothing has to be locked.
    bool alone() const
    {
        return threads_ == 1;
    }

    /// begin(), then step() `count` times.
    template <class Begin, class Step>
    void repeat(std::int64_t count, const Begin& begin, const Step& step) const
    {
        begin();
        for (std::int64_t i = 0; i < count; ++i) step();
    }
    void forgetSteps() const {}

    /// Adds the seconds that body takes.
    template <class Body>
    void timed(double& seconds, const Body& body) const
    {
        const auto begin = std::chrono::steady_clock::now();
        body();
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    /// All steps over those whose parts were timed.
    double timedScale() const
    {
        return 1;
    }

private:
    /// Below this, waking the other threads costs more than they save.
    static constexpr Index smallLoop = 128;

    struct Free {
        void operator()(std::byte* memory) const { HostSpace::release(memory); }
    };
    int threads_;
    std::vector<std::unique_ptr<std::byte, Free>> scratch_;
};

} // namespace fpm
