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
    /// Throws Error(device) where so much would not fit.
    virtual void require(std::size_t) const {}
    virtual void* allocate(std::size_t bytes) const = 0;
    virtual void release(void* memory) const = 0;
    virtual void toDevice(void* to, const void* from, std::size_t bytes) const = 0;
    virtual void toHost(void* to, const void* from, std::size_t bytes) const = 0;
};

/// The memory of HostSpace or CudaSpace.
template <class Space>
class MemoryOf final : public Memory
{
public:
    void require(std::size_t bytes) const override
    {
        if constexpr (requires { Space::requireMemory(bytes); }) Space::requireMemory(bytes);
    }
    void* allocate(std::size_t bytes) const override { return Space::allocate(bytes); }
    void release(void* memory) const override { Space::release(memory); }
    void toDevice(void* to, const void* from, std::size_t bytes) const override
    {
        Space::toDevice(to, from, bytes);
    }
    void toHost(void* to, const void* from, std::size_t bytes) const override
    {
        Space::toHost(to, from, bytes);
    }
};

} // namespace fpm
