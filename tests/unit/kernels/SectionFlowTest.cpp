#include "kernels/material/SectionFlow.h"

#include "kernels/material/GeneralPlasticity.h"
#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

constexpr double young = 70000, poisson = 0.3, yieldStress = 285;

struct Flow {
    PlasticStep<double> radial, plastic;
    SectionFlow<double> section;
    Sym3<double> stress;
};

/// The whole return of a stress and a bending whose stiffness is `stiffness`.
Flow flowFrom(const MaterialConstants<double>& m,
              const Matrix& trial,
              double bending,
              double stiffness)
{
    Flow flow;
    flow.stress = symmetric(trial);
    flow.radial = flow.plastic = radialReturn<double>(m, 0.0, bending, flow.stress);
    Sym3<double> none{};
    flow.section = flowOfSection<double>(m, bending, bending * bending / stiffness, 0.0,
                                         flow.plastic, flow.stress, none);
    return flow;
}

/// A random stress whose measure with `ratio` of bending to stretch is `size`.
Matrix sized(std::mt19937& random, double ratio, double size)
{
    const Matrix s = randomSymmetric(random, 1);
    const double q = mises(s);
    return s * (size / sectionStress<double>(q, ratio * q));
}

} // namespace

TEST(SectionFlow, FollowsTheNormalOfTheLimitSurface)
{
    const MaterialConstants<double> m = materialOf(young, poisson, yieldStress);
    std::mt19937 random(31);
    int curved = 0, edges = 0;
    for (int i = 0; i < 200; ++i) {
        const double ratio = std::pow(10, uniform(random, -3, 1));
        const Matrix trial = sized(random, ratio, yieldStress * uniform(random, 1.0001, 1.03));
        const double q = mises(trial), bending = ratio * q,
                     stiffness = young * uniform(random, 0.5, 2);
        const Flow flow = flowFrom(m, trial, bending, stiffness);
        const double left = mises(matrixOf(flow.stress)), n = left / yieldStress;
        const double kept = flow.section.bendingKept * bending;
        EXPECT_NEAR(n * n + kept / yieldStress, 1, 1e-12);
        const double stretched = (q - left) / m.threeMu, bent = (bending - kept) / stiffness;
        if (kept > 0) {
            EXPECT_NEAR(bent * 2 * n, stretched, 1e-6 * stretched);
            ++curved;
        } else { // the edge bears every direction up to its normal
            EXPECT_LE(bent * 2, stretched);
            ++edges;
        }
        const double work = left * stretched + kept * bent;
        EXPECT_NEAR(flow.plastic.work + flow.section.bendingWork, work, 1e-9 * work);
        EXPECT_NEAR(flow.plastic.strainIncrement, work / yieldStress, 1e-9 * work / yieldStress);
    }
    EXPECT_GT(curved, 20);
    EXPECT_GT(edges, 20);
}

TEST(SectionFlow, StaysOnTheSurfaceHoweverFarTheTrialIs)
{
    const MaterialConstants<double> m = materialOf(young, poisson, yieldStress);
    std::mt19937 random(32);
    for (int i = 0; i < 200; ++i) {
        const double ratio = std::pow(10, uniform(random, -3, 3));
        const Matrix trial = sized(random, ratio, yieldStress * uniform(random, 1, 100));
        const double bending = ratio * mises(trial);
        const Flow flow = flowFrom(m, trial, bending, young);
        const double n = mises(matrixOf(flow.stress)) / yieldStress;
        EXPECT_NEAR(n * n + flow.section.bendingKept * bending / yieldStress, 1, 1e-10);
        EXPECT_GE(flow.section.bendingKept, 0);
        EXPECT_LE(flow.section.bendingKept, 1);
    }
}

TEST(SectionFlow, WithoutBendingItIsTheRadialReturn)
{
    const MaterialConstants<double> m = materialOf(young, poisson, yieldStress, 900);
    std::mt19937 random(33);
    const Matrix trial = randomSymmetric(random, 2000);
    Sym3<double> radial = symmetric(trial);
    const PlasticStep<double> step = radialReturn<double>(m, 0.0, 0.0, radial);
    const Flow flow = flowFrom(m, trial, 0, young);
    EXPECT_LT((matrixOf(flow.stress) - matrixOf(radial)).norm(), 1e-12 * trial.norm());
    EXPECT_NEAR(flow.plastic.strainIncrement, step.strainIncrement, 1e-12 * step.strainIncrement);
    EXPECT_NEAR(flow.plastic.work, step.work, 1e-12 * step.work);
}

TEST(SectionFlow, AnElasticSectionIsKeptToTheLastBit)
{
    const MaterialConstants<double> m = materialOf(young, poisson, yieldStress);
    std::mt19937 random(34);
    const Matrix trial = sized(random, 0.7, 0.9 * yieldStress);
    const Flow flow = flowFrom(m, trial, 0.7 * mises(trial), young);
    EXPECT_EQ(matrixOf(flow.stress), trial);
    EXPECT_EQ(flow.section.bendingKept, 1);
    EXPECT_EQ(flow.plastic.strainIncrement, 0);
    const Flow still = flowFrom(m, Matrix::Zero(), 0, young);
    EXPECT_EQ(matrixOf(still.stress).norm(), 0);
    EXPECT_EQ(still.plastic.strainIncrement, 0);
}

TEST(SectionFlow, MeasuresTheStressFromTheBackstressAndMovesIt)
{
    // Prager: d a = 2/3 H d eps_p, d eps_p = -d s / 2 mu; the limit surface holds for s - a.
    MaterialConstants<double> m = materialOf(young, poisson, yieldStress);
    std::mt19937 random(35);
    for (const double modulus : {1.0, 20000.0})
        for (int i = 0; i < 100; ++i) {
            m.general.kinematicModulus = modulus;
            const Matrix shift = randomSymmetric(random, 100);
            const Matrix centre = shift - shift.trace() / 3 * Matrix::Identity();
            const double ratio = std::pow(10, uniform(random, -2, 0.5));
            const Matrix trial = sized(random, ratio, yieldStress * uniform(random, 1.001, 1.1));
            Sym3<double> stress = symmetric(trial + centre), backstress = symmetric(centre);
            const double bending = ratio * mises(trial);
            PlasticStep<double> plastic =
                generalReturn<double>(m, {0.0, bending, 0.0, 0.0}, stress, backstress);
            const SectionFlow<double> section = flowOfSection<double>(
                m, bending, bending * bending / young, modulus, plastic, stress, backstress);
            const Matrix s = matrixOf(stress), a = matrixOf(backstress);
            const double n = mises(s - a) / yieldStress;
            EXPECT_NEAR(n * n + section.bendingKept * bending / yieldStress, 1, 1e-10);
            const Matrix strain = (trial + centre - s) / m.twoMu;
            EXPECT_GT(strain.norm(), 0);
            EXPECT_LT((a - centre - 2.0 / 3 * modulus * strain).norm(),
                      1e-9 * modulus * strain.norm());
            const double work = s.cwiseProduct(strain).sum();
            EXPECT_NEAR(plastic.work, work, 1e-9 * yieldStress * strain.norm());
        }
}
