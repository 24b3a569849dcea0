#include "parallel/ExpLog.h"

#include "parallel/Batch.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

using namespace fpm;

namespace {

/// Largest relative error of `ours` against the C library in long double.
template <class Real, class Ours, class Exact>
double worstError(const Ours& ours, const Exact& exact, const std::vector<double>& arguments)
{
    double worst = 0;
    for (const double argument : arguments) {
        const Real x = Real(argument);
        const long double expected = exact(static_cast<long double>(x));
        const long double error = std::abs((static_cast<long double>(ours(x)) - expected)
                                           / (expected == 0 ? 1.0L : expected));
        worst = std::max(worst, double(error));
    }
    return worst;
}

std::vector<double> spread(double low, double high, int count = 200000)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> distribution(low, high);
    std::vector<double> values(static_cast<std::size_t>(count));
    for (double& value : values) value = distribution(random);
    return values;
}

std::vector<double> magnitudes(double low, double high)
{
    std::vector<double> values = spread(low, high);
    for (double& value : values) value = std::exp2(value);
    for (int i = -200; i <= 200; ++i) values.push_back(1 + i * 1e-6);
    return values;
}

/// Every lane of a batch against scalar code, bit by bit.
template <class B, class Function>
void expectLanesOfScalars(const Function& function, const std::vector<double>& arguments)
{
    using Real = ScalarOf<B>;
    constexpr std::size_t width = std::size_t(NumberTraits<B>::lanes);
    alignas(64) Real in[width], out[width];
    for (std::size_t i = 0; i + width <= arguments.size(); i += width) {
        for (std::size_t lane = 0; lane < width; ++lane) in[lane] = Real(arguments[i + lane]);
        store(out, function(read<B>(in)));
        for (std::size_t lane = 0; lane < width; ++lane) {
            const Real expected = function(in[lane]);
            ASSERT_EQ(std::memcmp(&out[lane], &expected, sizeof expected), 0) << in[lane];
        }
    }
}

const auto exponentialOf = [](const auto& x) { return exponential(x); };
const auto logarithmOf = [](const auto& x) { return naturalLogarithm(x); };

} // namespace

TEST(ExpLog, ExponentialAgreesWithTheLibrary)
{
    const auto exact = [](long double x) { return std::exp(x); };
    EXPECT_LT((worstError<double>(exponentialOf, exact, spread(-700, 700))), 1e-15);
    EXPECT_LT((worstError<double>(exponentialOf, exact, spread(-1e-3, 1e-3))), 1e-15);
    EXPECT_LT((worstError<float>(exponentialOf, exact, spread(-86, 86))), 3e-7);
}

TEST(ExpLog, LogarithmAgreesWithTheLibrary)
{
    const auto exact = [](long double x) { return std::log(x); };
    EXPECT_LT((worstError<double>(logarithmOf, exact, magnitudes(-1000, 1000))), 1e-15);
    EXPECT_LT((worstError<double>(logarithmOf, exact, magnitudes(-1, 1))), 1e-15);
    EXPECT_LT((worstError<float>(logarithmOf, exact, magnitudes(-120, 120))), 3e-7);
    EXPECT_EQ(naturalLogarithm(1.0), 0);
}

TEST(ExpLog, PowerAgreesWithTheLibrary)
{
    for (const double y : {0.2, 0.31, 1.09, 3.0}) {
        const auto ours = [&](const auto& x) { return power(x, decltype(x + x)(y)); };
        EXPECT_LT((worstError<double>(
                      ours, [&](long double x) { return std::pow(x, static_cast<long double>(y)); },
                      magnitudes(-30, 30))),
                  1e-13);
        const float narrow = float(y);
        const auto oursFloat = [&](const auto& x) { return power(x, narrow); };
        EXPECT_LT((worstError<float>(
                      oursFloat,
                      [&](long double x) { return std::pow(x, static_cast<long double>(narrow)); },
                      magnitudes(-3, 3))),
                  1e-6);
        EXPECT_EQ(power(0.0, y), 0);
    }
}

TEST(ExpLog, ExtremeArgumentsStayFinite)
{
    for (const double x : {-1e300, 1e300, -709.0, 709.0}) {
        EXPECT_TRUE(std::isnormal(exponential(x)));
        EXPECT_TRUE(std::isnormal(exponential(float(std::clamp(x, -1e30, 1e30)))));
    }
    EXPECT_TRUE(std::isfinite(naturalLogarithm(std::numeric_limits<double>::infinity())));
}

TEST(ExpLog, BatchesEqualScalarsToTheLastBit)
{
    expectLanesOfScalars<Batch<double, 4>>(exponentialOf, spread(-800, 800, 20000));
    expectLanesOfScalars<Batch<float, 8>>(exponentialOf, spread(-100, 100, 20000));
    expectLanesOfScalars<Batch<double, 4>>(logarithmOf, magnitudes(-1000, 1000));
    expectLanesOfScalars<Batch<float, 8>>(logarithmOf, magnitudes(-120, 120));
}

TEST(ExpLog, AnyLaneIsSeen)
{
    alignas(64) const double values[4] = {0, 0, 1, 0};
    using B = Batch<double, 4>;
    const B lanes = read<B>(values);
    EXPECT_TRUE(NumberTraits<B>::any(lanes > B(0.5)));
    EXPECT_FALSE(NumberTraits<B>::any(lanes > B(1.5)));
    EXPECT_TRUE(NumberTraits<double>::any(true));
}
