#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

template <class Hourglass>
class HexahedronForce : public testing::Test
{
};

using Forms = testing::Types<StiffnessHourglass, PhysicalHourglass>;
TYPED_TEST_SUITE(HexahedronForce, Forms);

/// A warped element with random stress and random hourglass forces.
template <class Hourglass>
Element<Elastic, Hourglass> randomElement(std::mt19937& random)
{
    Element<Elastic, Hourglass> element(materialOf(1, 0.3), warpedHexahedron(random));
    element.state.stress = symmetric(randomSymmetric(random, 1));
    for (Vec3<double>& q : element.state.hourglass)
        q = {uniform(random), uniform(random), uniform(random)};
    return element;
}

} // namespace

TYPED_TEST(HexahedronForce, AndItsMomentSumToZeroInAnyState)
{
    std::mt19937 random(27);
    for (int i = 0; i < 200; ++i) {
        auto element = randomElement<TypeParam>(random);
        element.material.linearViscosity = 0.06;
        element.material.quadraticViscosity = 1.2;
        element.advance(element.x + randomCorners(random, 0.05), 10);
        const double scale = element.force.cwiseAbs().maxCoeff();
        EXPECT_LT(element.force.colwise().sum().norm(), 1e-12 * scale);
        Vector moment = Vector::Zero();
        for (int k = 0; k < 8; ++k)
            moment += Vector(element.x.row(k)).cross(Vector(element.force.row(k)));
        EXPECT_LT(moment.norm(), 1e-12 * scale);
    }
}

TYPED_TEST(HexahedronForce, IsTheDerivativeOfTheWorkInAnyState)
{
    std::mt19937 random(28);
    const double h = 1e-4;
    for (int i = 0; i < 20; ++i) {
        const auto element = randomElement<TypeParam>(random);
        auto still = element;
        still.advance(element.x);
        for (int k = 0; k < 8; ++k)
            for (int c = 0; c < 3; ++c) {
                auto up = element, down = element;
                Corners move = Corners::Zero();
                move(k, c) = h;
                up.advance(element.x + move);
                down.advance(element.x - move);
                EXPECT_NEAR((up.work - down.work) / (2 * h), still.force(k, c),
                            1e-7 * still.force.norm());
            }
    }
}

TYPED_TEST(HexahedronForce, IsTheDerivativeOfTheElasticEnergy)
{
    std::mt19937 random(29);
    for (int i = 0; i < 20; ++i) {
        const Element<Elastic, TypeParam> start(materialOf(1, 0.3), warpedHexahedron(random));
        const Corners u = randomCorners(random, 1e-6);
        const auto moved = [&](const Corners& displacement) {
            auto element = start;
            element.advance(start.x + displacement);
            return element;
        };
        const auto element = moved(u);
        EXPECT_NEAR(element.work, workOf(element.force, u) / 2, 1e-4 * element.work);
        for (int k = 0; k < 8; ++k)
            for (int c = 0; c < 3; ++c) {
                Corners up = u, down = u;
                up(k, c) += 1e-6;
                down(k, c) -= 1e-6;
                EXPECT_NEAR((moved(up).work - moved(down).work) / 2e-6, element.force(k, c),
                            1e-4 * element.force.norm());
            }
    }
}

TYPED_TEST(HexahedronForce, ElasticEnergyIsTheStoredEnergyOfTheStress)
{
    std::mt19937 random(30);
    const MaterialConstants<double> m = materialOf(1, 0.3);
    const Corners x = warpedHexahedron(random);
    Element<Elastic, TypeParam> element(m, x);
    // Infinitesimal, or the volume would change under way.
    element.advance(x + x * randomSymmetric(random, 1e-7));
    const double p = element.stress().trace() / 3, q = mises(element.stress());
    const double bulk = m.lambda + m.twoMu / 3, mu = m.twoMu / 2;
    const double energy = volumeOf(x) * (p * p / (2 * bulk) + q * q / (6 * mu));
    EXPECT_NEAR(element.step.internal, energy, 1e-6 * energy);
}

TYPED_TEST(HexahedronForce, BulkViscosityResistsAndItsWorkIsBooked)
{
    MaterialConstants<double> m = materialOf(4, 0.3);
    m.linearViscosity = 0.06;
    m.quadraticViscosity = 1.2;
    const Corners x = brick(1, 1, 1);
    for (const double strain : {1e-6, -1e-6}) {
        Element<Elastic, TypeParam> element(m, x);
        const double rate = 1e5, volumetricRate = 3 * strain * rate;
        element.advance((1 + strain) * x, rate);
        // Length: stable step times wave speed, 1/sqrt(3) for a cube; density 1.
        const double length = 1 / std::sqrt(3.0);
        const double squash = std::max(0.0, -volumetricRate) * 1.2 * length;
        const double viscous =
            0.06 * std::sqrt(m.pressureWaveModulus) * length * volumetricRate - squash * squash;
        const double elastic = element.state.stress.xx;
        // Force on a corner of the face +x: (stress + viscous) / 4.
        EXPECT_NEAR(4 * element.force(1, 0), elastic + viscous, 1e-5 * std::abs(viscous));
        EXPECT_NEAR(element.step.bulkViscosity, viscous * 3 * strain,
                    1e-5 * element.step.bulkViscosity);
        EXPECT_GT(element.step.bulkViscosity, 0);
    }
}
