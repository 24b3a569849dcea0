#include "fields/Value.h"

#include <cstdlib>
#include <cstring>
#include <new>

namespace fpm {

namespace {

class HostMemory final : public Memory
{
public:
    void* allocate(std::size_t bytes) const override
    {
        void* memory = std::calloc(bytes, 1);
        if (!memory) throw std::bad_alloc();
        return memory;
    }
    void release(void* memory) const override { std::free(memory); }
    void toDevice(void* to, const void* from, std::size_t bytes) const override
    {
        std::memcpy(to, from, bytes);
    }
    void toHost(void* to, const void* from, std::size_t bytes) const override
    {
        std::memcpy(to, from, bytes);
    }
};

} // namespace

const Memory& hostMemory()
{
    static const HostMemory memory;
    return memory;
}

} // namespace fpm
