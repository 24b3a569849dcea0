#include "kernels/material/DruckerPrager.h"

#include "kernels/material/J2Plasticity.h"
#include "parallel/Batch.h"
#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace fpm;
using namespace fpm::test;

namespace {

constexpr double young = 5000, poisson = 0.25;

MaterialConstants<double> soil(double cohesion, double friction, double dilation)
{
    MaterialConstants<double> m = materialOf(young, poisson);
    m.rows = 0;
    const double values[] = {cohesion, friction, dilation};
    EXPECT_EQ(DruckerPrager::fault(values).parameter, -1);
    DruckerPrager::constants(values, m);
    return m;
}

PlasticStep<double> returned(const MaterialConstants<double>& m, Sym3<double>& stress)
{
    Sym3<double> unused{};
    return DruckerPrager::update<double>(m, {0, 0, 0, 0}, stress, unused);
}

Matrix elasticStrain(const Matrix& stress)
{
    return (1 + poisson) / young * stress - poisson / young * stress.trace() * Matrix::Identity();
}

/// Axial and lateral strain of a cylinder pressed along x while its sides bear `pressure`.
struct Triaxial {
    MaterialConstants<double> m;
    Sym3<double> stress;
    double plasticStrain = 0;

    Triaxial(const MaterialConstants<double>& material, double pressure)
        : m(material),
          stress{-pressure, -pressure, -pressure, 0, 0, 0}
    {
    }
    /// Returns the lateral strain that leaves the lateral stress as it is.
    double press(double axial)
    {
        const double side = stress.yy;
        const auto pressed = [&](double lateral, double& increment) {
            Sym3<double> s = elasticStress<double>(m, stress, {axial, lateral, lateral, 0, 0, 0});
            increment = returned(m, s).strainIncrement;
            return s;
        };
        double low = -10 * std::abs(axial), high = 10 * std::abs(axial), increment;
        for (int i = 0; i < 200; ++i) {
            const double middle = (low + high) / 2;
            (pressed(middle, increment).yy < side ? low : high) = middle;
        }
        stress = pressed(low, increment);
        plasticStrain += increment;
        return low;
    }
};

} // namespace

// sigma_1 = N sigma_3 + 2 c sqrt(N), N = tan^2(45 deg + phi / 2), which the cone shares in triaxial
// compression; beyond it all strain is plastic: -d + B d / 3 along the axis, d / 2 + B d / 3
// across.
TEST(DruckerPrager, TriaxialCompressionIsThatOfMohrAndCoulomb)
{
    for (const double friction : {0.0, 20.0, 35.0})
        for (const double dilation : {0.0, friction / 2, friction})
            for (const double pressure : {0.0, 5.0}) {
                const double cohesion = 2, phi = friction * std::numbers::pi / 180,
                             psi = dilation * std::numbers::pi / 180;
                Triaxial test(soil(cohesion, friction, dilation), pressure);
                double lateral = 0;
                for (int n = 0; n < 50; ++n) lateral = test.press(-1e-3);
                const double ratio = (1 + std::sin(phi)) / (1 - std::sin(phi));
                EXPECT_NEAR(-test.stress.xx, ratio * pressure + 2 * cohesion * std::sqrt(ratio),
                            1e-9);
                EXPECT_NEAR(test.stress.yy, -pressure, 1e-9);
                const double b = 6 * std::sin(psi) / (3 - std::sin(psi)), d = 1e-3 / (1 - b / 3);
                EXPECT_NEAR(lateral, (0.5 + b / 3) * d, 1e-9);
                EXPECT_GT(test.plasticStrain, 0);
            }
}

// Uniform tension ends at the apex, c cot phi, wherever it starts; the deviator is gone.
TEST(DruckerPrager, TensionEndsAtTheApex)
{
    for (const double dilation : {0.0, 10.0, 30.0}) {
        const MaterialConstants<double> m = soil(2, 30, dilation);
        Sym3<double> stress{1, -2, 1, 0.5, 0, 0.3};
        for (int n = 0; n < 20; ++n) {
            stress = elasticStress<double>(m, stress, {1e-3, 1e-3, 1e-3, 0, 0, 0});
            const PlasticStep<double> step = returned(m, stress);
            EXPECT_GE(step.work, 0);
        }
        const double apex = 2 / std::tan(std::numbers::pi / 6);
        for (const double s : {stress.xx, stress.yy, stress.zz}) EXPECT_NEAR(s, apex, 1e-9);
        for (const double s : {stress.xy, stress.yz, stress.zx}) EXPECT_NEAR(s, 0, 1e-9);
        // Without shear at all no plastic strain of the deviator is counted.
        Sym3<double> even{10, 10, 10, 0, 0, 0};
        EXPECT_LT(returned(m, even).strainIncrement, 1e-12);
        EXPECT_NEAR(even.xx, apex, 1e-9);
    }
}

TEST(DruckerPrager, WithoutCohesionTheApexIsTheStressFreeState)
{
    const MaterialConstants<double> m = soil(0, 30, 0);
    Sym3<double> rest{0, 0, 0, 0, 0, 0}, pulled{3, 2, 1, 0.1, 0.2, 0.3};
    EXPECT_LT(returned(m, rest).strainIncrement, 1e-12);
    EXPECT_EQ(matrixOf(rest).norm(), 0);
    returned(m, pulled);
    EXPECT_LT(matrixOf(pulled).norm(), 1e-12);
}

TEST(DruckerPrager, WithoutFrictionItIsMisesPlasticity)
{
    std::mt19937 random(3);
    const MaterialConstants<double> m = soil(100, 0, 0), j2 = materialOf(young, poisson, 200);
    for (int i = 0; i < 200; ++i) {
        Sym3<double> a = symmetric(randomSymmetric(random, 300)), b = a;
        const double bending = uniform(random, 0, 100);
        Sym3<double> unused{};
        const auto ours = DruckerPrager::update<double>(m, {0, bending, 0, 0}, a, unused);
        const auto mises = radialReturn<double>(j2, 0, bending, b);
        EXPECT_NEAR(ours.strainIncrement, mises.strainIncrement, 1e-14);
        EXPECT_NEAR(ours.work, mises.work, 1e-12);
        EXPECT_LT((matrixOf(a) - matrixOf(b)).norm(), 1e-10);
    }
}

// Associated flow returns to the admissible stress that is nearest in elastic energy: no other lies
// on the far side of it. Tells the cone and the apex apart without knowing either formula.
TEST(DruckerPrager, AssociatedFlowReturnsToTheNearestStress)
{
    std::mt19937 random(4);
    const MaterialConstants<double> m = soil(2, 30, 30);
    const double a = 6 * 0.5 / 2.5, y = 6 * 2 * std::cos(std::numbers::pi / 6) / 2.5;
    int cone = 0, apex = 0;
    for (int i = 0; i < 300; ++i) {
        const Matrix trial =
            randomSymmetric(random, 8) + uniform(random, -8, 20) * Matrix::Identity();
        Sym3<double> s = symmetric(trial);
        const PlasticStep<double> step = returned(m, s);
        const Matrix stress = matrixOf(s), flow = elasticStrain(trial - stress);
        EXPECT_NEAR(step.work, stress.cwiseProduct(flow).sum(), 1e-12);
        EXPECT_LT(mises(stress) + a * stress.trace() / 3, y + 1e-9);
        if (step.reduction == 0) {
            EXPECT_EQ(stress, trial);
            continue;
        }
        (step.reduction < 1 ? cone : apex)++;
        for (int k = 0; k < 100; ++k) {
            Matrix other = randomSymmetric(random, 8) - uniform(random, 0, 20) * Matrix::Identity();
            if (k == 0) other = y / a * Matrix::Identity();
            if (mises(other) + a * other.trace() / 3 > y + 1e-12) continue;
            EXPECT_LE((other - stress).cwiseProduct(flow).sum(), 1e-10);
        }
    }
    EXPECT_GT(cone, 50);
    EXPECT_GT(apex, 20);
}

TEST(DruckerPrager, BatchesEqualScalarCodeToTheLastBit)
{
    std::mt19937 random(5);
    const MaterialConstants<double> m = soil(2, 30, 10);
    using Four = Batch<double, 4>;
    for (int i = 0; i < 200; ++i) {
        Sym3<double> one[4];
        double values[6][4], increments[4];
        for (int lane = 0; lane < 4; ++lane) {
            one[lane] = symmetric(
                Matrix(randomSymmetric(random, 6) + uniform(random, -6, 6) * Matrix::Identity()));
            const Sym3<double>& s = one[lane];
            const double all[] = {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
            for (int k = 0; k < 6; ++k) values[k][lane] = all[k];
            increments[lane] = returned(m, one[lane]).strainIncrement;
        }
        const auto lanes = [](const double* v) { return NumberTraits<Four>::read(v); };
        Sym3<Four> s{lanes(values[0]), lanes(values[1]), lanes(values[2]),
                     lanes(values[3]), lanes(values[4]), lanes(values[5])};
        Sym3<Four> unused{};
        const Four zero(0.0);
        const auto step = DruckerPrager::update<Four>(m, {zero, zero, zero, 0.0}, s, unused);
        double out[4], plastic[4];
        NumberTraits<Four>::store(out, s.xx);
        NumberTraits<Four>::store(plastic, step.strainIncrement);
        for (int lane = 0; lane < 4; ++lane) {
            EXPECT_EQ(out[lane], one[lane].xx);
            EXPECT_EQ(plastic[lane], increments[lane]);
        }
    }
}

TEST(DruckerPrager, RefusesNumbersThatMakeNoSenseTogether)
{
    const double loose[] = {0, 0, 0}, wild[] = {1, 20, 30};
    EXPECT_EQ(DruckerPrager::fault(loose).parameter, 0);
    EXPECT_EQ(DruckerPrager::fault(wild).parameter, 2);
}

namespace {

using Block = Element<DruckerPrager, PhysicalHourglass>;

/// A block whose ends turn against each other, by `turn` of the width at an edge.
Corners bentBlock(double turn)
{
    Corners x = brick(2, 2, 2);
    for (int k = 0; k < 8; ++k) x(k, 0) += turn * x(k, 0) * x(k, 2);
    return x;
}

Block block(double dilation, double pressure)
{
    MaterialConstants<double> m = soil(2, 30, dilation);
    m.coupledHourglass = 1;
    Block element(m, bentBlock(0));
    element.state.stress = {-pressure, -pressure, -pressure, 0, 0, 0};
    element.mass = 1e-8;
    return element;
}

double bendingOf(const Block& block)
{
    const Corners shape = block.x.rowwise() - block.x.row(0);
    return PhysicalHourglass::present(block.material, modesOf<double>(shape), block.state.hourglass)
        .bending;
}

} // namespace

// The plastic moment is that of the yield stress in the middle of the section.
TEST(DruckerPrager, BendingYieldsWithTheSection)
{
    for (const double pressure : {0.0, 5.0}) {
        Block element = block(0, pressure);
        for (int n = 1; n <= 400; ++n) element.advance(bentBlock(1e-4 * n));
        const double y = 6 * 2 * std::cos(std::numbers::pi / 6) / 2.5, a = 6 * 0.5 / 2.5;
        const double mean = element.stress().trace() / 3;
        const double q = sectionStress(mises(element.stress()), bendingOf(element));
        EXPECT_NEAR(q, y - a * mean, 1e-9);
        EXPECT_NEAR(bendingOf(element), y - a * mean, 0.05 * y);
        EXPECT_GT(element.step.plastic, 0);
    }
}

// Where the deviator has nothing to resist with, bending meets a viscous resistance and is gone
// soon.
TEST(DruckerPrager, BendingFadesAtTheApex)
{
    for (const double dilation : {0.0, 30.0}) {
        Block element = block(dilation, 0);
        element.advance(bentBlock(1e-4));
        double before = bendingOf(element);
        for (int n = 1; n <= 60; ++n) {
            element.advance(bentBlock(1e-4) * (1 + 1e-3 * n));
            const double now = bendingOf(element);
            EXPECT_LT(now, before);
            if (n > 5) {
                EXPECT_NEAR(now, 0.9 * before, 0.02 * before);
            }
            before = now;
        }
        EXPECT_LT(before, 0.01);
    }
}
