#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace fpm;
using namespace fpm::test;

namespace {

constexpr double s1 = 2, s2 = 1.5, s3 = 0.5, young = 70000, poisson = 0.3, yieldStrain = 1e-4;

/// Corner displacements of a brick bent to the curvatures along x and y, thickness along z.
Corners bent(const Corners& x, double curvatureX, double curvatureY)
{
    Corners u = Corners::Zero();
    u.col(0) = curvatureX * x.col(0).cwiseProduct(x.col(2));
    u.col(1) = curvatureY * x.col(1).cwiseProduct(x.col(2));
    return u;
}

/// Corner displacements u_1 = a_1 eta zeta and so on round.
Corners twist(const Vector& a)
{
    Corners u;
    for (int i = 0; i < 8; ++i) {
        const double* s = cornerSign[i];
        u.row(i) << a[0] * s[1] * s[2], a[1] * s[2] * s[0], a[2] * s[0] * s[1];
    }
    return u;
}

/// Bending moments of the corner forces on the faces +x and +y about the middle surface.
Eigen::Vector2d moments(const Corners& x, const Corners& force)
{
    Eigen::Vector2d sum(0, 0);
    for (int i = 0; i < 8; ++i) {
        if (cornerSign[i][0] > 0) sum[0] += force(i, 0) * x(i, 2);
        if (cornerSign[i][1] > 0) sum[1] += force(i, 1) * x(i, 2);
    }
    return sum;
}

MaterialConstants<double> coupled(double yieldStress, double modulus)
{
    MaterialConstants<double> m = materialOf(young, poisson, yieldStress, modulus);
    m.coupledHourglass = 1;
    return m;
}

using Bent = Element<J2Plasticity, PhysicalHourglass>;

/// Least running sum and total of the work over a closed path in the space of corner displacements,
/// and what flowed on the way.
struct Cycle {
    double least = 0, total = 0, plasticStrain = 0;
};

Cycle randomCycle(std::mt19937& random, const Corners& x, double size, int steps, bool onlyBending)
{
    Bent element(coupled(yieldStrain * young, 1e-6), x);
    Corners amplitude[3];
    for (Corners& a : amplitude) {
        a = randomCorners(random, size);
        if (onlyBending) {
            Modes<double> modes = modesOf(a);
            for (int k = 0; k < 4; ++k) modes.mode[k] = {0, 0, 0};
            a = cornersOf(modes) / 8;
        }
    }
    Cycle cycle;
    for (int n = 1; n <= steps; ++n) {
        const double t = 2 * std::numbers::pi * n / steps;
        element.advance(x + std::sin(t) * amplitude[0] + std::sin(2 * t) * amplitude[1]
                        + (1 - std::cos(t)) * amplitude[2]);
        cycle.least = std::min(cycle.least, element.work);
    }
    cycle.total = element.work;
    cycle.plasticStrain = element.state.equivalentPlasticStrain;
    return cycle;
}

} // namespace

TEST(PhysicalHourglass, BendsABrickAsPlateTheoryDoes)
{
    const Corners x = brick(s1, s2, s3);
    const double curvature = 1e-8, plate = young / (1 - poisson * poisson) * s3 * s3 * s3 / 12;
    for (const double y : {0.0, 0.5, -poisson}) {
        Element<Elastic, PhysicalHourglass> element(materialOf(young, poisson), x);
        element.advance(x + bent(x, curvature, y * curvature));
        const Eigen::Vector2d moment = moments(x, element.force);
        const double scale = plate * curvature;
        EXPECT_NEAR(moment[0], s2 * scale * (1 + poisson * y), 1e-6 * scale);
        EXPECT_NEAR(moment[1], s1 * scale * (y + poisson), 1e-6 * scale);
    }
}

TEST(PhysicalHourglass, BendsABarWithTheModulusOfYoung)
{
    const Corners x = brick(s1, s2, s3);
    const double curvature = 1e-8;
    Element<Elastic, PhysicalHourglass> element(materialOf(young, poisson), x);
    element.advance(x + bent(x, curvature, -poisson * curvature));
    const double exact = young * s2 * s3 * s3 * s3 / 12 * curvature;
    EXPECT_NEAR(moments(x, element.force)[0], exact, 1e-7 * exact);
    EXPECT_NEAR(element.step.internal, exact * curvature * s1 / 2, 1e-7 * exact * curvature * s1);
    EXPECT_NEAR(element.step.hourglass, 0, 1e-12 * exact * curvature * s1);
}

TEST(PhysicalHourglass, BendingStiffnessDoesNotDependOnTheDirection)
{
    // The same bar with its length along each axis in turn and its thickness along another.
    const double size[3] = {s1, s2, s3};
    for (int along = 0; along < 3; ++along)
        for (int across = 0; across < 3; ++across) {
            if (along == across) continue;
            const int third = 3 - along - across;
            double s[3];
            s[along] = size[0];
            s[third] = size[1];
            s[across] = size[2];
            const Corners x = brick(s[0], s[1], s[2]);
            const double curvature = 1e-8;
            Corners u = Corners::Zero();
            u.col(along) = curvature * x.col(along).cwiseProduct(x.col(across));
            u.col(third) = -poisson * curvature * x.col(third).cwiseProduct(x.col(across));
            Element<Elastic, PhysicalHourglass> element(materialOf(young, poisson), x);
            element.advance(x + u);
            double moment = 0;
            for (int i = 0; i < 8; ++i)
                if (cornerSign[i][along] > 0) moment += element.force(i, along) * x(i, across);
            const double exact = young * s2 * s3 * s3 * s3 / 12 * curvature;
            EXPECT_NEAR(moment, exact, 1e-6 * exact);
        }
}

TEST(PhysicalHourglass, BendsALeaningBrickAsBeamTheoryDoes)
{
    // u_x = k x z, u_z = -k x^2 / 2: strain k z alone, whatever the side faces lean by. The middle
    // surface does not lean: it is the thickness that beam theory knows.
    const double curvature = 1e-8,
                 energy = young * curvature * curvature * s3 * s3 / 24 * s1 * s2 * s3;
    for (const double lean : {0.0, 0.5, -1.0, 2.0}) {
        Corners x = brick(s1, s2, s3);
        x.col(0) += lean * x.col(2);
        Corners u = bent(x, curvature, 0);
        u.col(2) -= curvature / 2 * x.col(0).cwiseProduct(x.col(0));
        Element<Elastic, PhysicalHourglass> element(materialOf(young, 0), x);
        element.advance(x + u);
        EXPECT_NEAR(element.step.internal, energy, 1e-6 * energy) << lean;
    }
}

TEST(PhysicalHourglass, TwistHasTheEnergyOfItsShearStrains)
{
    // u_i = a_i (product of the other two natural coordinates): the shear strains of the trilinear
    // field are linear, gamma_12 = 2 zeta (a_1 / s_2 + a_2 / s_1), and mean zeta^2 = 1/3.
    const Corners x = brick(s1, s2, s3);
    const MaterialConstants<double> m = materialOf(young, poisson);
    std::mt19937 random(46);
    for (int n = 0; n < 20; ++n) {
        const Vector a = 1e-8 * randomAxis(random);
        Element<Elastic, PhysicalHourglass> element(m, x);
        element.advance(x + twist(a));
        const double g12 = a[0] / s2 + a[1] / s1, g23 = a[1] / s3 + a[2] / s2,
                     g31 = a[2] / s1 + a[0] / s3;
        const double energy =
            m.twoMu / 2 * s1 * s2 * s3 * 2 / 3 * (g12 * g12 + g23 * g23 + g31 * g31);
        EXPECT_NEAR(element.step.internal, energy, 1e-6 * energy);
    }
}

TEST(PhysicalHourglass, TheLastModeHasTheEnergyOfItsAxialStrains)
{
    // u_i = a_i xi eta zeta: axial strains 2 a_1 eta zeta / s_1, bar by bar with Young's modulus.
    const Corners x = brick(s1, s2, s3);
    std::mt19937 random(47);
    const Vector a = 1e-8 * randomAxis(random);
    Corners u;
    for (int i = 0; i < 8; ++i)
        u.row(i) = cornerSign[i][0] * cornerSign[i][1] * cornerSign[i][2] * a.transpose();
    Element<Elastic, PhysicalHourglass> element(materialOf(young, poisson), x);
    element.advance(x + u);
    const Vector strain(a[0] / s1, a[1] / s2, a[2] / s3);
    const double energy = young * s1 * s2 * s3 * 2 / 9 * strain.squaredNorm();
    EXPECT_NEAR(element.step.hourglass, energy, 1e-6 * energy);
}

TEST(PhysicalHourglass, PureTwistTendsToThePlasticTwistingMoment)
{
    // A plate element twisted without transverse shear: a_2 = a_1 s_1 / s_2, a_3 = -a_1 s_1 / s_3;
    // shear strain 4 zeta a_1 / s_2. Plastic: shear yield stress times t^2 / 4 a width.
    const Corners x = brick(s1, s2, s3);
    const double yieldStress = 2.85, shearYield = yieldStress / std::sqrt(3.0);
    Bent element(coupled(yieldStress, 1e-6), x);
    const double atYield = shearYield / (element.material.twoMu / 2) * s2 / 4;
    const int steps = 200;
    for (int n = 1; n <= steps; ++n) {
        const double a = 5 * atYield * n / steps;
        element.advance(x + twist(Vector(a, a * s1 / s2, -a * s1 / s3)));
    }
    double moment = 0; // about the undeformed middle surface
    for (int i = 0; i < 8; ++i)
        if (cornerSign[i][0] > 0) moment += element.force(i, 1) * x(i, 2);
    const double plastic = shearYield * s3 * s3 / 4 * s2;
    EXPECT_NEAR(moment, plastic, 0.01 * plastic);
}

TEST(PhysicalHourglass, PureBendingTendsToThePlasticMoment)
{
    const Corners x = brick(s1, s2, s3);
    const double yieldStress = 285, plasticMoment = yieldStress * s3 * s3 / 4 * s2;
    // Curvature at first yield of the outer fibre.
    const double atYield = 2 * yieldStress / (young * s3);
    Bent element(coupled(yieldStress, 1e-6), x);
    const int steps = 200;
    for (int n = 1; n <= steps; ++n) {
        const double curvature = 5 * atYield * n / steps;
        element.advance(x + bent(x, curvature, -poisson * curvature));
    }
    EXPECT_NEAR(moments(x, element.force)[0], plasticMoment, 0.01 * plasticMoment);
    EXPECT_NEAR(moments(x, element.force)[1], 0, 0.01 * plasticMoment);
}

TEST(PhysicalHourglass, LayersOfASectionTendToItsPlasticMoment)
{
    // n elements through the thickness share it: sigma_y t^2 / 4 a width, whatever n is. Stretched
    // without change of volume, each in uniaxial stress but for a pressure that plays no part.
    const double yieldStress = 2.85, steady = 0.499;
    const double atYield = 2 * yieldStress / (young * s3), plastic = yieldStress * s3 * s3 / 4 * s2;
    MaterialConstants<double> m = materialOf(young, steady, yieldStress, 1e-6);
    m.coupledHourglass = 1;
    for (const int layers : {1, 2, 3, 4, 7}) {
        const Corners x = brick(s1, s2, s3 / layers);
        double moment = 0;
        for (int layer = 0; layer < layers; ++layer) {
            const double z = s3 * ((layer + 0.5) / layers - 0.5);
            Bent element(m, x);
            const int steps = 2000;
            for (int n = 1; n <= steps; ++n) {
                const double curvature = 20 * atYield * n / steps;
                Corners u = bent(x, curvature, -steady * curvature);
                u += x * Vector(1, -0.5, -0.5).asDiagonal() * (curvature * z);
                element.advance(x + u);
            }
            const Matrix stress = element.stress();
            moment +=
                (stress(0, 0) - stress(1, 1)) * s2 * s3 / layers * z + moments(x, element.force)[0];
        }
        EXPECT_NEAR(moment, plastic, 0.01 * plastic) << layers << " layers";
    }
}

TEST(PhysicalHourglass, WorkOfYieldingBendingIsStoredOrDissipated)
{
    const Corners x = brick(s1, s2, s3);
    const double yieldStress = 2.85, atYield = 2 * yieldStress / (young * s3);
    Bent element(coupled(yieldStress, 1e-6), x);
    double dissipated = 0;
    const int steps = 1000;
    for (int n = 1; n <= steps; ++n) {
        const double curvature = 5 * atYield * n / steps;
        element.advance(x + bent(x, curvature, -poisson * curvature));
        dissipated += element.step.plastic;
    }
    const double moment = yieldStress * s3 * s3 / 4 * s2,
                 stored = moment * moment / (2 * young * s2 * s3 * s3 * s3 / 12) * s1;
    EXPECT_GT(dissipated, 4 * stored);
    EXPECT_NEAR(element.work, stored + dissipated, 0.001 * element.work);
}

TEST(PhysicalHourglass, WithoutCouplingBendingStaysElastic)
{
    const Corners x = brick(s1, s2, s3);
    const double yieldStress = 285, curvature = 5 * 2 * yieldStress / (young * s3);
    Bent element(materialOf(young, poisson, yieldStress, 1e-6), x);
    element.advance(x + bent(x, curvature, -poisson * curvature));
    const double elastic = young * s2 * s3 * s3 * s3 / 12 * curvature;
    EXPECT_NEAR(moments(x, element.force)[0], elastic, 0.01 * elastic);
}

TEST(PhysicalHourglass, StretchAndBendingShareOneYieldSurface)
{
    // (N / N_p)^2 + M / M_p = 1, the limit surface of a solid rectangular section.
    const Corners x = brick(s1, s2, s3);
    const double yieldStress = 285;
    Bent element(coupled(yieldStress, 1e-6), x);
    const int steps = 200;
    for (int n = 1; n <= steps; ++n) {
        const double strain = 3 * yieldStress / young * n / steps,
                     curvature = 6 * yieldStress / (young * s3) * n / steps;
        Corners next = x + bent(x, curvature, -poisson * curvature);
        next.col(0) += strain * x.col(0);
        next.rightCols<2>() -= poisson * strain * x.rightCols<2>();
        element.advance(next);
    }
    const double bending = moments(x, element.force)[0] / (yieldStress * s3 * s3 / 4 * s2);
    const double stretch = mises(element.stress()) / yieldStress;
    EXPECT_GT(bending, 0.2);
    EXPECT_GT(stretch, 0.2);
    EXPECT_NEAR(stretch * stretch + bending, 1, 0.01);
}

TEST(PhysicalHourglass, ClosedPathsOfAYieldingSectionNeverCreateEnergy)
{
    std::mt19937 random(26);
    for (int i = 0; i < 200; ++i) {
        const Corners x =
            brick(uniform(random, 0.3, 2), uniform(random, 0.3, 2), uniform(random, 0.3, 2));
        // From first yield to twenty times beyond it, smoothly and in a few coarse jumps.
        const double size = 1e-4 * std::pow(10, uniform(random, 0.2, 1.3));
        const double scale = yieldStrain * yieldStrain * young * volumeOf(x);
        for (const int steps : {12, 400})
            for (const bool onlyBending : {true, false}) {
                const Cycle cycle = randomCycle(random, x, size, steps, onlyBending);
                EXPECT_GT(cycle.plasticStrain, 0);
                EXPECT_GE(cycle.least, -1e-12 * scale);
                EXPECT_GT(cycle.total, 0);
            }
    }
}

TEST(PhysicalHourglass, ClosedElasticPathsReturnTheirEnergy)
{
    std::mt19937 random(44);
    for (int i = 0; i < 50; ++i) {
        const Corners x = brick(1, 2, 0.5);
        const double scale = yieldStrain * yieldStrain * young * volumeOf(x);
        const Cycle cycle = randomCycle(random, x, 5e-6, 400, false);
        EXPECT_EQ(cycle.plasticStrain, 0);
        // A rate form of elasticity closes to third order in the strain only.
        EXPECT_LT(std::abs(cycle.total), yieldStrain * scale);
    }
}
