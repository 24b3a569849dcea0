#pragma once

#include "base/Error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace fpm {

/// Numbers and texts on their way into bytes, or back out of them in the same order: one function
/// that names them serves both ways. Bytes are read without trust: where they end early or claim
/// more than there is, Error(checkpoint).
class Archive
{
public:
    /// Collects.
    Archive() = default;
    /// Gives back what another has collected.
    explicit Archive(std::vector<std::byte> bytes) : bytes_(std::move(bytes)), reads_(true) {}

    bool reads() const { return reads_; }
    const std::vector<std::byte>& bytes() const { return bytes_; }
    /// All that was collected has been given back.
    bool atEnd() const { return place_ == bytes_.size(); }

    /// Arithmetic types and enumerations: no structures, whose padding would be stored.
    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void operator()(T& value) { move(&value, sizeof value); }
    void operator()(bool& value)
    {
        std::uint8_t byte = value;
        (*this)(byte);
        value = byte != 0; // a bool of any other byte is none
    }
    template <class T, std::size_t count>
    void operator()(std::array<T, count>& values)
    {
        for (T& value : values) (*this)(value);
    }
    void operator()(std::string& text)
    {
        text.resize(length(text.size()));
        if (!text.empty()) move(text.data(), text.size());
    }
    /// Values of any type with a function for it: each(archive, value).
    template <class T, class Each>
    void list(std::vector<T>& values, const Each& each)
    {
        const std::size_t count = length(values.size());
        // One by one: a count that the bytes cannot fill costs no more memory than they fill.
        if (reads_) values.clear();
        for (std::size_t i = 0; i < count; ++i)
            each(*this, reads_ ? values.emplace_back() : values[i]);
    }

private:
    /// Of what follows, each of a byte at least.
    std::size_t length(std::size_t own)
    {
        std::uint64_t count = own;
        (*this)(count);
        if (reads_ && count > bytes_.size() - place_) fail();
        return std::size_t(count);
    }
    void move(void* value, std::size_t size)
    {
        if (!reads_) {
            const auto* from = static_cast<const std::byte*>(value);
            bytes_.insert(bytes_.end(), from, from + size);
            return;
        }
        if (size > bytes_.size() - place_) fail();
        std::memcpy(value, bytes_.data() + place_, size);
        place_ += size;
    }
    [[noreturn]] static void fail()
    {
        throw Error(ExitCode::checkpoint, "the record of the run ends early");
    }

    std::vector<std::byte> bytes_;
    std::size_t place_ = 0;
    bool reads_ = false;
};

} // namespace fpm
