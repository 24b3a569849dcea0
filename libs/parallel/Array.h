#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace fpm {

/// n values in one memory space (HostSpace, CudaSpace) for their whole life; zero at first.
/// Move-only. Kernels get data(); the host gets copies by name (toHost), never an element.
template <class T, class Space>
class Array
{
public:
    Array() = default;
    explicit Array(std::size_t size) : size_(size)
    {
        if (size_ > 0) data_ = static_cast<T*>(Space::allocate(size_ * sizeof(T)));
    }
    explicit Array(const std::vector<T>& values) : Array(values.size()) { fromHost(values); }
    Array(Array&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)),
          size_(std::exchange(other.size_, 0))
    {
    }
    Array& operator=(Array&& other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }
    ~Array() { Space::release(data_); }

    T* data() { return data_; }
    const T* data() const { return data_; }
    std::size_t size() const { return size_; }
    std::size_t bytes() const { return size_ * sizeof(T); }

    void fromHost(const std::vector<T>& values)
    {
        if (size_ > 0) Space::toDevice(data_, values.data(), bytes());
    }
    std::vector<T> toHost() const
    {
        std::vector<T> values(size_);
        if (size_ > 0) Space::toHost(values.data(), data_, bytes());
        return values;
    }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

} // namespace fpm
