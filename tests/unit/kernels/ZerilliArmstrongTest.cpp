#include "kernels/material/ZerilliArmstrong.h"

#include "parallel/Batch.h"
#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

using Values = std::array<double, 8>;

/// MPa, s, K: Zerilli and Armstrong 1987, iron and copper with their grain sizes.
constexpr Values iron{65, 1033, 0, 0.00698, 0.000415, 266, 0.289, 1};
constexpr Values copper{65, 0, 890, 0.0028, 0.000115, 0, 1, 1};

MaterialConstants<double> metal(const Values& values, double temperature = 293)
{
    MaterialConstants<double> m = materialOf(120000, 0.34);
    m.rows = 0;
    m.general.temperature = temperature;
    EXPECT_EQ(ZerilliArmstrong::fault(values.data()).parameter, -1);
    ZerilliArmstrong::constants(values.data(), m);
    return m;
}

/// The formula, written for itself.
long double yieldOf(const Values& c, long double e, long double rate, long double temperature)
{
    const long double thermal =
        std::exp(-c[3] * temperature + c[4] * temperature * std::log(rate / c[7]));
    return c[0] + (c[1] + c[2] * std::sqrt(e)) * thermal
           + c[5] * std::pow(e, static_cast<long double>(c[6]));
}

double bisected(const Values& c, double threeMu, double e, double trial, double rate, double t)
{
    long double low = -800, high = std::log(static_cast<long double>(trial) / threeMu);
    for (int i = 0; i < 200; ++i) {
        const long double z = (low + high) / 2, d = std::exp(z);
        (trial - threeMu * d > yieldOf(c, e + d, d * rate, t) ? low : high) = z;
    }
    return double(std::exp(low));
}

Sym3<double> sheared(double mises)
{
    return {2 * mises / 3, -mises / 3, -mises / 3, 0, 0, 0};
}

} // namespace

// A steady rate in small steps: the stress is that of the formula.
TEST(ZerilliArmstrong, TheStressOfASteadyRateIsThatOfTheFormula)
{
    for (const Values& c : {iron, copper})
        for (const double temperature : {200.0, 293.0, 600.0})
            for (const double strainRate : {1e-3, 1.0, 1e4}) {
                const MaterialConstants<double> m = metal(c, temperature);
                const double perStep = 1e-5, rate = strainRate / perStep; // 1 / step
                Sym3<double> stress{}, unused{};
                double e = 0;
                for (int n = 0; n < 20000; ++n) {
                    stress = elasticStress<double>(m, stress,
                                                   {perStep, -perStep / 2, -perStep / 2, 0, 0, 0});
                    e += ZerilliArmstrong::update<double>(m, {e, 0, 0, rate}, stress, unused)
                             .strainIncrement;
                }
                const double expected = double(yieldOf(c, e, strainRate, temperature));
                EXPECT_NEAR(stress.xx - stress.yy, expected, 1e-3 * expected);
                EXPECT_NEAR(e, 0.2, 0.01);
            }
}

TEST(ZerilliArmstrong, TheReturnConvergesOverTheRangeOfTheLaw)
{
    std::mt19937 random(6);
    for (int i = 0; i < 3000; ++i) {
        Values c{uniform(random, 0, 200),    uniform(random, 0, 1500),
                 uniform(random, 0, 1500),   uniform(random, 0, 0.01),
                 uniform(random, 0, 0.0006), uniform(random, 0, 600),
                 uniform(random, 0.1, 1),    std::pow(10, uniform(random, -3, 3))};
        if (i % 4 == 0) c[4] = 0;
        if (i % 4 == 1) c[1] = c[5] = 0;
        if (i % 4 == 2) c[2] = 0;
        const double t = uniform(random, 50, 1500), rate = std::pow(10, uniform(random, 4, 9));
        const MaterialConstants<double> m = metal(c, t);
        const double e = i % 5 == 0 ? 0 : std::pow(10, uniform(random, -8, 0));
        const double slow = double(yieldOf(c, e, c[7], t));
        const double trial = slow * (1 + std::pow(10, uniform(random, -5, 1)));
        Sym3<double> stress = sheared(trial), unused{};
        const auto step = ZerilliArmstrong::update<double>(m, {e, 0, 0, rate}, stress, unused);
        const double expected = bisected(c, m.threeMu, e, trial, rate, t);
        EXPECT_LT(m.threeMu * std::abs(step.strainIncrement - expected), 1e-8 * trial)
            << i << " e " << e << " rate " << rate << " T " << t << " trial/slow " << trial / slow
            << " C " << c[0] << ' ' << c[1] << ' ' << c[2] << ' ' << c[3] << ' ' << c[4] << ' '
            << c[5] << ' ' << c[6];
        EXPECT_NEAR(stress.xx - stress.yy, trial - m.threeMu * step.strainIncrement, 1e-9 * trial);
    }
}

TEST(ZerilliArmstrong, AnElasticStressIsKeptToTheLastBit)
{
    const MaterialConstants<double> m = metal(iron);
    Sym3<double> stress{60, 10, 20, 1, 2, 3}, unused{};
    const Matrix before = matrixOf(stress);
    EXPECT_EQ(ZerilliArmstrong::update<double>(m, {0.1, 0, 0, 1e6}, stress, unused).reduction, 0);
    EXPECT_EQ(matrixOf(stress), before);
}

// Adiabatic: the element heats by its plastic work and softens for it.
TEST(ZerilliArmstrong, PlasticWorkHeatsAndSoftens)
{
    double stress[2];
    for (const bool heats : {false, true}) {
        MaterialConstants<double> m = metal(iron);
        m.general.heatPerWork = heats ? 0.9 / 4.5e8 : 0;
        Element<ZerilliArmstrong, PhysicalHourglass> element(m, brick(1, 1, 1));
        element.mass = 7.85e-9;
        double plastic = 0;
        for (int n = 1; n <= 500; ++n) {
            const double stretch = 1 + 4e-4 * n;
            Corners next = brick(1, 1, 1);
            next.col(0) *= stretch;
            next.col(1) /= std::sqrt(stretch);
            next.col(2) /= std::sqrt(stretch);
            element.advance(next, 1e7);
            plastic += element.step.plastic;
        }
        EXPECT_NEAR(element.state.temperatureRise, m.general.heatPerWork * plastic / element.mass,
                    1e-9 * 293);
        EXPECT_EQ(element.state.temperatureRise > 20, heats);
        stress[heats] = mises(element.stress());
    }
    EXPECT_LT(stress[1], 0.95 * stress[0]);
}

TEST(ZerilliArmstrong, BatchesEqualScalarCodeToTheLastBit)
{
    std::mt19937 random(7);
    using Four = Batch<double, 4>;
    for (const Values& c : {iron, copper}) {
        const MaterialConstants<double> m = metal(c);
        for (int i = 0; i < 100; ++i) {
            double trial[4], strain[4], expected[4], out[4], shear[4];
            for (int lane = 0; lane < 4; ++lane) {
                trial[lane] = uniform(random, 50, 1500);
                strain[lane] = uniform(random, 0, 0.5);
                Sym3<double> s = sheared(trial[lane]), unused{};
                expected[lane] =
                    ZerilliArmstrong::update<double>(m, {strain[lane], 0, 0, 1e7}, s, unused)
                        .strainIncrement;
                shear[lane] = s.xx;
            }
            const Four zero(0.0);
            double xx[4], yy[4];
            for (int lane = 0; lane < 4; ++lane) {
                xx[lane] = sheared(trial[lane]).xx;
                yy[lane] = sheared(trial[lane]).yy;
            }
            Sym3<Four> s{NumberTraits<Four>::read(xx),
                         NumberTraits<Four>::read(yy),
                         NumberTraits<Four>::read(yy),
                         zero,
                         zero,
                         zero};
            Sym3<Four> unused{};
            const auto step = ZerilliArmstrong::update<Four>(
                m, {NumberTraits<Four>::read(strain), zero, zero, 1e7}, s, unused);
            NumberTraits<Four>::store(out, step.strainIncrement);
            double stress[4];
            NumberTraits<Four>::store(stress, s.xx);
            for (int lane = 0; lane < 4; ++lane) {
                EXPECT_EQ(out[lane], expected[lane]);
                EXPECT_EQ(stress[lane], shear[lane]);
            }
        }
    }
}

TEST(ZerilliArmstrong, FloatsStayFinite)
{
    MaterialConstants<float> m = metal(iron).converted<float>();
    for (const float trial : {0.0f, 66.0f, 300.0f, 3000.0f})
        for (const float rate : {0.0f, 1e3f, 1e9f}) {
            Sym3<float> s{2 * trial / 3, -trial / 3, -trial / 3, 0, 0, 0}, unused{};
            const auto step = ZerilliArmstrong::update<float>(m, {0, 0, 0, rate}, s, unused);
            EXPECT_TRUE(std::isfinite(step.strainIncrement) && std::isfinite(s.xx));
            EXPECT_GE(step.strainIncrement, 0);
        }
}
