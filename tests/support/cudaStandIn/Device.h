#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <typeinfo>
#include <vector>

/// The device that stands in for a GPU: its memory, its kernels, its thread blocks.
namespace cudaStandIn {

struct uint3 {
    unsigned x = 0, y = 0, z = 0;
};
struct dim3 {
    unsigned x = 1, y = 1, z = 1;
    dim3(unsigned a = 1, unsigned b = 1, unsigned c = 1) : x(a), y(b), z(c) {}
};

inline constexpr std::size_t mostArgumentBytes = 4096;
inline constexpr std::size_t mostSharedBytes = 227 * 1024, usualSharedBytes = 48 * 1024;
inline constexpr std::size_t memoryBytes = std::size_t(4) << 30;
inline constexpr unsigned mostThreads = 1024;
/// What fresh memory holds: as a double a signalling NaN, as a float a NaN, as an index far
/// outside.
inline constexpr std::uint32_t garbage = 0x7ff4dead;

/// One kernel of the program, launched or not; told apart by the types of the arguments.
struct Kernel {
    std::string name;
    std::size_t argumentBytes = 0;
    std::size_t launches = 0, threads = 0;
};

/// Every kernel that the program can launch, by name.
std::map<std::string, Kernel>& kernels();
Kernel* addKernel(const std::type_info& signature, std::size_t argumentBytes);

template <class... Expected>
constexpr std::size_t argumentBytes()
{
    std::size_t end = 0;
    ((end =
          (end + alignof(Expected) - 1) / alignof(Expected) * alignof(Expected) + sizeof(Expected)),
     ...);
    return end;
}

/// Entered before main, so that kernels that were never launched are known too.
template <class... Expected>
struct Known {
    static inline Kernel* const kernel =
        addKernel(typeid(void(Expected...)), argumentBytes<Expected...>());
};

/// One thread of a kernel, given where its arguments lie.
using Body = void (*)(const unsigned char* const* arguments);
/// Not null: what runs in the place of the kernel at this address (tests/gpu/ptx).
inline Body (*replacement)(const void* kernel) = nullptr;

/// A kernel with its arguments, to be run later, perhaps often.
struct Launch {
    dim3 grid, block;
    std::size_t sharedBytes = 0;
    const void* function = nullptr;
    Kernel* kernel = nullptr;
    std::function<void()> thread;
    std::vector<std::uintptr_t> words; ///< of the arguments, for what looks like an address

    void addWords(const void* argument, std::size_t bytes);
};

/// Device memory. Closed to the host but for the time that kernels or copies run.
namespace memory {

std::size_t free();
/// Null where the device has no more.
void* allocate(std::size_t bytes);
/// False where nothing was allocated there.
bool release(void* memory);
/// Whether all of it lies in one allocation.
bool holds(const void* memory, std::size_t bytes);
/// An address of this process that no kernel may use: of the host, or of memory that was freed.
bool forbidden(std::uintptr_t address);
void open();
void close();

} // namespace memory

/// Runs all threads of all blocks; the blocks one after the other, the threads of a block in turns
/// between barriers, both in shuffled order. Faults go to `fault`.
void run(const Launch& launch);

/// What CUDA would report as a failed launch and forget the reason of: kept until the next reset.
void fault(const std::string& what);
const std::string& lastFault();
void reset();

} // namespace cudaStandIn
