#pragma once

// What PTX instructions do, for functions that `translate` makes of them (PTX ISA 9.0). Rounding is
// IEEE 754's, to nearest; compiled without contraction.

#include "support/cudaStandIn/cudaStandIn.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace fpm {
extern std::byte blockScratch[];
}

namespace ptx {

inline double D(std::uint64_t bits)
{
    return std::bit_cast<double>(bits);
}
inline float F(std::uint32_t bits)
{
    return std::bit_cast<float>(bits);
}
inline std::uint64_t U64(double number)
{
    return std::bit_cast<std::uint64_t>(number);
}
inline std::uint32_t U32(float number)
{
    return std::bit_cast<std::uint32_t>(number);
}

/// A fused multiply-add; `told` gets bit 0, and bit 1 where product and sum would have given
/// something else.
inline double fused(unsigned char& told, double a, double b, double c)
{
    const double result = __builtin_fma(a, b, c);
    told |= U64(result) == U64(a * b + c) ? 1 : 3;
    return result;
}
inline float fused(unsigned char& told, float a, float b, float c)
{
    const float result = __builtin_fmaf(a, b, c);
    told |= U32(result) == U32(a * b + c) ? 1 : 3;
    return result;
}
inline double sqrtRounded(double a)
{
    return __builtin_sqrt(a);
}
inline float sqrtRounded(float a)
{
    return __builtin_sqrtf(a);
}
inline double floorOf(double a)
{
    return __builtin_floor(a);
}
template <class T>
bool eitherNaN(T a, T b)
{
    return a != a || b != b;
}
/// Of a NaN and a number the number; -0 below +0.
template <class T>
T minimum(T a, T b)
{
    if (a != a) return b;
    if (b != b) return a;
    if (a == 0 && b == 0) return std::signbit(a) ? a : b;
    return a < b ? a : b;
}
template <class T>
T maximum(T a, T b)
{
    if (a != a) return b;
    if (b != b) return a;
    if (a == 0 && b == 0) return std::signbit(a) ? b : a;
    return a > b ? a : b;
}

template <class T>
T shl(T a, std::uint32_t places)
{
    return places >= 8 * sizeof(T) ? T(0) : T(a << places);
}
template <class T>
T shr(T a, std::uint32_t places)
{
    return places >= 8 * sizeof(T) ? (a < 0 ? T(-1) : T(0)) : T(a >> places);
}
/// The lowest `length` bits of a in the place of those of b from `first` on.
inline std::uint32_t
bfi(std::uint32_t a, std::uint32_t b, std::uint32_t first, std::uint32_t length)
{
    const std::uint32_t mask = (length >= 32 ? ~0u : (1u << length) - 1) << first;
    return (b & ~mask) | ((a << first) & mask);
}
/// Towards zero; what does not fit becomes the nearest integer that does, a NaN the least.
template <class I, class R>
I toInteger(R number)
{
    constexpr I least = I(I(1) << (8 * sizeof(I) - 1)), most = I(~least);
    if (number != number) return least;
    if (number >= R(most)) return most;
    if (number <= R(least)) return least;
    return I(number);
}

/// A GPU refuses an access that is not aligned to its size.
inline void aligned(std::uint64_t address, unsigned bytes)
{
    if ((address & (bytes - 1)) == 0) return;
    std::fprintf(stderr, "PTX: access of %u bytes at %#llx, which is not aligned\n", bytes,
                 static_cast<unsigned long long>(address));
    std::abort();
}
#define SHARED(offset) (std::uint64_t(fpm::blockScratch) + std::uint64_t(std::int64_t(offset)))

/// What local memory holds that nobody wrote.
inline void fillLocal(unsigned char* memory, unsigned bytes)
{
    for (unsigned i = 0; i + 4 <= bytes; i += 4) std::memcpy(memory + i, &cudaStandIn::garbage, 4);
}

/// Enters a translated kernel by its mangled name.
struct Known {
    Known(const char* name, cudaStandIn::Body body);
};
/// Enters the fused multiply-adds of a module.
struct KnownFused {
    KnownFused(const char* module, const unsigned char* told, std::size_t count);
};

} // namespace ptx
