#include "kernels/particle/Turn.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fpm;

namespace {

constexpr long double toRadians = 3.14159265358979323846264338327950288L / 180;

} // namespace

TEST(Turn, IsTheSineAndOneLessTheCosineOfDegrees)
{
    for (double degrees = -1000; degrees < 1000; degrees += 0.37) {
        const Turn turn = turnBy(degrees);
        const long double angle = degrees * toRadians, half = std::sin(angle / 2);
        EXPECT_NEAR(turn.sine, double(std::sin(angle)), 4e-16) << degrees;
        EXPECT_NEAR(turn.versine, double(2 * half * half), 4e-16) << degrees;
    }
}

TEST(Turn, KeepsAllDigitsOfASmallAngle)
{
    for (const double degrees : {1e-9, -3e-5, 0.01, 1.0}) {
        const Turn turn = turnBy(degrees);
        const long double angle = degrees * toRadians, half = std::sin(angle / 2);
        EXPECT_NEAR(turn.sine / double(std::sin(angle)), 1, 4e-16) << degrees;
        EXPECT_NEAR(turn.versine / double(2 * half * half), 1, 8e-16) << degrees;
    }
}

TEST(Turn, IsExactAtQuarters)
{
    const double sine[4] = {0, 1, 0, -1}, versine[4] = {0, 1, 2, 1};
    for (int quarter = -8; quarter <= 8; ++quarter) {
        const Turn turn = turnBy(90.0 * quarter);
        EXPECT_EQ(turn.sine, sine[quarter & 3]);
        EXPECT_EQ(turn.versine, versine[quarter & 3]);
    }
}
