// Included by force: cudaStandIn.h.

#include "support/cudaStandIn/Fibers.h"

#include <cxxabi.h>
#include <sys/mman.h>

#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace fpm {

/// The dynamic shared memory of every kernel of the backend (CudaExecutor.h declares it). Pages
/// that a launch did not ask for are closed, the bytes between are checked after each block.
extern std::byte blockScratch[];
constexpr std::size_t page = 4096,
                      scratchBytes = (cudaStandIn::mostSharedBytes + page - 1) / page * page + page;
alignas(page) std::byte blockScratch[scratchBytes];

} // namespace fpm

void __syncthreads()
{
    cudaStandIn::fibers().wait();
}

namespace cudaStandIn {

namespace {

std::string lastFault_;
const Kernel* running = nullptr;
long launches_ = 0; ///< since the last reset

std::vector<unsigned> firstNumbers(unsigned count)
{
    std::vector<unsigned> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

Shuffle& shuffle()
{
    static Shuffle all;
    return all;
}

/// Shared memory as a block finds it, and behind it.
class SharedMemory
{
public:
    explicit SharedMemory(std::size_t bytes)
        : bytes_(bytes),
          open_((bytes + fpm::page - 1) / fpm::page * fpm::page)
    {
        protect(PROT_NONE);
    }
    SharedMemory(const SharedMemory&) = delete;
    ~SharedMemory() { protect(PROT_READ | PROT_WRITE); }

    void fill() const
    {
        std::fill_n(reinterpret_cast<std::uint32_t*>(fpm::blockScratch), open_ / sizeof garbage,
                    garbage);
    }
    bool intact() const
    {
        const auto* word = reinterpret_cast<const std::byte*>(&garbage);
        for (std::size_t i = bytes_; i < open_; ++i)
            if (fpm::blockScratch[i] != word[i % sizeof garbage]) return false;
        return true;
    }

private:
    void protect(int access) const
    {
        mprotect(fpm::blockScratch + open_, fpm::scratchBytes - open_, access);
    }
    std::size_t bytes_, open_;
};

/// False where some threads ended while others wait at a barrier.
bool runBlock(unsigned threads, const std::function<void()>& body)
{
    std::vector<unsigned> alive = firstNumbers(threads), waiting;
    for (bool first = true; !alive.empty(); first = false) {
        shuffle()(alive);
        waiting.clear();
        for (const unsigned thread : alive) {
            threadIdx.x = thread;
            if (first ? fibers().start(thread, body) : fibers().resume(thread))
                waiting.push_back(thread);
        }
        if (!waiting.empty() && waiting.size() != alive.size()) {
            fibers().abandon(waiting);
            fault(std::to_string(waiting.size()) + " of " + std::to_string(alive.size())
                  + " threads wait at a barrier that the others never reach");
            return false;
        }
        alive.swap(waiting);
    }
    return true;
}

/// The launch at which the device is lost, counted from the last reset; as the environment says.
void loseDeviceAtItsTime()
{
    const char* at = std::getenv("CUDA_STAND_IN_LOST_AT");
    if (at && ++launches_ == std::atol(at)) fault("the device has fallen off the bus");
}

} // namespace

std::map<std::string, Kernel>& kernels()
{
    static std::map<std::string, Kernel> all;
    return all;
}

Kernel* addKernel(const std::type_info& signature, std::size_t argumentBytes)
{
    int status = 0;
    char* const readable = abi::__cxa_demangle(signature.name(), nullptr, nullptr, &status);
    const std::string name = status == 0 ? readable : signature.name();
    std::free(readable);
    Kernel& kernel = kernels()[name];
    kernel.name = name;
    kernel.argumentBytes = argumentBytes;
    return &kernel;
}

void Launch::addWords(const void* argument, std::size_t bytes)
{
    const auto* from = static_cast<const std::byte*>(argument);
    for (std::size_t at = 0; at + sizeof(std::uintptr_t) <= bytes; at += sizeof(std::uintptr_t)) {
        std::uintptr_t word = 0;
        std::memcpy(&word, from + at, sizeof word);
        words.push_back(word);
    }
}

void run(const Launch& launch)
{
    loseDeviceAtItsTime();
    if (!lastFault().empty()) return;
    running = launch.kernel;
    ++launch.kernel->launches;
    launch.kernel->threads += std::size_t(launch.grid.x) * launch.block.x;
    gridDim = launch.grid;
    blockDim = launch.block;
    const SharedMemory shared(launch.sharedBytes);
    std::vector<unsigned> blocks = firstNumbers(launch.grid.x);
    shuffle()(blocks);
    for (const unsigned block : blocks) {
        blockIdx.x = block;
        shared.fill();
        if (!runBlock(launch.block.x, launch.thread)) break;
        if (shared.intact()) continue;
        fault("something was written behind the " + std::to_string(launch.sharedBytes)
              + " bytes of shared memory of a block");
        break;
    }
    running = nullptr;
}

void fault(const std::string& what)
{
    lastFault_ = what + (running ? ", in " + running->name : std::string());
    std::fprintf(stderr, "CUDA stand-in: %s\n", lastFault_.c_str());
}

const std::string& lastFault()
{
    return lastFault_;
}

void reset()
{
    lastFault_.clear();
    launches_ = 0;
}

} // namespace cudaStandIn
