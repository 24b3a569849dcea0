#include "kernels/contact/law/Penalty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fpm {
namespace {

/// A mass 1 that bounces on a spring of stiffness 1, leapfrog with step omega dt.
class Bouncer
{
public:
    Bouncer(double step, bool keeps) : step_(step)
    {
        law_.springEnergy = &energy_;
        if (keeps) law_.touch = {&gap_, &extra_, &surplus_};
    }
    /// Arrives with velocity -v from gap `from` in (0, v step), and returns the velocity with which
    /// it leaves.
    double bounce(double v, double from)
    {
        double x = from, rate = -v;
        do {
            x += step_ * rate;
            const double force = x < 0 ? law_.normalForce(0, 1, x, 0, step_ * rate, step_) : 0;
            EXPECT_GE(force, 0);
            if (!(x < 0)) law_.open(0, 1, step_ * rate, x);
            mostExtra_ = std::max(mostExtra_, std::abs(extra_));
            rate += step_ * force;
        } while (x < 0);
        return rate;
    }
    double surplus() const { return surplus_; }
    double mostExtra() const { return mostExtra_; }
    const PassLaw<double>& law() const { return law_; }

private:
    double step_;
    double gap_ = 0, extra_ = 0, surplus_ = 0, energy_ = 0, mostExtra_ = 0;
    PassLaw<double> law_{};
};

/// Logarithm of the energy after so many bounces, and its extremes on the way.
struct Drift {
    double last = 0, least = 0, most = 0;
};
Drift driftOf(double step, bool keeps)
{
    Bouncer mass(step, keeps);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> phase(1e-6, 1);
    Drift out;
    double v = 1;
    for (int n = 0; n < 10000; ++n) {
        v = mass.bounce(v, phase(random) * v * step);
        out.last = 2 * std::log(v);
        out.least = std::min(out.least, out.last);
        out.most = std::max(out.most, out.last);
    }
    return out;
}

TEST(TouchMemory, CountsWhatASpringTakesBeyondWhatItGives)
{
    for (const double step : {0.1, 0.5, 1.0, 1.4})
        for (const double phase : {0.03, 0.2, 0.5, 0.8, 0.97}) {
            Bouncer mass(step, true);
            double v = mass.bounce(1, phase * step);
            EXPECT_EQ(mass.mostExtra(), 0) << "the first touch is that of the bare spring";
            EXPECT_EQ(v, Bouncer(step, false).bounce(1, phase * step));
            EXPECT_NEAR(mass.surplus(), 0.5 * (1 - v * v), 1e-13);
            EXPECT_LE(std::abs(mass.surplus()), 0.5 * step * step); // of the energy 1/2
            v = mass.bounce(v, 0.4 * v * step);
            EXPECT_NEAR(mass.surplus(), 0.5 * (1 - v * v), 1e-13);
        }
}

TEST(TouchMemory, TenThousandTouchesMakeNoMoreThanAFew)
{
    for (const double step : {0.2, 0.5, 0.9}) {
        const Drift bare = driftOf(step, false), kept = driftOf(step, true);
        // One touch: (omega dt)^2 / 4 at most, of which a fifth of k |g| returns a tenth of
        // (omega dt)^2 in the mean.
        const double few = 5 * step * step / 4;
        EXPECT_LT(kept.most, few) << step;
        EXPECT_GT(kept.least, -few) << step;
        EXPECT_GT(bare.most - bare.least, 5 * (kept.most - kept.least)) << step;
    }
    EXPECT_GT(driftOf(0.9, false).last, 10) << "the bare spring makes energy without end";
}

TEST(TouchMemory, ASpringThatStaysClosedIsLeftAlone)
{
    double gap = 0, extra = 0, surplus = 0;
    const TouchMemory<double> memory{&gap, &extra, &surplus};
    EXPECT_TRUE(memory.wasOpen(0));
    for (int n = 0; n < 100; ++n)
        EXPECT_EQ(memory.press(0, 3, -1 + 0.1 * std::sin(n), n == 0 ? 0 : 1e9), 0);
    EXPECT_EQ(surplus, 0) << "closed from the start";
    EXPECT_FALSE(memory.wasOpen(0));
    memory.lose(0);
    EXPECT_TRUE(memory.wasOpen(0));
    EXPECT_EQ(surplus, 0);
}

TEST(TouchMemory, ReturnsWithinTheBoundsOfTheForce)
{
    double gap = 0, extra = 0, surplus = -100; // far more than one step may return
    const TouchMemory<double> memory{&gap, &extra, &surplus};
    EXPECT_DOUBLE_EQ(memory.press(0, 2, -1, -3), TouchMemory<double>::most * 2);
    EXPECT_DOUBLE_EQ(surplus, -100 + 2 + 0.5 * 0.4 * 3); // k d g' / 2, and half of the extra force
    EXPECT_EQ(memory.press(0, 2, -2, -1), 0);
    EXPECT_DOUBLE_EQ(surplus, -98 + 0.6 + 0.5 * 0.4 * 1);
    memory.open(0, 2, 0.5);
    surplus = 100;
    EXPECT_DOUBLE_EQ(memory.press(0, 2, -1, -3), -2) << "never tensile";
}

} // namespace
} // namespace fpm
