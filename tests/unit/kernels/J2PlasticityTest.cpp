#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

constexpr double young = 70000, poisson = 0.3, yieldStress = 285, modulus = 900;

/// Hardening with rows of falling slope.
MaterialConstants<double> tabulated()
{
    MaterialConstants<double> m = materialOf(young, poisson);
    const double strain[4] = {0, 0.01, 0.03, 0.1}, stress[4] = {285, 320, 350, 380};
    m.rows = 4;
    for (int i = 0; i < 4; ++i) {
        m.strain[i] = strain[i];
        m.stress[i] = stress[i];
        if (i < 3) m.slope[i] = (stress[i + 1] - stress[i]) / (strain[i + 1] - strain[i]);
    }
    m.slope[3] = m.slope[2];
    return m;
}

double tableAt(const MaterialConstants<double>& m, double strain)
{
    int row = m.rows - 1;
    while (row > 0 && strain < m.strain[row]) --row;
    return m.stress[row] + m.slope[row] * (strain - m.strain[row]);
}

struct MaterialPoint {
    Sym3<double> stress{};
    double plasticStrain = 0, work = 0;

    void strain(const MaterialConstants<double>& m, const Matrix& increment)
    {
        stress = elasticStress<double>(m, stress, symmetric(increment));
        const PlasticStep<double> step = radialReturn<double>(m, plasticStrain, 0.0, stress);
        plasticStrain += step.strainIncrement;
        work += step.work;
    }
};

using PlasticElement = Element<J2Plasticity, StiffnessHourglass>;

/// Stretches a brick along x and finds the lateral stretch that leaves no lateral stress.
void pull(PlasticElement& element, double stretch)
{
    double lateral = 1 - poisson * (stretch - 1);
    const auto moved = [&](double side) {
        PlasticElement trial = element;
        Corners next = element.x;
        next.col(0) *= stretch;
        next.rightCols<2>() *= side;
        trial.advance(next);
        return trial;
    };
    for (int iteration = 0; iteration < 50; ++iteration) {
        const double h = 1e-7, residual = moved(lateral).state.stress.yy;
        if (std::abs(residual) < 1e-11 * yieldStress) break;
        const double slope = (moved(lateral + h).state.stress.yy - residual) / h;
        lateral -= residual / slope;
    }
    element = moved(lateral);
}

} // namespace

TEST(J2Plasticity, UniaxialStressFollowsTheHardeningLine)
{
    for (const double direction : {1.0, -1.0}) {
        PlasticElement element(materialOf(young, poisson, yieldStress, modulus), brick(1, 2, 3));
        for (int n = 0; n < 50; ++n) pull(element, 1 + direction * 0.004);
        const double expected = yieldStress + modulus * element.state.equivalentPlasticStrain;
        EXPECT_GT(element.state.equivalentPlasticStrain, 0.15);
        EXPECT_LT(std::abs(element.state.stress.yy), 1e-10 * yieldStress);
        EXPECT_NEAR(direction * element.state.stress.xx, expected, 1e-10 * expected);
    }
}

TEST(J2Plasticity, UniaxialStressIsElasticBelowTheYieldStress)
{
    PlasticElement element(materialOf(young, poisson, yieldStress, modulus), brick(1, 2, 3));
    const double stretch = 1 + 0.99 * yieldStress / young;
    pull(element, stretch);
    EXPECT_EQ(element.state.equivalentPlasticStrain, 0);
    // The step measures 2 (L - 1) / (L + 1).
    const double strain = 2 * (stretch - 1) / (stretch + 1);
    EXPECT_NEAR(element.state.stress.xx, young * strain, 1e-9 * yieldStress);
}

TEST(J2Plasticity, PureShearYieldsAtTheYieldStressOverRootThree)
{
    const MaterialConstants<double> m = materialOf(young, poisson, yieldStress, modulus);
    const double atYield = yieldStress / std::sqrt(3.0);
    const auto sheared = [&](double stress) {
        Matrix strain = Matrix::Zero();
        strain(0, 1) = strain(1, 0) = stress / m.twoMu;
        MaterialPoint point;
        point.strain(m, strain);
        return point;
    };
    EXPECT_EQ(sheared(atYield * (1 - 1e-12)).plasticStrain, 0);
    EXPECT_GT(sheared(atYield * (1 + 1e-12)).plasticStrain, 0);
    const MaterialPoint beyond = sheared(3 * atYield);
    const double expected = (yieldStress + modulus * beyond.plasticStrain) / std::sqrt(3.0);
    EXPECT_NEAR(beyond.stress.xy, expected, 1e-12 * expected);
    EXPECT_EQ(beyond.stress.xx, 0);
}

TEST(J2Plasticity, OneStepAcrossSeveralRowsEqualsManySmallSteps)
{
    const MaterialConstants<double> m = tabulated();
    std::mt19937 random(16);
    for (int i = 0; i < 50; ++i) {
        const Matrix strain = randomSymmetric(random, 0.2);
        MaterialPoint once, often;
        once.strain(m, strain);
        const int steps = 1000;
        for (int n = 0; n < steps; ++n) often.strain(m, strain / steps);
        EXPECT_GT(once.plasticStrain, m.strain[2]);
        EXPECT_NEAR(once.plasticStrain, often.plasticStrain, 1e-10 * once.plasticStrain);
        const double scale = mises(matrixOf(once.stress));
        EXPECT_LT((matrixOf(once.stress) - matrixOf(often.stress)).cwiseAbs().maxCoeff(),
                  1e-10 * matrixOf(once.stress).norm());
        EXPECT_NEAR(scale, tableAt(m, once.plasticStrain), 1e-10 * scale);
    }
}

TEST(J2Plasticity, EndsOnTheTableFromAnyRow)
{
    const MaterialConstants<double> m = tabulated();
    std::mt19937 random(17);
    for (int i = 0; i < 500; ++i) {
        MaterialPoint point;
        point.plasticStrain = uniform(random, 0, 0.15);
        const double before = point.plasticStrain;
        point.strain(m, randomSymmetric(random, 0.05));
        const double q = mises(matrixOf(point.stress));
        if (point.plasticStrain > before)
            EXPECT_NEAR(q, tableAt(m, point.plasticStrain), 1e-11 * q);
        else
            EXPECT_LE(q, tableAt(m, before) * (1 + 1e-12));
    }
}

TEST(J2Plasticity, AnElasticStressIsKeptToTheLastBit)
{
    const MaterialConstants<double> m = materialOf(young, poisson, yieldStress);
    std::mt19937 random(18);
    const Sym3<double> before = symmetric(randomSymmetric(random, 0.2 * yieldStress));
    Sym3<double> stress = before;
    const PlasticStep<double> step = radialReturn<double>(m, 0.0, 0.0, stress);
    EXPECT_EQ(step.strainIncrement, 0);
    EXPECT_EQ(step.work, 0);
    EXPECT_EQ(step.reduction, 0);
    EXPECT_EQ(matrixOf(stress), matrixOf(before));
}

TEST(J2Plasticity, AStressFreePointStaysFiniteEvenInFloat)
{
    const MaterialConstants<float> m = materialOf<float>(70000, 0.3, 285);
    Sym3<float> stress{};
    const PlasticStep<float> step = radialReturn<float>(m, 0.0f, 0.0f, stress);
    EXPECT_EQ(step.strainIncrement, 0);
    EXPECT_EQ(matrixOf(stress).norm(), 0);
}

TEST(J2Plasticity, KeepsThePressureAndTheDirectionOfTheDeviator)
{
    const MaterialConstants<double> m = materialOf(young, poisson, yieldStress, modulus);
    std::mt19937 random(19);
    const Matrix trial = randomSymmetric(random, 2000);
    Sym3<double> stress = symmetric(trial);
    const PlasticStep<double> step = radialReturn<double>(m, 0.0, 0.0, stress);
    const Matrix mean = trial.trace() / 3 * Matrix::Identity();
    const Matrix expected = mean + (1 - step.reduction) * (trial - mean);
    EXPECT_LT((matrixOf(stress) - expected).norm(), 1e-12 * trial.norm());
    // d = (q_tr - sigma_y) / (3 mu + H), and what is dissipated is q d.
    const double d = (mises(trial) - yieldStress) / (m.threeMu + modulus);
    EXPECT_NEAR(step.strainIncrement, d, 1e-13 * d);
    EXPECT_NEAR(step.work, mises(matrixOf(stress)) * d, 1e-12 * step.work);
}

TEST(J2Plasticity, MembraneAndBendingShareTheLimitSurfaceOfASolidSection)
{
    const MaterialConstants<double> m = materialOf(young, poisson, yieldStress);
    std::mt19937 random(20);
    for (int i = 0; i < 100; ++i) {
        const Matrix trial = randomSymmetric(random, 500);
        const double bending = uniform(random, 200, 600);
        Sym3<double> stress = symmetric(trial);
        const PlasticStep<double> step = radialReturn<double>(m, 0.0, bending, stress);
        const double kept = 1 - step.reduction, q = mises(matrixOf(stress));
        EXPECT_NEAR(q, kept * mises(trial), 1e-12 * q);
        const double share = q / yieldStress;
        const double surface = share * share + kept * bending / yieldStress;
        if (step.strainIncrement > 0)
            EXPECT_NEAR(surface, 1, 1e-12);
        else
            EXPECT_LT(surface, 1);
    }
}
