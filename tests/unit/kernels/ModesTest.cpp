#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

/// The eight sign patterns at a corner, in the order of Modes.
std::array<double, 8> patterns(int corner)
{
    const double xi = cornerSign[corner][0], eta = cornerSign[corner][1],
                 zeta = cornerSign[corner][2];
    return {1, xi, eta, zeta, xi * eta, eta * zeta, zeta * xi, xi * eta * zeta};
}

} // namespace

TEST(Modes, SumTheCornersOverTheSignPatterns)
{
    for (int corner = 0; corner < 8; ++corner) {
        double c[8] = {}, m[8];
        c[corner] = 1;
        toModes(c, m);
        for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(m[k], patterns(corner)[k]);
    }
}

TEST(Modes, GiveEachCornerItsPatternBack)
{
    for (std::size_t k = 1; k < 8; ++k) {
        double m[8] = {}, c[8];
        m[k] = 1;
        toCorners(m, c);
        for (int corner = 0; corner < 8; ++corner) EXPECT_EQ(c[corner], patterns(corner)[k]);
    }
}

TEST(Modes, ThereAndBackIsEightTimesTheShapeWithoutItsMean)
{
    std::mt19937 random(1);
    const Corners x = randomCorners(random, 1);
    const Corners back = cornersOf(modesOf(x)) / 8;
    const Corners shape = x.rowwise() - x.colwise().mean();
    EXPECT_LT((back - shape).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Modes, DoNotSeeATranslation)
{
    std::mt19937 random(2);
    // Numbers with few digits: the sums are exact, so the modes must be equal to the last bit.
    const Corners x = (randomCorners(random, 1024)).array().round();
    Corners moved = x;
    moved.rowwise() += Eigen::RowVector3d(512, -256, 128);
    const Modes<double> a = modesOf(x), b = modesOf(moved);
    for (int k = 1; k < 8; ++k) {
        EXPECT_EQ(a.mode[k].x, b.mode[k].x);
        EXPECT_EQ(a.mode[k].y, b.mode[k].y);
        EXPECT_EQ(a.mode[k].z, b.mode[k].z);
    }
}
