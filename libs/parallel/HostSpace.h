#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

namespace fpm {

/// Ordinary memory, for a Memory, an Array and the executor of the CPU.
struct HostSpace {
    static void* allocate(std::size_t bytes)
    {
        const std::size_t alignment = bytes >= hugePage ? hugePage : 128;
        void* memory =
            std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
        if (!memory) throw std::bad_alloc();
#ifdef __linux__
        // Many arrays are read at once; with small pages their addresses alone fill the TLB.
        if (bytes >= hugePage) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
        std::memset(memory, 0, bytes);
        return memory;
    }
    static void release(void* memory)
    {
        std::free(memory);
    }
    static void toDevice(void* to, const void* from, std::size_t bytes)
    {
        std::memcpy(to, from, bytes);
    }
    static void toHost(void* to, const void* from, std::size_t bytes)
    {
        std::memcpy(to, from, bytes);
    }

private:
    static constexpr std::size_t hugePage = std::size_t(2) << 20;
};

} // namespace fpm
