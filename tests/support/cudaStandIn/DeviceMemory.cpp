#include "support/cudaStandIn/Device.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace cudaStandIn::memory {

namespace {

constexpr std::size_t page = 4096;

/// Whole pages between two that nobody may touch; the array ends where they end, to 16 bytes (CUDA
/// aligns to 256), so that the first element behind it lies in the guard or in checked bytes.
struct Allocation {
    std::byte *pages = nullptr, *array = nullptr;
    std::size_t pageBytes = 0, bytes = 0;
};

std::map<std::uintptr_t, Allocation>& allocations()
{
    static std::map<std::uintptr_t, Allocation> all;
    return all;
}

std::size_t used = 0;

std::uintptr_t address(const void* memory)
{
    return reinterpret_cast<std::uintptr_t>(memory);
}

/// The allocation that an address lies in or just behind.
const Allocation* find(std::uintptr_t wanted)
{
    auto next = allocations().upper_bound(wanted);
    if (next == allocations().begin()) return nullptr;
    const Allocation& found = std::prev(next)->second;
    return wanted <= address(found.array) + found.bytes ? &found : nullptr;
}

void protect(const Allocation& allocation, int access)
{
    mprotect(allocation.pages, allocation.pageBytes, access);
}

bool intact(const std::byte* first, const std::byte* last)
{
    const auto* word = reinterpret_cast<const std::byte*>(&garbage);
    for (; first != last; ++first)
        if (*first != word[address(first) % sizeof garbage]) return false;
    return true;
}

} // namespace

std::size_t free()
{
    return memoryBytes - used;
}

void* allocate(std::size_t bytes)
{
    if (bytes == 0 || bytes > memoryBytes - used) return nullptr;
    Allocation made;
    made.bytes = bytes;
    made.pageBytes = (bytes + page - 1) / page * page;
    void* const all = mmap(nullptr, made.pageBytes + 2 * page, PROT_NONE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (all == MAP_FAILED) return nullptr;
    made.pages = static_cast<std::byte*>(all) + page;
    made.array = made.pages + made.pageBytes - (bytes + 15) / 16 * 16;
    protect(made, PROT_READ | PROT_WRITE);
    std::fill_n(reinterpret_cast<std::uint32_t*>(made.pages), made.pageBytes / sizeof garbage,
                garbage);
    protect(made, PROT_NONE);
    used += bytes;
    allocations()[address(made.array)] = made;
    return made.array;
}

bool release(void* memory)
{
    const auto at = allocations().find(address(memory));
    if (at == allocations().end()) return false;
    const Allocation& freed = at->second;
    protect(freed, PROT_READ);
    if (!intact(freed.pages, freed.array)
        || !intact(freed.array + freed.bytes, freed.pages + freed.pageBytes))
        fault("something was written beside an allocation of " + std::to_string(freed.bytes)
              + " bytes");
    // The addresses are not given to anybody else: who still has them is found out.
    protect(freed, PROT_NONE);
    madvise(freed.pages, freed.pageBytes, MADV_DONTNEED);
    used -= freed.bytes;
    allocations().erase(at);
    return true;
}

bool holds(const void* memory, std::size_t bytes)
{
    const Allocation* found = find(address(memory));
    return found && address(memory) + bytes <= address(found->array) + found->bytes;
}

bool forbidden(std::uintptr_t wanted)
{
    // Stack, heap and libraries of Linux lie here; two integers side by side, or a double, do not.
    constexpr std::uintptr_t least = std::uintptr_t(1) << 46, most = std::uintptr_t(1) << 47;
    if (wanted < least || wanted >= most || find(wanted)) return false;
    return msync(reinterpret_cast<void*>(wanted / page * page), page, MS_ASYNC) == 0;
}

void open()
{
    for (const auto& [at, allocation] : allocations()) protect(allocation, PROT_READ | PROT_WRITE);
}

void close()
{
    for (const auto& [at, allocation] : allocations()) protect(allocation, PROT_NONE);
}

} // namespace cudaStandIn::memory
