#pragma once

#include "parallel/Math.h"

#include <type_traits>

namespace fpm {

// Exponential, logarithm and power from + - * / fma and the bits of a number: unlike those of the C
// library they are the same to the last bit on every backend and vector width. Largest relative
// error of exponential and naturalLogarithm: 1e-15 in double, 3e-7 in float (ExpLogTest).

/// The parts of a positive normal number: value = significand 2^exponent.
template <class T>
struct NumberParts {
    T significand; ///< in [1, 2)
    T exponent;
};

/// Layout of a floating-point number; Word holds its bits.
template <class Scalar>
struct NumberFormat;
template <>
struct NumberFormat<double> {
    using Word = std::uint64_t;
    static constexpr int fraction = 52, bias = 1023;
};
template <>
struct NumberFormat<float> {
    using Word = std::uint32_t;
    static constexpr int fraction = 23, bias = 127;
};

/// x rounded to an integer, |x| < 2^21: the sum with 1.5 2^fraction has no digits behind the point.
template <class T>
FPM_KERNEL T rounded(const T& x)
{
    using Real = ScalarOf<T>;
    const T shift = T(
        Real(3) * Real(typename NumberFormat<Real>::Word(1) << (NumberFormat<Real>::fraction - 1)));
    return (x + shift) - shift;
}

/// 2^n for an integer n of a normal power.
template <class T>
FPM_KERNEL T powerOfTwo(const T& n)
{
    using Format = NumberFormat<ScalarOf<T>>;
    using Real = ScalarOf<T>;
    using Word = typename Format::Word;
    // The lowest bits of the sum are n + bias, which is the exponent field of 2^n.
    const T shift = T(Real(Word(3) << (Format::fraction - 1)) + Real(Format::bias));
    return NumberTraits<T>::fromWord(NumberTraits<T>::word(n + shift) << Format::fraction);
}

template <class T>
FPM_KERNEL NumberParts<T> numberParts(const T& x)
{
    using Format = NumberFormat<ScalarOf<T>>;
    using Real = ScalarOf<T>;
    using Word = typename Format::Word;
    using Traits = NumberTraits<T>;
    const auto bits = Traits::word(x);
    const Word fractionMask = (Word(1) << Format::fraction) - 1;
    const Word one = Word(Format::bias) << Format::fraction;
    // 2^fraction plus a small integer holds that integer in its lowest bits.
    const Real shift = Real(Word(1) << Format::fraction);
    const Word shiftBits = Word(Format::bias + Format::fraction) << Format::fraction;
    return {Traits::fromWord((bits & fractionMask) | one),
            Traits::fromWord((bits >> Format::fraction) | shiftBits)
                - T(shift + Real(Format::bias))};
}

/// e^x; x is held within +-708 (float +-87), where the result is a normal number.
template <class T>
FPM_KERNEL T exponential(const T& x)
{
    using Real = ScalarOf<T>;
    constexpr bool wide = std::is_same_v<Real, double>;
    const T limit = T(Real(wide ? 708 : 87));
    const T held = -maximum(-maximum(x, -limit), -limit);
    const T n = rounded(held * T(Real(1.4426950408889634074)));
    // ln 2 in two parts (Cody and Waite): r keeps its digits.
    const Real high = wide ? Real(0x1.62e42fefa39efp-1) : Real(0x1.62e43p-1f);
    const Real low = wide ? Real(0x1.abc9e3b39803fp-56) : Real(-0x1.05c61p-29f);
    T r = fusedMultiplyAdd(n, T(-high), held);
    r = fusedMultiplyAdd(n, T(-low), r);
    // Taylor's series on |r| <= ln 2 / 2: the first term left out is below 4e-18 (float 5e-9).
    constexpr int terms = wide ? 13 : 7;
    T sum = T(Real(1));
    for (int k = terms; k >= 1; --k)
        sum = fusedMultiplyAdd(sum * T(Real(1) / Real(k)), r, T(Real(1)));
    return sum * powerOfTwo(n);
}

/// ln x of a positive normal number.
template <class T>
FPM_KERNEL T naturalLogarithm(const T& x)
{
    using Real = ScalarOf<T>;
    constexpr bool wide = std::is_same_v<Real, double>;
    const T one = T(Real(1));
    NumberParts<T> parts = numberParts(x);
    const auto large = parts.significand > T(Real(1.4142135623730951));
    const T m = select(large, T(Real(0.5)) * parts.significand, parts.significand);
    const T e = select(large, parts.exponent + one, parts.exponent);
    // ln m = 2 artanh(f) on |f| < 0.172: terms left out are below 3e-17 (float 1e-9).
    const T f = (m - one) / (m + one), square = f * f;
    constexpr int terms = wide ? 10 : 4;
    T sum = T(Real(1) / Real(2 * terms + 1));
    for (int k = terms - 1; k >= 1; --k)
        sum = fusedMultiplyAdd(sum, square, T(Real(1) / Real(2 * k + 1)));
    const Real high = wide ? Real(0x1.62e42fefa39efp-1) : Real(0x1.62e43p-1f);
    const Real low = wide ? Real(0x1.abc9e3b39803fp-56) : Real(-0x1.05c61p-29f);
    const T twice = f + f;
    const T series = fusedMultiplyAdd(twice * square, sum, twice);
    return fusedMultiplyAdd(e, T(high), fusedMultiplyAdd(e, T(low), series));
}

/// x^y of x >= 0; 0^y is 0 for y > 0. Relative error (1 + |y ln x|) times that of the logarithm.
template <class T>
FPM_KERNEL T power(const T& x, const T& y)
{
    using Real = ScalarOf<T>;
    const T smallest = T(Real(1e-37)), zero = T(Real(0));
    return select(x > smallest, exponential(y * naturalLogarithm(maximum(x, smallest))), zero);
}

} // namespace fpm
