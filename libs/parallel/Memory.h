#pragma once

#include <cstddef>

namespace fpm {

/// The memory that the kernels of one executor reach, for code that is compiled once for all of
/// them. Fresh memory holds zeros. Throws Error(device) or std::bad_alloc where there is too
/// little.
class Memory
{
public:
    virtual ~Memory() = default;
    virtual void* allocate(std::size_t bytes) const = 0;
    virtual void release(void* memory) const = 0;
    virtual void toDevice(void* to, const void* from, std::size_t bytes) const = 0;
    virtual void toHost(void* to, const void* from, std::size_t bytes) const = 0;
};

template <class Executor>
class MemoryOf final : public Memory
{
public:
    void* allocate(std::size_t bytes) const override { return Executor::allocate(bytes); }
    void release(void* memory) const override { Executor::release(memory); }
    void toDevice(void* to, const void* from, std::size_t bytes) const override
    {
        Executor::toDevice(to, from, bytes);
    }
    void toHost(void* to, const void* from, std::size_t bytes) const override
    {
        Executor::toHost(to, from, bytes);
    }
};

} // namespace fpm
