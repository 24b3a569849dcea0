#include "study/Curve.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fpm;

namespace {

template <class Function>
Curve curveOf(int count, double end, const Function& f)
{
    Curve curve;
    for (int i = 0; i <= count; ++i) {
        curve.t.push_back(end * i / count);
        curve.y.push_back(f(curve.t.back()));
    }
    return curve;
}

} // namespace

TEST(Curve, IsLinearBetweenItsPoints)
{
    const Curve curve{{0, 1, 3}, {0, 2, 4}};

    EXPECT_EQ(valueAt(curve, 0.25), 0.5);
    EXPECT_EQ(valueAt(curve, 2), 3);
    EXPECT_EQ(valueAt(curve, -1), 0);
    EXPECT_EQ(valueAt(curve, 9), 4);
    EXPECT_TRUE(std::isnan(valueAt({}, 1)));
}

TEST(Curve, MeasuresErrorsKnownByHand)
{
    // 3 t beside 2 t over 0 ... 1: every error is a half.
    const auto ours = curveOf(10, 1, [](double t) { return 3 * t; });
    const auto exact = curveOf(4, 1, [](double t) { return 2 * t; });

    const auto errors = errorsOf(ours, exact);

    EXPECT_NEAR(errors.l2, 0.5, 1e-14);
    EXPECT_NEAR(errors.peak, 0.5, 1e-14);
    EXPECT_NEAR(errors.final, 0.5, 1e-14);
    EXPECT_NEAR(errors.peakTime, 0, 1e-14);
}

TEST(Curve, MeasuresThePeakByMagnitudeAndItsTimeByTheSpan)
{
    const Curve ours{{0, 1, 2, 3, 4}, {0, 1, -3, 0, 1}}, exact{{0, 1, 2, 3, 4}, {0, -4, 2, 0, 0}};

    const auto errors = errorsOf(ours, exact);

    EXPECT_DOUBLE_EQ(errors.peak, 0.25);
    EXPECT_NEAR(errors.peakTime, 0.25, 1e-8);
    EXPECT_DOUBLE_EQ(errors.final, 0.25);
}

TEST(Curve, ComparesPeaksOfOneSign)
{
    // Two peaks as high as each other: rounding must not pair the first with the second.
    const Curve ours{{0, 1, 2, 3, 4}, {0, 1.9, 0, -2.1, 0}},
        exact{{0, 1, 2, 3, 4}, {0, 2, 0, -2, 0}};

    EXPECT_NEAR(errorsOf(ours, exact).peak, 0.05, 1e-12);
    EXPECT_NEAR(errorsOf(ours, exact).peakTime, 0, 1e-12);
}

TEST(Curve, InterpolatesTheFinerOfTheTwo)
{
    const auto f = [](double t) { return std::sin(6 * t); };
    const auto few = curveOf(10, 1, f), many = curveOf(10000, 1, f);

    EXPECT_LT(errorsOf(few, many).l2, 1e-6);
    EXPECT_LT(errorsOf(many, few).l2, 1e-6);
}

TEST(Curve, WeighsTimeAndNotPoints)
{
    // Wrong by 1 in the first half, which has one interval, right in the second, which has ten.
    Curve ours{{0, 0.5}, {2, 2}}, exact{{0, 0.5}, {1, 1}};
    for (int i = 1; i <= 10; ++i)
        for (Curve* curve : {&ours, &exact}) {
            curve->t.push_back(0.5 + i / 20.0);
            curve->y.push_back(1);
        }
    ours.t.insert(ours.t.begin() + 2, 0.5 + 1e-9), ours.y.insert(ours.y.begin() + 2, 1);

    EXPECT_NEAR(errorsOf(ours, exact).l2, std::sqrt(0.5 + 0.025), 1e-6);
}

TEST(Curve, ComparesTheTimesBothHave)
{
    const auto ours = curveOf(10, 1, [](double) { return 1.0; });
    const auto exact = curveOf(40, 4, [](double t) { return t > 1.01 ? 7.0 : 2.0; });

    EXPECT_NEAR(errorsOf(ours, exact).l2, 0.5, 1e-12);
}

TEST(Curve, HasNoErrorAgainstNothing)
{
    const auto zero = curveOf(10, 1, [](double) { return 0.0; });

    EXPECT_TRUE(std::isnan(errorsOf(zero, zero).l2));
    EXPECT_TRUE(std::isnan(errorsOf(zero, {}).l2));
}

TEST(Convergence, FindsTheOrderThatMadeTheResults)
{
    for (const double order : {0.5, 1.0, 2.0, 3.7}) {
        const std::array<double, 3> h{1.0, 1 / 3.0, 0.25};
        const auto f = [&](double step) { return 4 + 0.3 * std::pow(step, order); };
        const auto found = observedOrder(h, f(h[0]) - f(h[1]), f(h[1]) - f(h[2]));
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, order, 1e-6);
    }
}

TEST(Convergence, HasNoOrderWhereResultsDoNotConverge)
{
    EXPECT_FALSE(observedOrder({4, 2, 1}, 1, 1.1));
    EXPECT_FALSE(observedOrder({4, 2, 1}, 1, -0.1));
    EXPECT_FALSE(observedOrder({4, 2, 1}, 1, 0));
    EXPECT_FALSE(observedOrder({4, 2, 1}, 0, 0));
}

TEST(Convergence, ExtrapolatesToTheExactCurve)
{
    const auto at = [](double h) {
        return curveOf(20, 1, [h](double t) { return std::sin(t) + h * h * t; });
    };

    const Curve estimate = extrapolated(at(2), at(1), 2, 1, 2);

    for (std::size_t i = 0; i < estimate.t.size(); ++i)
        EXPECT_NEAR(estimate.y[i], std::sin(estimate.t[i]), 1e-14);
}

TEST(PerLength, MakesADensityOfTheSharesOfNodes)
{
    // A load of 6 per length on places 0, 1, 3, each with a node in front and one behind.
    const Curve shares{{0, 0, 1, 1, 3, 3}, {1, 2, 5, 4, 2, 4}};
    const Curve load = perLength(shares);
    EXPECT_EQ(load.t, (std::vector<double>{0, 1, 3}));
    EXPECT_EQ(load.y, (std::vector<double>{6, 6, 6}));
    EXPECT_TRUE(perLength({{1, 1}, {2, 2}}).t.empty());
}

TEST(Averaged, IsTheMeanOfAWindow)
{
    // y = t^2 by straight lines of 0.01: its mean over a window w is t^2 + w^2 / 12.
    Curve curve;
    for (int i = 0; i <= 200; ++i) {
        curve.t.push_back(0.01 * i);
        curve.y.push_back(curve.t.back() * curve.t.back());
    }
    const Curve mean = averaged(curve, 0.3);
    EXPECT_NEAR(mean.y[100], 1 + 0.09 / 12, 2e-5);
    EXPECT_NEAR(mean.y[200], (8 - 1.85 * 1.85 * 1.85) / 3 / 0.15, 2e-5) << "half a window";
    EXPECT_EQ(averaged({{1}, {5}}, 0.3).y, (std::vector<double>{5}));
}
