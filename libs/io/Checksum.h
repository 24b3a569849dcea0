#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fpm {

/// 64-bit checksum of a stream of bytes, eight at a time. Finds damage, not forgery: any change
/// within one 8-byte word changes the result, others go unseen with probability 2^-64. The result
/// depends on the bytes only, not on how they were divided among calls.
class Checksum
{
public:
    void add(std::span<const std::byte> bytes);
    void add(std::string_view text);
    /// The length, then the values in memory order.
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void add(const std::vector<T>& values)
    {
        addNumber(values.size());
        add(std::as_bytes(std::span(values)));
    }
    void addNumber(std::uint64_t number);

    std::uint64_t value() const;
    /// Sixteen hexadecimal digits.
    std::string text() const;

private:
    std::uint64_t state_ = 0x9e3779b97f4a7c15U;
    std::uint64_t length_ = 0;
    std::uint64_t pending_ = 0; ///< the last length_ % 8 bytes
};

} // namespace fpm
