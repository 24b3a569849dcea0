#include "kernels/contact/law/Friction.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fpm {
namespace {

using V = Vec3<double>;

/// A contactor of mass 1 on springs of stiffness 100 under the normal force 10, friction 0.3.
class Slider
{
public:
    explicit Slider(double step) : step_(step) {}
    /// Friction, along x, of a step at slip rate v.
    double at(double v)
    {
        const V slip{step_ * v, 0, 0}, before = force_;
        force_ =
            frictionForce(FrictionLaw<double>{0.3, 0.3, 0, 0.8, false}, force_, slip, 80.0, 10.0,
                          step_, lost_, damping_.resistance(0, std::abs(slip.x), 100, 1, step_));
        work_ -= 0.5 * dot(before + force_, slip);
        return force_.x;
    }
    double stored() const { return dot(force_, force_) / 160; }
    double lost() const { return lost_; }
    double work() const { return work_; }

private:
    double step_, mean_ = 0, lost_ = 0, work_ = 0;
    SlipDamping<double> damping_{0.2, &mean_};
    V force_{0, 0, 0};
};

TEST(SlipDamping, LeavesSteadyAndBrakingSlipToCoulomb)
{
    Slider slider(0.01);
    double v = 20;
    for (int n = 0; n < 3000; ++n) {
        const double force = slider.at(v);
        if (n > 10) {
            ASSERT_DOUBLE_EQ(force, -3) << n;
        }
        v *= 1 - 2e-4; // within `steady` of the mean of so short a time
    }
}

TEST(SlipDamping, ResistsFluctuationsWithoutAMean)
{
    for (const double step : {0.002, 0.02}) { // below and above the time of the mean
        Slider slider(step);
        double fast = 0, sum = 0;
        const int turns = 50, steps = int(2 * M_PI / 5 / step);
        for (int n = 0; n < 20 * steps; ++n) slider.at(20);
        for (int n = 0; n < turns * steps; ++n) {
            const double phase = 2 * M_PI * n / steps;
            const double force = slider.at(20 + 2 * std::sin(phase));
            sum += force;
            fast += (force + 3) * std::sin(phase); // takes energy from the fluctuation
        }
        EXPECT_LT(fast / (turns * steps), -1e-4) << step;
        EXPECT_NEAR(sum / (turns * steps), -3, 1e-3) << step;
    }
}

TEST(SlipDamping, StaysBetweenNoneAndTwiceCoulombAndAddsUp)
{
    Slider slider(0.02);
    for (int n = 0; n < 4000; ++n) {
        const double force = slider.at(30 * std::sin(0.37 * n) + 20 * std::cos(1.9 * n));
        EXPECT_LE(std::abs(force), 6 * (1 + 1e-15));
    }
    EXPECT_GT(slider.lost(), 0);
    EXPECT_NEAR(slider.work(), slider.stored() + slider.lost(), 1e-12 * slider.lost());
}

TEST(SlipDamping, AContactorThatCannotMoveHasNone)
{
    double mean = 0;
    const SlipDamping<double> damping{0.2, &mean};
    for (const double slip : {0.1, 0.5, 0.2}) {
        EXPECT_EQ(damping.resistance(0, slip, 100, 0, 0.01), 0);
        EXPECT_EQ(damping.resistance(0, slip, 0, 1, 0.01), 0);
    }
    EXPECT_EQ(mean, 0);
}

} // namespace
} // namespace fpm
