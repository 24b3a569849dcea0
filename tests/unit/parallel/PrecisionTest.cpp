#include "parallel/Precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fpm;

TEST(Compensated, HoldsADoubleToTwiceTheDigitsOfAFloat)
{
    std::mt19937 random(41);
    std::uniform_real_distribution<double> numbers(-1000, 1000);
    for (int i = 0; i < 1000; ++i) {
        const double x = numbers(random);
        EXPECT_NEAR(double(Compensated(x)), x, std::ldexp(std::abs(x), -47));
    }
}

TEST(Compensated, AddsAMillionSmallStepsWithoutDrift)
{
    const float step = 1.1e-6f;
    Compensated x(100.0);
    float plain = 100;
    for (int n = 0; n < 1000000; ++n) {
        x = advanced(x, step);
        plain += step;
    }
    const double exact = 100 + 1e6 * double(step);
    EXPECT_NEAR(double(x), exact, 1e-6);
    EXPECT_GT(std::abs(double(plain) - exact), 0.1);
}

TEST(Compensated, AStepIsRoundedToTheDigitsOfTheIncrementNotOfThePosition)
{
    std::mt19937 random(42);
    std::uniform_real_distribution<double> position(1, 2), increment(-1e-3, 1e-3);
    for (int i = 0; i < 1000; ++i) {
        const Compensated x(position(random));
        const float step = float(increment(random));
        const double rounding = std::ldexp(std::abs(double(step)) + 1e-7, -24);
        EXPECT_NEAR(double(advanced(x, step)), double(x) + double(step), rounding);
    }
}

TEST(Compensated, DifferenceOfNeighboursKeepsItsDigits)
{
    const double a = 1234.5678, b = 1234.5671;
    EXPECT_NEAR(double(difference<float>(Compensated(a), Compensated(b))), a - b, 1e-10);
    EXPECT_EQ(difference<float>(a, b), float(a - b));
    EXPECT_EQ(difference<double>(a, b), a - b);
}

TEST(Compensated, HighPartIsTheNearestFloat)
{
    const Compensated x(1.0 / 3);
    EXPECT_EQ(x.high, float(1.0 / 3));
    EXPECT_LE(std::abs(x.low), std::ldexp(1.0f, -26));
}
