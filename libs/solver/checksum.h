#pragma once

#include <cstddef>
#include <cstdint>

namespace fpm {

/// 64-bit FNV-1a over the bytes of a value, continuing from `hash`.
template <class T>
std::uint64_t hashed(std::uint64_t hash, const T& value)
{
    const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
    for (std::size_t i = 0; i < sizeof(T); ++i) hash = (hash ^ bytes[i]) * 1099511628211ull;
    return hash;
}
inline constexpr std::uint64_t hashStart = 14695981039346656037ull;

} // namespace fpm
