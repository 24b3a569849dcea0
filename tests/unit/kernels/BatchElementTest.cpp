#include "unit/kernels/BatchLanes.h"
#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace fpm;

namespace fpm::test {

std::vector<BatchCase> batchCases(int count)
{
    std::mt19937 random(39);
    std::vector<BatchCase> cases;
    for (int n = 0; n < count; ++n) {
        const Corners start = warpedHexahedron(random);
        const Corners move = start * (turn(randomAxis(random), 0.3) - Matrix::Identity())
                             + randomCorners(random, 0.02);
        const Modes<double> x = modesOf(start + move), w = modesOf(move);
        BatchCase e;
        for (std::size_t k = 0; k < 8; ++k) {
            const Vec3<double>&a = x.mode[k], &b = w.mode[k];
            for (std::size_t c = 0; c < 3; ++c) {
                e.modes[3 * k + c] = c == 0 ? a.x : c == 1 ? a.y : a.z;
                e.increment[3 * k + c] = c == 0 ? b.x : c == 1 ? b.y : b.z;
            }
        }
        e.mass = uniform(random, 0.5, 2);
        for (double& s : e.stress) s = uniform(random);
        e.plasticStrain = uniform(random, 0, 0.06);
        for (double& q : e.hourglass) q = 0.1 * uniform(random);
        const Matrix back = randomSymmetric(random, 0.3);
        const Sym3<double> a = symmetric(back - back.trace() / 3 * Matrix::Identity());
        e.backstress = {a.xx, a.yy, a.zz, a.xy, a.yz, a.zx};
        e.temperatureRise = uniform(random, 0, 500);
        cases.push_back(e);
    }
    return cases;
}

std::vector<BatchOutcome> scalarOutcomes(const std::vector<BatchCase>& cases)
{
    return outcomes<double>(cases);
}

std::vector<BatchOutcome> scalarFloatOutcomes(const std::vector<BatchCase>& cases)
{
    return outcomes<float>(cases);
}

std::vector<BatchOutcome> generalScalarOutcomes(const std::vector<BatchCase>& cases)
{
    return generalOutcomes<double>(cases);
}

std::vector<BatchOutcome> generalScalarFloatOutcomes(const std::vector<BatchCase>& cases)
{
    return generalOutcomes<float>(cases);
}

void expectEqualBits(const std::vector<BatchOutcome>& a, const std::vector<BatchOutcome>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t e = 0; e < a.size(); ++e)
        for (std::size_t k = 0; k < a[e].size(); ++k)
            ASSERT_EQ(std::memcmp(&a[e][k], &b[e][k], sizeof(double)), 0)
                << "element " << e << " value " << k << ": " << a[e][k] << " and " << b[e][k];
}

} // namespace fpm::test

using namespace fpm::test;

TEST(BatchElement, FourDoublesEqualScalarCodeToTheLastBit)
{
    const auto cases = batchCases(256);
    expectEqualBits(outcomes<Batch<double, 4>>(cases), scalarOutcomes(cases));
}

TEST(BatchElement, EightFloatsEqualScalarCodeToTheLastBit)
{
    const auto cases = batchCases(256);
    expectEqualBits(outcomes<Batch<float, 8>>(cases), scalarFloatOutcomes(cases));
}

TEST(BatchElement, EveryGeneralLawEqualsScalarCodeToTheLastBit)
{
    const auto cases = batchCases(256);
    expectEqualBits(generalOutcomes<Batch<double, 4>>(cases), generalScalarOutcomes(cases));
    expectEqualBits(generalOutcomes<Batch<float, 8>>(cases), generalScalarFloatOutcomes(cases));
}

TEST(BatchElement, EveryGeneralLawIsAtWorkInTheCases)
{
    const auto cases = batchCases(256);
    const auto all = generalScalarOutcomes(cases);
    for (std::size_t law = 0; law < 5; ++law) {
        int yielding = 0, deleted = 0;
        double heat = 0;
        for (std::size_t e = 0; e < cases.size(); ++e) {
            const BatchOutcome& outcome = all[law * cases.size() + e];
            for (const double value : outcome) EXPECT_TRUE(std::isfinite(value));
            yielding += outcome[24 + 6 + 12 + 4] > 0;
            heat += outcome[54];
            deleted += outcome[55] > 0;
        }
        EXPECT_GT(yielding, 10) << law;
        EXPECT_EQ(heat > 0, law == 2);
        EXPECT_EQ(deleted > 5 && deleted < 250, law == 3) << deleted;
    }
}

TEST(BatchElement, TheCasesHoldElasticAndYieldingElements)
{
    const auto cases = batchCases(256);
    int yielding = 0;
    for (const BatchOutcome& outcome : scalarOutcomes(cases)) {
        for (const double value : outcome) EXPECT_TRUE(std::isfinite(value));
        yielding += outcome[24 + 6 + 12 + 4] > 0;
    }
    EXPECT_GT(yielding, 100);
    EXPECT_LT(yielding, 3 * 256 - 20);
}

TEST(BatchElement, FloatAgreesWithDoubleToItsDigits)
{
    const auto cases = batchCases(256);
    const auto wide = scalarOutcomes(cases), narrow = scalarFloatOutcomes(cases);
    for (std::size_t e = 0; e < wide.size(); ++e) {
        double scale = 0, error = 0;
        for (std::size_t k = 3; k < 24; ++k) {
            scale = std::max(scale, std::abs(wide[e][k]));
            error = std::max(error, std::abs(wide[e][k] - narrow[e][k]));
        }
        EXPECT_LT(error, 1e-4 * scale);
    }
}
