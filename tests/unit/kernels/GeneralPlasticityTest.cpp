#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

constexpr double young = 70000, poisson = 0.3, yieldStress = 285;

/// A material with a straight line of isotropic hardening and a backstress.
MaterialConstants<double> mixed(double isotropic, double kinematic)
{
    MaterialConstants<double> m = materialOf(young, poisson, yieldStress, isotropic);
    m.general.kinematicModulus = kinematic;
    return m;
}

MaterialConstants<double> cowperSymonds(double d, double p, double modulus = 0)
{
    MaterialConstants<double> m = materialOf(young, poisson, yieldStress, modulus);
    m.general.rateLaw = RateLaw::cowperSymonds;
    m.general.referenceRate = d;
    m.general.rateCoefficient = 1 / p;
    return m;
}

/// OFHC copper (Johnson and Cook 1983), MPa, s, K.
MaterialConstants<double> copper()
{
    MaterialConstants<double> m = materialOf(124000, 0.34, 90, 0);
    m.general.powerModulus = 292;
    m.general.powerExponent = 0.31;
    m.general.rateLaw = RateLaw::logarithmic;
    m.general.referenceRate = 1;
    m.general.rateCoefficient = 0.025;
    m.general.softeningExponent = 1.09;
    m.general.roomTemperature = 293;
    m.general.temperature = 293;
    m.general.inverseMeltingRange = 1.0 / (1356 - 293);
    return m;
}

struct MaterialPoint {
    Sym3<double> stress{}, backstress{};
    double plasticStrain = 0, work = 0, increment = 0, rise = 0;

    void strain(const MaterialConstants<double>& m, const Matrix& strain, double rate = 0)
    {
        stress = elasticStress<double>(m, stress, symmetric(strain));
        const PlasticStep<double> step =
            generalReturn<double>(m, {plasticStrain, 0.0, rise, rate}, stress, backstress);
        increment = step.strainIncrement;
        plasticStrain += increment;
        work += step.work;
    }
    /// Uniaxial strain in `steps` equal steps.
    void pull(const MaterialConstants<double>& m, double strain1, int steps, double rate = 0)
    {
        Matrix e = Matrix::Zero();
        e(0, 0) = strain1 / steps;
        for (int n = 0; n < steps; ++n) strain(m, e, rate);
    }
    double shear() const { return stress.xx - stress.yy; } ///< signed Mises stress of such a path
};

/// Slow yield stress of a law, written for itself.
long double slowYield(const MaterialConstants<double>& m, long double e)
{
    int row = m.rows - 1;
    while (row > 0 && e < m.strain[row]) --row;
    return m.stress[row] + m.slope[row] * (e - m.strain[row])
           + m.general.powerModulus
                 * std::pow(e, static_cast<long double>(m.general.powerExponent));
}

long double yieldOf(const MaterialConstants<double>& m, long double e, long double rate)
{
    const GeneralConstants<double>& g = m.general;
    const long double ratio = rate / g.referenceRate;
    const long double factor =
        g.rateLaw == RateLaw::cowperSymonds
            ? 1 + std::pow(ratio, static_cast<long double>(g.rateCoefficient))
        : g.rateLaw == RateLaw::logarithmic
            ? 1 + g.rateCoefficient * std::log(std::max(ratio, 1.0L))
            : 1.0L;
    return slowYield(m, e) * factor;
}

/// Plastic strain increment by bisection.
double bisected(const MaterialConstants<double>& m, double e, double trial, double rate)
{
    const long double stiffness = m.threeMu + m.general.kinematicModulus;
    long double low = 0, high = trial / stiffness;
    for (int i = 0; i < 100; ++i) {
        const long double d = (low + high) / 2;
        (trial - stiffness * d > yieldOf(m, e + d, d * rate) ? low : high) = d;
    }
    return double(low);
}

} // namespace

// Benchmark A4, uniaxial strain: load to 0.02, back to 0. Isotropic, kinematic and both; the
// numbers follow from q = 2 G (e - 1.5 ep) = sigma_y + H ep and the reverse yield at a drop of 2
// (sigma_y + H_i ep) in q.
TEST(GeneralPlasticity, UniaxialStrainLoadsUnloadsAndYieldsAgainAsComputedByHand)
{
    const double g = young / (2 * (1 + poisson)), k = young / (3 * (1 - 2 * poisson));
    const double modulus = 900;
    for (const double share : {0.0, 0.4, 1.0}) {
        const MaterialConstants<double> m = mixed((1 - share) * modulus, share * modulus);
        MaterialPoint point;
        point.pull(m, 0.02, 40);
        const double forward = (2 * g * 0.02 - yieldStress) / (3 * g + modulus);
        const double q = yieldStress + modulus * forward;
        EXPECT_NEAR(point.plasticStrain, forward, 1e-12);
        EXPECT_NEAR(point.stress.xx, k * 0.02 + 2 * q / 3, 1e-9);
        if (share == 0) { // the benchmark's own digits
            EXPECT_NEAR(point.stress.xx, 1362.48, 0.01);
            EXPECT_NEAR(point.stress.yy, 1068.76, 0.01);
            EXPECT_NEAR(point.plasticStrain, 0.0096967, 1e-7);
        }
        const double drop = 2 * (yieldStress + (1 - share) * modulus * forward) / (2 * g);
        EXPECT_NEAR(drop, share == 0 ? 0.0109099 : drop, 1e-7);
        point.pull(m, -drop * (1 - 1e-9), 1);
        EXPECT_EQ(point.increment, 0);
        point.pull(m, -(0.02 - drop * (1 - 1e-9)), 20);
        const double back = 2 * g * (0.02 - drop) / (3 * g + modulus);
        EXPECT_NEAR(point.plasticStrain, forward + back, 1e-10);
        const double left = q - 2 * g * drop - modulus * back;
        EXPECT_NEAR(point.shear(), left, 1e-7);
        if (share == 0) {
            EXPECT_NEAR(point.stress.xx, -199.41, 0.01);
            EXPECT_NEAR(point.plasticStrain, 0.0156900, 1e-7);
        }
    }
}

// One step and a thousand give the same: each linear piece is exact.
TEST(GeneralPlasticity, OneStepEqualsManyWithTableAndBackstress)
{
    MaterialConstants<double> m = mixed(0, 700);
    const double strain[3] = {0, 0.01, 0.05}, stress[3] = {285, 320, 350};
    m.rows = 3;
    for (int i = 0; i < 3; ++i) {
        m.strain[i] = strain[i];
        m.stress[i] = stress[i];
        m.slope[i] = i == 0 ? 3500 : 750;
    }
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const Matrix total = randomSymmetric(random, 0.2);
        MaterialPoint once, often;
        once.strain(m, total);
        for (int n = 0; n < 1000; ++n) often.strain(m, total / 1000);
        EXPECT_GT(once.plasticStrain, 0.05);
        EXPECT_NEAR(once.plasticStrain, often.plasticStrain, 1e-10);
        EXPECT_LT((matrixOf(once.stress) - matrixOf(often.stress)).norm(), 1e-8);
        EXPECT_LT((matrixOf(once.backstress) - matrixOf(often.backstress)).norm(), 1e-8);
    }
}

TEST(GeneralPlasticity, TheBackstressIsTwoThirdsOfTheModulusTimesThePlasticStrain)
{
    const MaterialConstants<double> m = mixed(100, 800);
    std::mt19937 random(4);
    MaterialPoint point;
    Matrix elastic = Matrix::Zero(), total = Matrix::Zero();
    for (int n = 0; n < 200; ++n) {
        const Matrix e = randomSymmetric(random, 0.02);
        point.strain(m, e);
        total += e;
    }
    const Matrix stress = matrixOf(point.stress);
    elastic = ((1 + poisson) * stress - poisson * stress.trace() * Matrix::Identity()) / young;
    const Matrix plastic = total - elastic;
    EXPECT_LT(std::abs(plastic.trace()), 1e-12);
    EXPECT_LT((matrixOf(point.backstress) - 2.0 / 3 * 800 * plastic).norm(), 1e-9);
    const double q = mises(stress - matrixOf(point.backstress));
    EXPECT_LE(q, (yieldStress + 100 * point.plasticStrain) * (1 + 1e-12));
}

TEST(GeneralPlasticity, PureShearYieldsAtTheYieldStressOverRootThreeUnderEveryLaw)
{
    for (const MaterialConstants<double>& m : {mixed(0, 900), cowperSymonds(40, 5), copper()}) {
        const double atYield = m.stress[0] / std::sqrt(3.0);
        const auto sheared = [&](double stress) {
            Matrix strain = Matrix::Zero();
            strain(0, 1) = strain(1, 0) = stress / m.twoMu;
            MaterialPoint point;
            point.strain(m, strain, 1e6);
            return point;
        };
        EXPECT_EQ(sheared(atYield * (1 - 1e-12)).plasticStrain, 0);
        EXPECT_GT(sheared(atYield * (1 + 1e-6)).plasticStrain, 0);
        EXPECT_EQ(sheared(3 * atYield).stress.xx, 0);
    }
}

// Constant plastic rate: with no hardening the stress stands still, and then all of the strain rate
// is plastic: r = 2/3 of the axial one.
TEST(GeneralPlasticity, CowperSymondsAtConstantRate)
{
    const double rate = 1e6, strainRate = 300;
    for (const double p : {1.0, 5.0, 20.0}) {
        const MaterialConstants<double> m = cowperSymonds(40, p);
        MaterialPoint point;
        point.pull(m, 6000 * strainRate / rate, 6000, rate);
        const double plasticRate = 2.0 / 3 * strainRate;
        EXPECT_NEAR(point.increment * rate, plasticRate, 1e-6 * plasticRate);
        const double expected = yieldStress * (1 + std::pow(plasticRate / 40, 1 / p));
        EXPECT_NEAR(point.shear(), expected, 1e-6 * expected);
    }
}

// Johnson and Cook at an elastic-plastic rate that is found by a Runge-Kutta solution of its own:
// 2 G (de - 1.5 dep) = dq with q = (A + B ep^n) (1 + C ln(dep / rate0)) solved for dep.
TEST(GeneralPlasticity, JohnsonCookAtConstantStrainRate)
{
    const MaterialConstants<double> m = copper();
    const double rate = 1e7, strainRate = 1000;
    MaterialPoint point;
    int steps = 0;
    for (const double end : {0.02, 0.1, 0.3}) {
        for (; steps < int(end / strainRate * rate + 0.5); ++steps)
            point.pull(m, strainRate / rate, 1, rate);
        const double plasticRate = point.increment * rate;
        const double expected = double(yieldOf(m, point.plasticStrain, plasticRate));
        EXPECT_NEAR(point.shear(), expected, 1e-10 * expected);
        // Nearly all of the rate is plastic: dq = 2 G (2/3 strainRate - r) 1.5.
        const double e = point.plasticStrain;
        const double slope =
            292 * 0.31 * std::pow(e, 0.31 - 1) * (1 + 0.025 * std::log(plasticRate));
        const double closed = strainRate * m.twoMu / (m.threeMu + slope);
        EXPECT_NEAR(plasticRate, closed, 1e-3 * closed);
        EXPECT_NEAR(point.shear(), double(yieldOf(m, e, closed)), 1e-6 * 2 * expected);
    }
}

TEST(GeneralPlasticity, AStepChangeOfRateIsFollowedAtOnceAndWithoutOvershoot)
{
    const MaterialConstants<double> m = cowperSymonds(40, 5);
    const double rate = 1e7;
    MaterialPoint point;
    point.pull(m, 8000 * 30 / rate, 8000, rate);
    const auto steady = [&](double strainRate) {
        return yieldStress * (1 + std::pow(2.0 / 3 * strainRate / 40, 0.2));
    };
    EXPECT_NEAR(point.shear(), steady(30), 1e-6 * steady(30));
    double before = point.shear();
    for (int n = 0; n < 4000; ++n) { // a hundredfold rate: the stress climbs to the new one
        point.pull(m, 3000 / rate, 1, rate);
        EXPECT_GE(point.shear(), before * (1 - 1e-13));
        EXPECT_LE(point.shear(), steady(3000) * (1 + 1e-12));
        before = point.shear();
    }
    EXPECT_NEAR(point.shear(), steady(3000), 1e-6 * steady(3000));
    for (int n = 0; n < 4000; ++n) { // and back down
        point.pull(m, 30 / rate, 1, rate);
        EXPECT_LE(point.shear(), before * (1 + 1e-13));
        EXPECT_GE(point.shear(), steady(30) * (1 - 1e-12));
        before = point.shear();
    }
    // Where the step of time doubles, the rate and not the increment counts.
    point.pull(m, 30 / (rate / 2), 1, rate / 2);
    EXPECT_NEAR(point.shear(), before, 1e-6 * before);
}

// Ten iterations of Newton's method against a hundred bisections, over the range of sensible
// laws.
TEST(GeneralPlasticity, TheReturnConvergesForEveryLaw)
{
    std::mt19937 random(12);
    for (int i = 0; i < 2000; ++i) {
        MaterialConstants<double> m = mixed(uniform(random, 0, 5000), uniform(random, 0, 2000));
        GeneralConstants<double>& g = m.general;
        if (i % 3 != 0) {
            g.powerModulus = uniform(random, 10, 1000);
            g.powerExponent = uniform(random, 0.1, 1);
        }
        g.rateLaw = RateLaw(i / 3 % 3);
        if (i % 3 == 0 && g.rateLaw == RateLaw::none) g.rateLaw = RateLaw::cowperSymonds;
        g.referenceRate = std::pow(10, uniform(random, -3, 5));
        g.rateCoefficient = g.rateLaw == RateLaw::logarithmic ? uniform(random, 0.001, 0.2)
                                                              : 1 / uniform(random, 1, 20);
        const double e = i % 5 == 0 ? 0 : std::pow(10, uniform(random, -8, 0));
        const double slow = double(slowYield(m, e)), rate = std::pow(10, uniform(random, 4, 9));
        const double trial = slow * (1 + std::pow(10, uniform(random, -6, 1)));
        Sym3<double> stress{2 * trial / 3, -trial / 3, -trial / 3, 0, 0, 0}, backstress{};
        const PlasticStep<double> step =
            generalReturn<double>(m, {e, 0.0, 0.0, rate}, stress, backstress);
        const double expected = bisected(m, e, trial, rate);
        const double stiffness = m.threeMu + g.kinematicModulus;
        // In stress, of the yield stress: what a wrong increment would be worth.
        EXPECT_LT(stiffness * std::abs(step.strainIncrement - expected), 1e-9 * trial)
            << i << " law " << int(g.rateLaw) << " e " << e << " rate " << rate << " trial/slow "
            << trial / slow << " n " << g.powerExponent << " coefficient " << g.rateCoefficient;
    }
}

TEST(GeneralPlasticity, HeatSoftensAsTheFormulaSays)
{
    MaterialConstants<double> m = copper();
    m.general.rateLaw = RateLaw::none;
    for (const double rise : {0.0, 100.0, 700.0}) {
        MaterialPoint point;
        point.rise = rise;
        point.pull(m, 0.1, 100);
        const double softening = 1 - std::pow(rise / (1356 - 293), 1.09);
        const double expected = softening * (90 + 292 * std::pow(point.plasticStrain, 0.31));
        EXPECT_NEAR(point.shear(), expected, 1e-9 * expected);
    }
    MaterialPoint molten;
    molten.rise = 2000;
    molten.pull(m, 0.1, 100);
    EXPECT_LT(std::abs(molten.shear()), 1e-3);
    EXPECT_TRUE(std::isfinite(molten.plasticStrain));
}

// Adiabatic: the rise is beta W_p / (rho c), whatever the path.
TEST(GeneralPlasticity, TheElementHeatsByItsPlasticWork)
{
    MaterialConstants<double> m = copper();
    const double beta = 0.9, specificHeat = 3.83e8; // mJ / (tonne K)
    m.general.heatPerWork = beta / specificHeat;
    Element<GeneralPlasticity, PhysicalHourglass> element(m, brick(1, 2, 3));
    element.mass = 8.96e-9 * 6;
    element.state.temperatureRise = 0;
    double plastic = 0;
    for (int n = 0; n < 200; ++n) {
        Corners next = element.x;
        next.col(0) *= 1.002;
        next(3, 1) += 0.001;
        element.advance(next, 1e6);
        plastic += element.step.plastic;
    }
    EXPECT_GT(element.state.temperatureRise, 20);
    EXPECT_NEAR(element.state.temperatureRise, beta * plastic / (element.mass * specificHeat),
                1e-12 * element.state.temperatureRise);
}

// A stressed element with a backstress turns ten times: stress and backstress turn with it.
TEST(GeneralPlasticity, TheBackstressTurnsWithTheElement)
{
    for (const RotationRule rule :
         {RotationRule::midSurface, RotationRule::polar, RotationRule::hughesWinget}) {
        MaterialConstants<double> m = mixed(100, 5000);
        m.general.rotation = rule;
        Element<GeneralPlasticity, StiffnessHourglass> element(m, brick(1, 2, 3));
        for (int n = 0; n < 20; ++n) {
            Corners next = element.x;
            next.col(0) *= 1.003;
            next.col(1) += 0.002 * next.col(2);
            element.advance(next);
        }
        const Matrix stress = element.stress(), back = matrixOf(element.state.backstress);
        EXPECT_GT(mises(back), 100);
        const Corners start = element.x;
        const Vector axis = Vector(1, 1, 1).normalized();
        for (int n = 1; n <= 720; ++n)
            element.advance(start * turn(axis, n * 2 * M_PI / 72).transpose());
        EXPECT_LT((element.stress() - stress).norm(), 1e-10 * stress.norm());
        EXPECT_LT((matrixOf(element.state.backstress) - back).norm(), 1e-10 * back.norm());
        EXPECT_NEAR(mises(matrixOf(element.state.backstress)), mises(back), 1e-10 * mises(back));
        const Matrix quarter = turn(axis, 1.0);
        element.advance(start * turn(axis, 0.5).transpose());
        element.advance(start * quarter.transpose());
        EXPECT_LT(
            (matrixOf(element.state.backstress) - quarter * back * quarter.transpose()).norm(),
            1e-9 * back.norm());
    }
}
