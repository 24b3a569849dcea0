#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

constexpr double young = 70000, poisson = 0.3, yieldStress = 285;

using Eroding = Element<GeneralPlasticity, StiffnessHourglass>;

MaterialConstants<double> eroding(double strain, bool inverted)
{
    MaterialConstants<double> m = materialOf(young, poisson, yieldStress, 900);
    m.general.erodes = true;
    m.general.erosionStrain = strain;
    m.general.erodesInverted = inverted;
    return m;
}

} // namespace

TEST(Deletion, AnElementBeyondItsPlasticStrainBearsNothingAnyMore)
{
    Eroding element(eroding(0.05, false), brick(1, 2, 3));
    double held = 0;
    int deletions = 0;
    for (int n = 0; n < 40; ++n) {
        const Matrix s = element.stress();
        held = ((1 + poisson) * s.squaredNorm() - poisson * s.trace() * s.trace()) / (2 * young)
               * volumeOf(element.x);
        Corners next = element.x;
        next.col(0) *= 1.005;
        next.row(2) *= 1.001;
        const double before = element.state.equivalentPlasticStrain;
        element.advance(next, 1e5);
        if (element.step.deletes > 0) {
            ++deletions;
            EXPECT_LE(before, 0.05);
            EXPECT_GT(plasticStrainOf(element.state.equivalentPlasticStrain), 0.05);
            EXPECT_NEAR(element.state.stress.xx, held, 0.02 * held); // the volume is mid-step
            held = element.state.stress.xx;
        }
        if (deletions == 0) {
            EXPECT_LT(element.step.stableTimeStep, 1);
            continue;
        }
        EXPECT_TRUE(isDeleted(element.state.equivalentPlasticStrain));
        EXPECT_EQ(element.force.norm(), 0);
        EXPECT_EQ(element.step.stableTimeStep, 1e30);
        EXPECT_EQ(dot(element.state.hourglass[1], element.state.hourglass[1]), 0);
        if (element.step.deletes > 0) continue;
        EXPECT_EQ(element.step.internal, 0);
        EXPECT_EQ(element.step.hourglass, 0);
        EXPECT_EQ(element.step.bulkViscosity, 0);
        EXPECT_EQ(element.step.plastic, 0);
    }
    EXPECT_EQ(deletions, 1);
    EXPECT_NEAR(plasticStrainOf(element.state.equivalentPlasticStrain), 0.05, 0.006);
    EXPECT_EQ(isDeleted(0), false);
}

TEST(Deletion, ADeletedElementStaysFiniteWhateverBecomesOfItsCorners)
{
    Eroding element(eroding(0.001, false), brick(1, 1, 1));
    Corners next = element.x;
    next.col(0) *= 1.05;
    element.advance(next);
    ASSERT_TRUE(isDeleted(element.state.equivalentPlasticStrain));
    const double held = element.state.stress.xx;
    for (const double scale : {0.0, 1.0, -1.0, 1e200}) {
        element.advance(scale * brick(1, 1, 1));
        EXPECT_EQ(element.force.norm(), 0);
        EXPECT_EQ(element.state.stress.xx, held);
        EXPECT_EQ(element.step.stableTimeStep, 1e30);
        EXPECT_TRUE(std::isfinite(element.state.equivalentPlasticStrain));
    }
}

TEST(Deletion, AnInvertedElementIsDeletedOnlyWhereThePartSaysSo)
{
    for (const bool inverted : {false, true}) {
        Eroding element(eroding(1e30, inverted), brick(1, 1, 1));
        Corners next = element.x;
        next.col(0) *= -1.5; // also the middle of the step is inside out
        element.advance(next);
        EXPECT_EQ(isDeleted(element.state.equivalentPlasticStrain), inverted);
        EXPECT_EQ(element.step.stableTimeStep > 0, inverted);
        if (!inverted) continue;
        EXPECT_EQ(element.force.norm(), 0);
        EXPECT_EQ(element.step.internal, 0);
        EXPECT_EQ(plasticStrainOf(element.state.equivalentPlasticStrain), 0);
    }
}
