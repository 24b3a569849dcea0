#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

using Stiffness = Eigen::Matrix<double, 24, 24>;

/// Stiffness of an unstressed element, column by column from the force of a tiny displacement.
template <class Hourglass>
Stiffness stiffness(const MaterialConstants<double>& m, const Corners& x)
{
    Stiffness k;
    const double h = 1e-7;
    for (int column = 0; column < 24; ++column) {
        Element<Elastic, Hourglass> up(m, x), down(m, x);
        Corners move = Corners::Zero();
        move(column / 3, column % 3) = h;
        up.advance(x + move);
        down.advance(x - move);
        for (int row = 0; row < 24; ++row)
            k(row, column) = (up.force(row / 3, row % 3) - down.force(row / 3, row % 3)) / (2 * h);
    }
    return k;
}

template <class Hourglass>
double stableStep(const MaterialConstants<double>& m, const Corners& x, double mass)
{
    Element<Elastic, Hourglass> element(m, x);
    element.mass = mass;
    element.advance(x);
    return element.step.stableTimeStep;
}

/// Smallest 2 / omega_max over the predicted step on random warped hexahedra, sheared by up to
/// `shear`.
template <class Hourglass>
double leastMargin(double coefficient, double poisson, double shear = 0)
{
    std::mt19937 random(31);
    double least = 1e300;
    for (int i = 0; i < 100; ++i) {
        Corners x = warpedHexahedron(random);
        Matrix lean = Matrix::Identity();
        lean.row(0).tail<2>() << shear * uniform(random), shear * uniform(random);
        lean(1, 2) = shear * uniform(random);
        x = x * lean; // of the same volume
        const double density = 2.5, mass = density * volumeOf(x);
        MaterialConstants<double> m = materialOf(3, poisson);
        m.hourglass = coefficient;
        const Stiffness k = stiffness<Hourglass>(m, x);
        EXPECT_LT((k - k.transpose()).norm(), 1e-6 * k.norm());
        const Eigen::SelfAdjointEigenSolver<Stiffness> modes(k / (mass / 8));
        EXPECT_GT(modes.eigenvalues().minCoeff(), -1e-6 * modes.eigenvalues().maxCoeff());
        const double limit = 2 / std::sqrt(modes.eigenvalues().maxCoeff());
        least = std::min(least, limit / stableStep<Hourglass>(m, x, mass));
    }
    return least;
}

} // namespace

TEST(StableTimeStep, OfABrickIsTheFormulaOfItsEdges)
{
    std::mt19937 random(32);
    for (int i = 0; i < 20; ++i) {
        const double a = uniform(random, 0.1, 3), b = uniform(random, 0.1, 3),
                     c = uniform(random, 0.1, 3), density = 7.85e-9;
        const MaterialConstants<double> m = materialOf(210000, 0.3);
        const double speed = std::sqrt(m.pressureWaveModulus / density);
        const double exact = 1 / (speed * std::sqrt(1 / (a * a) + 1 / (b * b) + 1 / (c * c)));
        const double step = stableStep<StiffnessHourglass>(m, brick(a, b, c), density * a * b * c);
        EXPECT_NEAR(step, exact, 1e-13 * exact);
    }
}

TEST(StableTimeStep, IsSafeForDistortedElementsWithStiffnessHourglass)
{
    for (const double poisson : {0.0, 0.3, 0.45})
        for (const double coefficient : {0.0, 0.05, 0.2})
            EXPECT_GT((leastMargin<StiffnessHourglass>(coefficient, poisson)), 1);
}

// A coefficient of 1 is the limit of bricks only: in warped elements the hourglass shape vectors
// are longer and no longer orthogonal to the strains.
TEST(StableTimeStep, IsMetExactlyByABrickWithTheLargestHourglassStiffness)
{
    const Corners x = brick(1, 0.7, 0.4);
    const double mass = volumeOf(x);
    const MaterialConstants<double> m = materialOf(1, 0.3);
    const Eigen::SelfAdjointEigenSolver<Stiffness> modes(stiffness<StiffnessHourglass>(m, x)
                                                         / (mass / 8));
    const double limit = 2 / std::sqrt(modes.eigenvalues().maxCoeff());
    EXPECT_NEAR(stableStep<StiffnessHourglass>(m, x, mass), limit, 1e-6 * limit);
}

TEST(StableTimeStep, IsSafeForDistortedElementsWithPhysicalHourglass)
{
    for (const double poisson : {0.0, 0.3, 0.45})
        for (const double shear : {0.0, 1.0, 3.0})
            EXPECT_GT((leastMargin<PhysicalHourglass>(1, poisson, shear)), 1);
}

TEST(StableTimeStep, FollowsTheDensityOfTheDeformedElement)
{
    // Half as thick at equal mass and equal modulus: the edges shrink and the waves slow down.
    const MaterialConstants<double> m = materialOf(1, 0.3);
    const double step = stableStep<StiffnessHourglass>(m, brick(1, 1, 0.5), 1.0);
    const double speed = std::sqrt(m.pressureWaveModulus / 2);
    EXPECT_NEAR(step, 1 / (speed * std::sqrt(6.0)), 1e-13);
}

TEST(StableTimeStep, ShrinksWithBulkViscosity)
{
    MaterialConstants<double> m = materialOf(1, 0.3);
    const double free = stableStep<StiffnessHourglass>(m, brick(1, 1, 1), 1);
    m.linearViscosity = 0.06;
    const double damped = stableStep<StiffnessHourglass>(m, brick(1, 1, 1), 1);
    EXPECT_NEAR(damped, free * (std::sqrt(1 + 0.06 * 0.06) - 0.06), 1e-13);
}
