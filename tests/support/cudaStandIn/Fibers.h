#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace cudaStandIn {

/// Threads of one block that share one thread of the processor: each has a stack of its own and
/// runs until it waits or ends.
class Fibers
{
public:
    Fibers();
    Fibers(const Fibers&) = delete;
    ~Fibers();

    /// Runs `body` as fiber `number` until it waits (true) or ends (false).
    bool start(unsigned number, const std::function<void()>& body);
    /// Goes on with one that waits.
    bool resume(unsigned number);
    /// Called by a fiber: back to who started or resumed it.
    void wait();
    /// Forgets fibers that wait.
    void abandon(const std::vector<unsigned>& numbers);

private:
    struct Fiber {
        std::byte* stack = nullptr;
        void* top = nullptr; ///< of what is on the stack
        void* sanitizer = nullptr;
    };

    static void enter();
    void begin();
    bool turn(Fiber& fiber);

    std::byte* stacks_ = nullptr;
    std::vector<std::byte*> free_;
    std::vector<Fiber> fibers_;
    Fiber host_, *running_ = nullptr;
    const void* hostBottom_ = nullptr;
    std::size_t hostBytes_ = 0;
    const std::function<void()>* body_ = nullptr;
    bool ended_ = false;
};

/// Those of the device.
Fibers& fibers();

/// Numbers for orders, the same for the same seed (CUDA_STAND_IN_SEED, 1 unless given).
class Shuffle
{
public:
    Shuffle();
    void operator()(std::vector<unsigned>& numbers);

private:
    std::uint64_t state_;
};

} // namespace cudaStandIn
