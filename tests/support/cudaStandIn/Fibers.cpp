#include "support/cudaStandIn/Fibers.h"

#include "support/cudaStandIn/Device.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>
#include <utility>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#endif

// Puts the registers that a function must keep on this stack and takes those of another: what
// swapcontext does, without its two system calls for the signal mask, a hundred times as fast.
extern "C" void cudaStandInSwitch(void** here, void* there);
asm(R"(
    .text
    .globl cudaStandInSwitch
    .type cudaStandInSwitch, @function
cudaStandInSwitch:
    pushq %rbp
    pushq %rbx
    pushq %r12
    pushq %r13
    pushq %r14
    pushq %r15
    movq %rsp, (%rdi)
    movq %rsi, %rsp
    popq %r15
    popq %r14
    popq %r13
    popq %r12
    popq %rbx
    popq %rbp
    ret
    .size cudaStandInSwitch, .-cudaStandInSwitch
)");

namespace cudaStandIn {

namespace {

constexpr std::size_t guardBytes = 4096, stackBytes = std::size_t(1) << 20,
                      strideBytes = guardBytes + stackBytes, topBytes = 8192;

#ifdef __SANITIZE_ADDRESS__
void leave(void** keep, const void* bottom, std::size_t bytes)
{
    __sanitizer_start_switch_fiber(keep, bottom, bytes);
}
void arrive(void* kept, const void** bottom, std::size_t* bytes)
{
    __sanitizer_finish_switch_fiber(kept, bottom, bytes);
}
void clean(std::byte* memory, std::size_t bytes)
{
    __asan_unpoison_memory_region(memory, bytes);
}
#else
void leave(void**, const void*, std::size_t) {}
void arrive(void*, const void**, std::size_t*) {}
void clean(std::byte*, std::size_t) {}
#endif

} // namespace

Fibers::Fibers() : fibers_(mostThreads)
{
    void* const all = mmap(nullptr, mostThreads * strideBytes + guardBytes, PROT_NONE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (all == MAP_FAILED) throw std::bad_alloc();
    stacks_ = static_cast<std::byte*>(all);
    for (std::size_t i = mostThreads; i-- > 0;) {
        std::byte* const stack = stacks_ + i * strideBytes + guardBytes;
        if (mprotect(stack, stackBytes, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
        free_.push_back(stack);
    }
}

Fibers::~Fibers()
{
    munmap(stacks_, mostThreads * strideBytes + guardBytes);
}

bool Fibers::start(unsigned number, const std::function<void()>& body)
{
    Fiber& fiber = fibers_[number];
    body_ = &body;
    fiber.stack = free_.back();
    fiber.sanitizer = nullptr;
    free_.pop_back();
    clean(fiber.stack + stackBytes - topBytes, topBytes); // frames that nobody returned from
    // Stacks begin at different lines of the cache; six registers and where to begin lie on them.
    const std::size_t colour = std::size_t(fiber.stack - stacks_) / strideBytes % 61 * 64;
    void** top = reinterpret_cast<void**>(fiber.stack + stackBytes - colour) - 2;
    *top = reinterpret_cast<void*>(&Fibers::enter);
    for (int i = 0; i < 6; ++i) *--top = nullptr;
    fiber.top = top;
    return turn(fiber);
}

bool Fibers::resume(unsigned number)
{
    return turn(fibers_[number]);
}

bool Fibers::turn(Fiber& fiber)
{
    running_ = &fiber;
    ended_ = false;
    leave(&host_.sanitizer, fiber.stack, stackBytes);
    cudaStandInSwitch(&host_.top, fiber.top);
    arrive(host_.sanitizer, nullptr, nullptr);
    if (ended_) free_.push_back(fiber.stack);
    return !ended_;
}

void Fibers::enter()
{
    fibers().begin();
}

void Fibers::begin()
{
    arrive(nullptr, &hostBottom_, &hostBytes_);
    (*body_)();
    ended_ = true;
    leave(nullptr, hostBottom_, hostBytes_);
    void* nobody = nullptr;
    cudaStandInSwitch(&nobody, host_.top);
    std::abort(); // nobody goes on with a fiber that ended
}

void Fibers::wait()
{
    Fiber& mine = *running_;
    leave(&mine.sanitizer, hostBottom_, hostBytes_);
    cudaStandInSwitch(&mine.top, host_.top);
    arrive(mine.sanitizer, &hostBottom_, &hostBytes_);
}

void Fibers::abandon(const std::vector<unsigned>& numbers)
{
    for (const unsigned number : numbers) {
        clean(fibers_[number].stack, stackBytes);
        free_.push_back(fibers_[number].stack);
    }
}

Fibers& fibers()
{
    static Fibers all;
    return all;
}

Shuffle::Shuffle()
{
    const char* seed = std::getenv("CUDA_STAND_IN_SEED");
    state_ = 0x9e3779b97f4a7c15u * (2 * std::uint64_t(seed ? std::atoi(seed) : 1) + 1);
}

void Shuffle::operator()(std::vector<unsigned>& numbers)
{
    for (std::size_t left = numbers.size(); left > 1; --left) {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        std::swap(numbers[left - 1], numbers[std::size_t(((state_ >> 32) * left) >> 32)]);
    }
}

} // namespace cudaStandIn
