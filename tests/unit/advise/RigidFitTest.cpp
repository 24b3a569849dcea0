#include "advise/RigidFit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fpm {
namespace {

/// Corners of a brick 1 x 2 x 3.
std::vector<Point> corners()
{
    std::vector<Point> points;
    for (int i = 0; i < 8; ++i)
        points.push_back({double(i & 1), 2.0 * (i >> 1 & 1), 3.0 * (i >> 2 & 1)});
    return points;
}

/// Turned by `angle` about z, moved, and stretched along its own z by `stretch`.
std::vector<Point> moved(double angle, double stretch)
{
    std::vector<Point> points = corners();
    for (Point& p : points)
        p = {std::cos(angle) * p[0] - std::sin(angle) * p[1] + 5,
             std::sin(angle) * p[0] + std::cos(angle) * p[1] - 7, (1 + stretch) * p[2] + angle};
    return points;
}

} // namespace

TEST(RigidFit, TurnsAndTranslationsAreNoDeviation)
{
    RigidFit fit;
    for (const double angle : {0.0, 0.5, 1.4, 2.3, 3.2, 4.0})
        EXPECT_LT(fit.deviation(corners(), moved(angle, 0)), 1e-12) << angle;
}

TEST(RigidFit, AStretchIsItsRootMeanSquare)
{
    RigidFit fit;
    // Both ends are 1.5 from the middle: each is off by 1.5 stretch.
    EXPECT_NEAR(fit.deviation(corners(), moved(0.7, 0.02)), 0.03, 1e-12);
}

} // namespace fpm
