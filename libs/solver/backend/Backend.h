#pragma once

#include "parallel/Memory.h"

#include <cstdint>
#include <functional>

namespace fpm {

/// An executor for code that is compiled once for all of them: where kernels run, and when they are
/// done. The kernels themselves are behind Launches.
class Backend
{
public:
    virtual ~Backend() = default;
    virtual const Memory& memory() const = 0;
    virtual void synchronize() = 0;
    /// The host may read what kernels wrote, without waiting.
    virtual bool sharesMemory() const = 0;

    /// begin(), then step() `count` times. A GPU records full runs of stepsPerGraph once and
    /// replays them, so what they launch may not change until forgetSteps().
    virtual void
    repeat(std::int64_t count, std::function<void()> begin, std::function<void()> step) = 0;
    virtual void forgetSteps() = 0;

    /// Adds the seconds that `body` takes; on a GPU those of a sample of the steps.
    virtual void timed(double& seconds, const std::function<void()>& body) = 0;
    /// All steps over those whose parts were timed.
    virtual double timedScale() const = 0;

    /// Threads of the CPU that share blocks, each those from its first to the next one's; 0: any
    /// thread may work any block.
    virtual int threads() const = 0;
    virtual void useThreads(int threads) = 0;
    virtual std::int32_t firstBlock(int thread, std::int32_t blocks) const = 0;
};

} // namespace fpm
