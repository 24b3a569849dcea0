#pragma once

#include "parallel/Kernel.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace fpm {

/// Operations of a number type T in kernels: a scalar, or a Batch of lanes with the same names.
/// Only + - * / sqrt and fma, all correctly rounded by IEEE 754: equal bits on every backend.
template <class T>
struct NumberTraits {
    using Scalar = T;
    static constexpr int lanes = 1;
    template <class Stored>
    FPM_KERNEL static T read(const Stored* p)
    {
        return T(*p);
    }
    template <class Stored>
    FPM_KERNEL static void store(Stored* p, const T& value)
    {
        *p = Stored(value);
    }
    template <class Stored>
    FPM_KERNEL static void accumulate(Stored* p, const T& value)
    {
        *p += Stored(value);
    }
    FPM_KERNEL static void gather(const T* records, const std::uint16_t* indices, T& x, T& y, T& z)
    {
        const T* record = records + 4 * std::size_t(*indices);
        x = record[0];
        y = record[1];
        z = record[2];
    }
    /// The bits of a number, and back.
    using Word = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
    FPM_KERNEL static Word word(const T& value)
    {
        Word bits;
        memcpy(&bits, &value, sizeof bits);
        return bits;
    }
    FPM_KERNEL static T fromWord(Word bits)
    {
        T value;
        memcpy(&value, &bits, sizeof value);
        return value;
    }
    /// Whether a condition holds in any lane.
    FPM_KERNEL static bool any(bool condition) { return condition; }
};
template <class T>
using ScalarOf = typename NumberTraits<T>::Scalar;

FPM_KERNEL double squareRoot(double a)
{
    return ::sqrt(a);
}
FPM_KERNEL float squareRoot(float a)
{
    return ::sqrtf(a);
}
FPM_KERNEL double fusedMultiplyAdd(double a, double b, double c)
{
    return ::fma(a, b, c);
}
FPM_KERNEL float fusedMultiplyAdd(float a, float b, float c)
{
    return ::fmaf(a, b, c);
}

/// condition ? a : b, lane by lane.
FPM_KERNEL double select(bool condition, double a, double b)
{
    return condition ? a : b;
}
FPM_KERNEL float select(bool condition, float a, float b)
{
    return condition ? a : b;
}

/// What a comparison of T gives: bool, or one for each lane. They combine by & | !.
template <class T>
using MaskOf = decltype(std::declval<T>() < std::declval<T>());

template <class T>
FPM_KERNEL T magnitude(T a)
{
    return select(a < T(0), -a, a);
}
template <class T>
FPM_KERNEL T maximum(T a, T b)
{
    return select(a < b, b, a);
}

/// The `lanes` consecutive values at p, converted from the type they are stored in.
template <class T, class Stored>
FPM_KERNEL T read(const Stored* p)
{
    return NumberTraits<T>::read(p);
}
template <class T, class Stored>
FPM_KERNEL void store(Stored* p, const T& value)
{
    NumberTraits<T>::store(p, value);
}
/// Prefetches memory that will soon be used; on a processor only. Any address is allowed.
template <class Stored>
FPM_KERNEL void prefetch([[maybe_unused]] const Stored* p)
{
#ifndef __CUDA_ARCH__
    __builtin_prefetch(p);
#endif
}
/// *p += value, in the type it is stored in.
template <class T, class Stored>
FPM_KERNEL void accumulate(Stored* p, const T& value)
{
    NumberTraits<T>::accumulate(p, value);
}
/// The vectors records[indices[lane]] of each lane; a record is x y z and one unused value.
template <class T>
FPM_KERNEL void gather(const ScalarOf<T>* records, const std::uint16_t* indices, T& x, T& y, T& z)
{
    NumberTraits<T>::gather(records, indices, x, y, z);
}

} // namespace fpm
