#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace fpm {

/// 64-bit FNV-1a (Fowler, Noll and Vo) over bytes, continuing from `hash`: tells states and texts
/// apart and defends nothing. For whole files there is io/Checksum, eight bytes at a time.
inline constexpr std::uint64_t hashStart = 14695981039346656037ull;

constexpr std::uint64_t hashedByte(std::uint64_t hash, unsigned char byte)
{
    return (hash ^ byte) * 1099511628211ull;
}

inline std::uint64_t hashedBytes(std::uint64_t hash, const void* data, std::size_t size)
{
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) hash = hashedByte(hash, bytes[i]);
    return hash;
}

/// Over the bytes of a value in the order of memory; no padding in it.
template <class T>
requires std::has_unique_object_representations_v<T> || std::is_floating_point_v<T> std::uint64_t
hashed(std::uint64_t hash, const T& value)
{
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes) hash = hashedByte(hash, byte);
    return hash;
}

inline std::uint64_t hashOf(std::string_view text)
{
    std::uint64_t hash = hashStart;
    for (const char letter : text) hash = hashedByte(hash, static_cast<unsigned char>(letter));
    return hash;
}

/// Sixteen hexadecimal digits.
std::string hexText(std::uint64_t number);

} // namespace fpm
