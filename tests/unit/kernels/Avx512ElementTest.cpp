// The same comparison as BatchElementTest with registers of 512 bits. Everything from the standard
// library comes before the pragma, so that no shared inline function is compiled for AVX-512.
#include <gtest/gtest.h>
#include <immintrin.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#pragma GCC push_options
#pragma GCC target("arch=x86-64-v4")

#include "unit/kernels/BatchLanes.h"

namespace {

std::vector<BatchOutcome> eightDoubles(const std::vector<BatchCase>& cases)
{
    return outcomes<fpm::Batch<double, 8>>(cases);
}

std::vector<BatchOutcome> sixteenFloats(const std::vector<BatchCase>& cases)
{
    return outcomes<fpm::Batch<float, 16>>(cases);
}

std::vector<BatchOutcome> eightGeneralDoubles(const std::vector<BatchCase>& cases)
{
    return generalOutcomes<fpm::Batch<double, 8>>(cases);
}

std::vector<BatchOutcome> sixteenGeneralFloats(const std::vector<BatchCase>& cases)
{
    return generalOutcomes<fpm::Batch<float, 16>>(cases);
}

} // namespace

#pragma GCC pop_options

namespace {

bool avx512()
{
    return __builtin_cpu_supports("x86-64-v4");
}

} // namespace

TEST(Avx512Element, EightDoublesEqualScalarCodeToTheLastBit)
{
    if (!avx512()) GTEST_SKIP() << "this processor has no AVX-512";
    const auto cases = fpm::test::batchCases(256);
    fpm::test::expectEqualBits(eightDoubles(cases), fpm::test::scalarOutcomes(cases));
}

TEST(Avx512Element, SixteenFloatsEqualScalarCodeToTheLastBit)
{
    if (!avx512()) GTEST_SKIP() << "this processor has no AVX-512";
    const auto cases = fpm::test::batchCases(256);
    fpm::test::expectEqualBits(sixteenFloats(cases), fpm::test::scalarFloatOutcomes(cases));
}

TEST(Avx512Element, EveryGeneralLawEqualsScalarCodeToTheLastBit)
{
    if (!avx512()) GTEST_SKIP() << "this processor has no AVX-512";
    const auto cases = fpm::test::batchCases(256);
    fpm::test::expectEqualBits(eightGeneralDoubles(cases), fpm::test::generalScalarOutcomes(cases));
    fpm::test::expectEqualBits(sixteenGeneralFloats(cases),
                               fpm::test::generalScalarFloatOutcomes(cases));
}
