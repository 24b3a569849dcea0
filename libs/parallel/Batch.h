#pragma once

#include "parallel/Math.h"

#include <immintrin.h>

namespace fpm {

template <class S, int W>
struct NativeVector;
template <>
struct NativeVector<double, 4> {
    typedef double Type __attribute__((vector_size(32)));
};
template <>
struct NativeVector<double, 8> {
    typedef double Type __attribute__((vector_size(64)));
};
template <>
struct NativeVector<float, 8> {
    typedef float Type __attribute__((vector_size(32)));
};
template <>
struct NativeVector<float, 16> {
    typedef float Type __attribute__((vector_size(64)));
};

/// `W` numbers worked on at once by one CPU core: a GCC vector with the names of Math.h. Compiled
/// into translation units of their own vector width; templates of distinct W never share symbols.
template <class S, int W>
struct Batch {
    using Native = typename NativeVector<S, W>::Type;
    Native value;

    Batch() = default;
    FPM_KERNEL Batch(S scalar) : value(scalar - Native{}) {}
    FPM_KERNEL explicit Batch(Native native) : value(native) {}

    friend FPM_KERNEL Batch operator+(Batch a, Batch b) { return Batch(a.value + b.value); }
    friend FPM_KERNEL Batch operator-(Batch a, Batch b) { return Batch(a.value - b.value); }
    friend FPM_KERNEL Batch operator*(Batch a, Batch b) { return Batch(a.value * b.value); }
    friend FPM_KERNEL Batch operator/(Batch a, Batch b) { return Batch(a.value / b.value); }
    FPM_KERNEL Batch operator-() const { return Batch(-value); }
    FPM_KERNEL Batch& operator+=(Batch b) { return *this = *this + b; }

    using Mask = decltype(Native{} < Native{});
    friend FPM_KERNEL Mask operator<(Batch a, Batch b) { return a.value < b.value; }
    friend FPM_KERNEL Mask operator>(Batch a, Batch b) { return a.value > b.value; }
    friend FPM_KERNEL Batch select(Mask condition, Batch a, Batch b)
    {
        return Batch(condition ? a.value : b.value);
    }
};

/// x, y and z of the records records[4 * indices[lane] ...] as one vector each.
FPM_KERNEL void transposeRecords(const double* records,
                                 const std::uint16_t* indices,
                                 NativeVector<double, 4>::Type (&out)[3])
{
    const auto row = [=](int lane) { return _mm256_load_pd(records + 4 * indices[lane]); };
    const __m256d a = row(0), b = row(1), c = row(2), d = row(3);
    const __m256d xz0 = _mm256_unpacklo_pd(a, b), y0 = _mm256_unpackhi_pd(a, b);
    const __m256d xz1 = _mm256_unpacklo_pd(c, d), y1 = _mm256_unpackhi_pd(c, d);
    out[0] = NativeVector<double, 4>::Type(_mm256_permute2f128_pd(xz0, xz1, 0x20));
    out[1] = NativeVector<double, 4>::Type(_mm256_permute2f128_pd(y0, y1, 0x20));
    out[2] = NativeVector<double, 4>::Type(_mm256_permute2f128_pd(xz0, xz1, 0x31));
}
FPM_KERNEL void transposeRecords(const float* records,
                                 const std::uint16_t* indices,
                                 NativeVector<float, 8>::Type (&out)[3])
{
    const auto rows = [=](int lane) {
        return _mm256_insertf128_ps(
            _mm256_castps128_ps256(_mm_load_ps(records + 4 * indices[lane])),
            _mm_load_ps(records + 4 * indices[lane + 4]), 1);
    };
    const __m256 a = rows(0), b = rows(1), c = rows(2), d = rows(3);
    const __m256 xy0 = _mm256_unpacklo_ps(a, b), z0 = _mm256_unpackhi_ps(a, b);
    const __m256 xy1 = _mm256_unpacklo_ps(c, d), z1 = _mm256_unpackhi_ps(c, d);
    out[0] = NativeVector<float, 8>::Type(_mm256_shuffle_ps(xy0, xy1, 0x44));
    out[1] = NativeVector<float, 8>::Type(_mm256_shuffle_ps(xy0, xy1, 0xEE));
    out[2] = NativeVector<float, 8>::Type(_mm256_shuffle_ps(z0, z1, 0x44));
}
#ifdef __AVX512F__
FPM_KERNEL void transposeRecords(const double* records,
                                 const std::uint16_t* indices,
                                 NativeVector<double, 8>::Type (&out)[3])
{
    const auto rows = [=](int lane) {
        return _mm512_maskz_insertf64x4(
            __mmask8(-1), _mm512_castpd256_pd512(_mm256_load_pd(records + 4 * indices[lane])),
            _mm256_load_pd(records + 4 * indices[lane + 4]), 1);
    };
    const __m512d a = rows(0), b = rows(1), c = rows(2), d = rows(3);
    // Lanes of a 128-bit pair: x or z in xz, y in y; the lower 256 bits hold 0..3, the upper 4..7.
    const __mmask8 every = __mmask8(-1);
    const __m512d xz0 = _mm512_maskz_unpacklo_pd(every, a, b),
                  y0 = _mm512_maskz_unpackhi_pd(every, a, b);
    const __m512d xz1 = _mm512_maskz_unpacklo_pd(every, c, d),
                  y1 = _mm512_maskz_unpackhi_pd(every, c, d);
    const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    out[0] = NativeVector<double, 8>::Type(_mm512_permutex2var_pd(xz0, low, xz1));
    out[1] = NativeVector<double, 8>::Type(_mm512_permutex2var_pd(y0, low, y1));
    out[2] = NativeVector<double, 8>::Type(_mm512_permutex2var_pd(xz0, high, xz1));
}
FPM_KERNEL void transposeRecords(const float* records,
                                 const std::uint16_t* indices,
                                 NativeVector<float, 16>::Type (&out)[3])
{
    const auto rows = [=](int lane) {
        __m512 joined = _mm512_castps128_ps512(_mm_load_ps(records + 4 * indices[lane]));
        joined = _mm512_maskz_insertf32x4(__mmask16(-1), joined,
                                          _mm_load_ps(records + 4 * indices[lane + 4]), 1);
        joined = _mm512_maskz_insertf32x4(__mmask16(-1), joined,
                                          _mm_load_ps(records + 4 * indices[lane + 8]), 2);
        return _mm512_maskz_insertf32x4(__mmask16(-1), joined,
                                        _mm_load_ps(records + 4 * indices[lane + 12]), 3);
    };
    const __m512 a = rows(0), b = rows(1), c = rows(2), d = rows(3);
    const __mmask16 every = __mmask16(-1);
    const __m512 xy0 = _mm512_maskz_unpacklo_ps(every, a, b),
                 z0 = _mm512_maskz_unpackhi_ps(every, a, b);
    const __m512 xy1 = _mm512_maskz_unpacklo_ps(every, c, d),
                 z1 = _mm512_maskz_unpackhi_ps(every, c, d);
    out[0] = NativeVector<float, 16>::Type(_mm512_maskz_shuffle_ps(every, xy0, xy1, 0x44));
    out[1] = NativeVector<float, 16>::Type(_mm512_maskz_shuffle_ps(every, xy0, xy1, 0xEE));
    out[2] = NativeVector<float, 16>::Type(_mm512_maskz_shuffle_ps(every, z0, z1, 0x44));
}
#endif

template <class S, int W>
struct NumberTraits<Batch<S, W>> {
    using Scalar = S;
    using Native = typename Batch<S, W>::Native;
    static constexpr int lanes = W;

    template <class Stored>
    FPM_KERNEL static Batch<S, W> read(const Stored* p)
    {
        if constexpr (sizeof(Stored) == sizeof(S))
            return Batch<S, W>(*reinterpret_cast<const Native*>(p));
        if constexpr (sizeof(Stored) < sizeof(S)) {
            typedef Stored Narrow __attribute__((vector_size(W * sizeof(Stored))));
            return Batch<S, W>(
                __builtin_convertvector(*reinterpret_cast<const Narrow*>(p), Native));
        }
        Native values;
        for (int lane = 0; lane < W; ++lane) values[lane] = S(p[lane]);
        return Batch<S, W>(values);
    }
    template <class Stored>
    FPM_KERNEL static void store(Stored* p, const Batch<S, W>& value)
    {
        if constexpr (sizeof(Stored) == sizeof(S))
            *reinterpret_cast<Native*>(p) = value.value;
        else if constexpr (sizeof(Stored) < sizeof(S)) {
            typedef Stored Narrow __attribute__((vector_size(W * sizeof(Stored))));
            *reinterpret_cast<Narrow*>(p) = __builtin_convertvector(value.value, Narrow);
        } else
            for (int lane = 0; lane < W; ++lane) p[lane] = Stored(value.value[lane]);
    }
    template <class Stored>
    FPM_KERNEL static void accumulate(Stored* p, const Batch<S, W>& value)
    {
        for (int lane = 0; lane < W; ++lane) p[lane] += Stored(value.value[lane]);
    }
    /// Whole records are loaded and transposed in registers: a third of the work of single loads.
    FPM_KERNEL static void gather(const S* records,
                                  const std::uint16_t* indices,
                                  Batch<S, W>& x,
                                  Batch<S, W>& y,
                                  Batch<S, W>& z)
    {
        Native columns[3];
        transposeRecords(records, indices, columns);
        x.value = columns[0];
        y.value = columns[1];
        z.value = columns[2];
    }
    typedef std::conditional_t<sizeof(S) == 8, std::uint64_t, std::uint32_t> Word
        __attribute__((vector_size(sizeof(Native))));
    FPM_KERNEL static Word word(const Batch<S, W>& value) { return Word(value.value); }
    FPM_KERNEL static Batch<S, W> fromWord(Word bits) { return Batch<S, W>(Native(bits)); }
    FPM_KERNEL static bool any(typename Batch<S, W>::Mask condition)
    {
        bool holds = false;
        for (int lane = 0; lane < W; ++lane) holds |= condition[lane] != 0;
        return holds;
    }
};

template <class S, int W>
FPM_KERNEL Batch<S, W> squareRoot(Batch<S, W> a)
{
    using Native = typename Batch<S, W>::Native;
    if constexpr (sizeof(Native) == 64 && sizeof(S) == 8)
        return Batch<S, W>(Native(_mm512_maskz_sqrt_pd(__mmask8(-1), __m512d(a.value))));
    else if constexpr (sizeof(Native) == 64)
        return Batch<S, W>(Native(_mm512_maskz_sqrt_ps(__mmask16(-1), __m512(a.value))));
    else if constexpr (sizeof(S) == 8)
        return Batch<S, W>(Native(_mm256_sqrt_pd(__m256d(a.value))));
    else
        return Batch<S, W>(Native(_mm256_sqrt_ps(__m256(a.value))));
}

template <class S, int W>
FPM_KERNEL Batch<S, W> fusedMultiplyAdd(Batch<S, W> a, Batch<S, W> b, Batch<S, W> c)
{
    using Native = typename Batch<S, W>::Native;
    if constexpr (sizeof(Native) == 64 && sizeof(S) == 8)
        return Batch<S, W>(
            Native(_mm512_fmadd_pd(__m512d(a.value), __m512d(b.value), __m512d(c.value))));
    else if constexpr (sizeof(Native) == 64)
        return Batch<S, W>(
            Native(_mm512_fmadd_ps(__m512(a.value), __m512(b.value), __m512(c.value))));
    else if constexpr (sizeof(S) == 8)
        return Batch<S, W>(
            Native(_mm256_fmadd_pd(__m256d(a.value), __m256d(b.value), __m256d(c.value))));
    else
        return Batch<S, W>(
            Native(_mm256_fmadd_ps(__m256(a.value), __m256(b.value), __m256(c.value))));
}

} // namespace fpm
