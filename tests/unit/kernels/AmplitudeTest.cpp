#include "kernels/particle/Amplitude.h"

#include <gtest/gtest.h>

#include <vector>

using namespace fpm;

namespace {

// Two tables behind one another: (0 0) (1 2) (3 -2), then the constant 7.
const std::vector<double> rows{0, 0, 1, 2, 3, -2, 0, 7};

Condition condition(Index first, Index count, bool smooth = false)
{
    Condition c{};
    c.firstRow = first;
    c.rowCount = count;
    c.smooth = smooth;
    return c;
}

} // namespace

TEST(Amplitude, RunsStraightFromRowToRowAndIsHeldOutside)
{
    const Condition c = condition(0, 3);
    const double at[6][2] = {{-1, 0}, {0, 0}, {0.25, 0.5}, {1, 2}, {2, 0}, {9, -2}};
    for (const auto& pair : at) EXPECT_DOUBLE_EQ(amplitudeAt(c, rows.data(), pair[0]), pair[1]);
}

TEST(Amplitude, OfASingleRowIsConstant)
{
    const Condition c = condition(3, 1);
    for (const double time : {-1.0, 0.0, 5.0}) EXPECT_EQ(amplitudeAt(c, rows.data(), time), 7);
}

TEST(Amplitude, SmoothRowsMeetWithoutAKink)
{
    const Condition c = condition(0, 3, true);
    EXPECT_DOUBLE_EQ(amplitudeAt(c, rows.data(), 0.5), 1);
    EXPECT_DOUBLE_EQ(amplitudeAt(c, rows.data(), 0.25), 2 * 0.103515625);
    EXPECT_EQ(amplitudeAt(c, rows.data(), 1), 2);
    const double h = 1e-4;
    for (const double time : {h, 1 - h, 1 + h, 3 - h}) {
        const double slope =
            (amplitudeAt(c, rows.data(), time + h) - amplitudeAt(c, rows.data(), time - h))
            / (2 * h);
        EXPECT_LT(std::abs(slope), 1e-5);
    }
}

/// A point 2 from the axis z turned by 30 degrees: along x by 2 (cos - 1), along y by 2 sin.
TEST(Amplitude, OfARotationMovesAPointOnItsCircle)
{
    Condition c = condition(0, 2);
    c.kind = ConditionKind::rotation;
    c.value[0] = 60; // amplitude 0.5 at time 0.25
    const ConditionUse alongX{0, 0, 0, -2}, alongY{0, 1, 2, 0};
    EXPECT_NEAR(pathAt(c, alongX, rows.data(), 0.25), 2 * (std::sqrt(0.75) - 1), 1e-15);
    EXPECT_NEAR(pathAt(c, alongY, rows.data(), 0.25), 1, 1e-15);
    EXPECT_NEAR(drivenVelocity(c, alongY, rows.data(), 0.25, 0.25), 4, 1e-14);
}
