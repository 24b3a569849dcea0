#pragma once

#include <unistd.h>

#include <cerrno>
#include <utility>

namespace fpm {

/// An open file or folder of the system, closed with the object; -1: none.
class Descriptor
{
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }

    bool isOpen() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Zero, or the error: a full disk may only show here. It is gone in either case.
    int close() { return ::close(release()) == 0 ? 0 : errno; }
    /// For who closes it instead.
    int release() { return std::exchange(number_, -1); }

private:
    int number_;
};

} // namespace fpm
