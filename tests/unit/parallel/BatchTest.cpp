#include "parallel/Batch.h"

#include "parallel/Vec3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace fpm;

namespace {

template <class B>
class BatchOf : public testing::Test
{
protected:
    using Scalar = ScalarOf<B>;
    static constexpr int width = NumberTraits<B>::lanes;

    /// Numbers of very different size, so that wrong rounding shows.
    struct Lanes {
        alignas(64) Scalar value[width];
    };
    Lanes numbers()
    {
        Lanes out;
        for (Scalar& v : out.value)
            v = Scalar(std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random_),
                                  int(random_() % 40) - 20));
        return out;
    }
    template <class Expected>
    void expectLanes(const B& result, const Expected& expected)
    {
        Lanes out;
        store(out.value, result);
        for (int lane = 0; lane < width; ++lane) EXPECT_EQ(out.value[lane], expected(lane));
    }

private:
    std::mt19937 random_{40};
};

using Types = testing::Types<Batch<double, 4>, Batch<float, 8>>;
TYPED_TEST_SUITE(BatchOf, Types);

} // namespace

TYPED_TEST(BatchOf, NumbersIsWorkedLaneByLaneWithTheRoundingOfScalars)
{
    for (int run = 0; run < 200; ++run) {
        const auto x = this->numbers(), y = this->numbers(), z = this->numbers();
        const auto a = read<TypeParam>(x.value), b = read<TypeParam>(y.value),
                   c = read<TypeParam>(z.value);
        this->expectLanes(a + b, [&](int i) { return x.value[i] + y.value[i]; });
        this->expectLanes(a - b, [&](int i) { return x.value[i] - y.value[i]; });
        this->expectLanes(a * b, [&](int i) { return x.value[i] * y.value[i]; });
        this->expectLanes(a / b, [&](int i) { return x.value[i] / y.value[i]; });
        this->expectLanes(-a, [&](int i) { return -x.value[i]; });
        this->expectLanes(squareRoot(a * a),
                          [&](int i) { return std::sqrt(x.value[i] * x.value[i]); });
        this->expectLanes(fusedMultiplyAdd(a, b, c),
                          [&](int i) { return std::fma(x.value[i], y.value[i], z.value[i]); });
        this->expectLanes(maximum(a, b), [&](int i) { return std::max(x.value[i], y.value[i]); });
        this->expectLanes(select(a < b, b, c),
                          [&](int i) { return x.value[i] < y.value[i] ? y.value[i] : z.value[i]; });
    }
}

TYPED_TEST(BatchOf, NumbersTakesAScalarIntoEveryLane)
{
    using Real = ScalarOf<TypeParam>;
    this->expectLanes(TypeParam(Real(2.5)), [](int) { return Real(2.5); });
    TypeParam sum(Real(1));
    sum += TypeParam(Real(2));
    this->expectLanes(sum, [](int) { return Real(3); });
}

TYPED_TEST(BatchOf, NumbersIsGatheredFromRecordsThroughIndices)
{
    using Real = ScalarOf<TypeParam>;
    alignas(64) Real records[4 * 100];
    std::vector<std::uint16_t> indices;
    for (int i = 0; i < 400; ++i) records[i] = Real(i * i);
    for (int lane = 0; lane < this->width; ++lane) indices.push_back(std::uint16_t(6 * lane + 3));

    TypeParam x, y, z;
    gather<TypeParam>(records, indices.data(), x, y, z);

    const auto value = [&](int lane, int k) { return records[4 * indices[std::size_t(lane)] + k]; };
    this->expectLanes(x, [&](int lane) { return value(lane, 0); });
    this->expectLanes(y, [&](int lane) { return value(lane, 1); });
    this->expectLanes(z, [&](int lane) { return value(lane, 2); });
}

TYPED_TEST(BatchOf, NumbersIsAccumulatedInTheTypeOfTheMemory)
{
    using Real = ScalarOf<TypeParam>;
    alignas(64) double sum[TestFixture::width];
    for (double& s : sum) s = 1e10;
    accumulate(sum, TypeParam(Real(0.001)));
    for (const double s : sum) EXPECT_EQ(s, 1e10 + double(Real(0.001)));
}

TYPED_TEST(BatchOf, NumbersIsConvertedToAndFromAnotherType)
{
    using Real = ScalarOf<TypeParam>;
    using Other = std::conditional_t<sizeof(Real) == 8, float, double>;
    alignas(64) Other values[TestFixture::width], back[TestFixture::width];
    for (int lane = 0; lane < this->width; ++lane) values[lane] = Other(0.1) * Other(lane + 1);
    const auto batch = read<TypeParam>(values);
    this->expectLanes(batch, [&](int i) { return Real(values[i]); });
    store(back, batch);
    for (int lane = 0; lane < this->width; ++lane) EXPECT_EQ(back[lane], Other(Real(values[lane])));
}

TYPED_TEST(BatchOf, NumbersTreatsNotANumberAsScalarsDo)
{
    using Real = ScalarOf<TypeParam>;
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const TypeParam batch(nan), one(Real(1));
    this->expectLanes(select(batch < one, one, TypeParam(Real(2))), [](int) { return Real(2); });
    this->expectLanes(select(batch > one, one, TypeParam(Real(2))), [](int) { return Real(2); });
    // select(a < b, b, a): the first argument wins where nothing compares.
    this->expectLanes(maximum(one, batch), [&](int) { return maximum(Real(1), nan); });
}
