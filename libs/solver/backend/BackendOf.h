#pragma once

#include "solver/backend/Backend.h"

#include <utility>

namespace fpm {

/// The executor that kernels are launched on, behind a Backend.
template <class Executor>
class BackendOf final : public Backend
{
public:
    explicit BackendOf(Executor executor) : executor_(std::move(executor)) {}
    Executor& executor() { return executor_; }

    const Memory& memory() const override { return memory_; }
    void synchronize() override { executor_.synchronize(); }
    bool sharesMemory() const override { return Executor::sharesMemory; }
    void
    repeat(std::int64_t count, std::function<void()> begin, std::function<void()> step) override
    {
        executor_.repeat(count, begin, step);
    }
    void forgetSteps() override { executor_.forgetSteps(); }
    void timed(double& seconds, const std::function<void()>& body) override
    {
        executor_.timed(seconds, body);
    }
    double timedScale() const override { return executor_.timedScale(); }
    int threads() const override { return executor_.threads(); }
    void useThreads(int threads) override { executor_.useThreads(threads); }
    std::int32_t firstBlock(int thread, std::int32_t blocks) const override
    {
        return executor_.firstBlock(thread, blocks);
    }

private:
    MemoryOf<typename Executor::MemorySpace> memory_;
    Executor executor_;
};

} // namespace fpm
