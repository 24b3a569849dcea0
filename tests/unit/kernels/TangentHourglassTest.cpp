#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

// `plastic tangent`: an element that flows bends with H / (E + H) of the elastic stiffness.
TEST(TangentHourglass, ForcesFollowTheTangentWhileTheElementFlows)
{
    const double young = 70000, poisson = 0.3, yieldStress = 285, modulus = 7000;
    MaterialConstants<double> m = materialOf(young, poisson, yieldStress, modulus);
    m.general.tangentHourglass = true;
    const auto bendingForce = [&](bool flowing) {
        Element<GeneralPlasticity, PhysicalHourglass> element(m, brick(1, 1, 1));
        Corners next = element.x;
        next.col(0) *= flowing ? 1.02 : 1.0;
        element.advance(next);
        const Vec3<double> before = element.state.hourglass[1];
        next = element.x;
        next.col(0) *= flowing ? 1.001 : 1.0;
        for (int i = 0; i < 8; ++i) // mode zeta xi in x
            next(i, 0) += 1e-6 * cornerSign[i][2] * cornerSign[i][0];
        element.advance(next);
        EXPECT_EQ(element.step.plasticStrainIncrement > 0, flowing);
        // but for the stretch of the step, 1e-3
        const double work = 8e-6 * (before.x + element.state.hourglass[1].x) / 2;
        EXPECT_NEAR(element.step.hourglass, work, 1e-3 * std::abs(work));
        return element.state.hourglass[1].x - before.x;
    };
    const double ratio = bendingForce(true) / bendingForce(false);
    EXPECT_NEAR(ratio, modulus / (young + modulus), 0.03 * ratio); // the brick has grown by 2 %
}
