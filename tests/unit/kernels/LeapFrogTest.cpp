#include "kernels/particle/LeapFrog.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fpm;

TEST(LeapFrog, EqualsTheTwoStepRecursionOfThePaper)
{
    // d^(n+1) = c1 dt^2/m F^n + 2 c1 d^n - c2 d^(n-1) of a damped oscillator, in long double
    // because the recursion loses digits that the leapfrog keeps.
    const double mass = 2, stiffness = 50, dt = 0.03, xi = 0.4;
    const long double c1 = 1 / (1 + 0.5L * xi * dt), c2 = c1 * (1 - 0.5L * xi * dt);
    double x = 1, v = 0.5;
    long double now = x, before = static_cast<long double>(x) - dt * static_cast<long double>(v);
    for (int n = 0; n < 1000; ++n) {
        v = leapFrogVelocity(v, -stiffness * x, 1 / mass, dt, xi);
        x += dt * v;
        const long double next =
            c1 * dt * dt / mass * (-stiffness * now) + 2 * c1 * now - c2 * before;
        before = now;
        now = next;
        ASSERT_NEAR(x, double(now), 1e-12) << "step " << n;
    }
}

TEST(LeapFrog, WithoutDampingConservesItsEnergy)
{
    const double stiffness = 4, dt = 0.1;
    double x = 1, v = stiffness * dt / 2; // at rest at the first position
    const double start = stiffness * x * x / 2;
    for (int n = 0; n < 100000; ++n) {
        const double before = v;
        v = leapFrogVelocity(v, -stiffness * x, 1.0, dt, 0.0);
        // 1/2 m v^(n-1/2) v^(n+1/2) + 1/2 k x^2 is constant.
        const double energy = before * v / 2 + stiffness * x * x / 2;
        ASSERT_NEAR(energy, start * (1 - stiffness * dt * dt / 4), 1e-10 * start);
        x += dt * v;
    }
}

TEST(LeapFrog, HeavyDampingDoesNotOvershoot)
{
    double v = 1;
    for (int n = 0; n < 10; ++n) {
        const double next = leapFrogVelocity(v, 0.0, 1.0, 0.1, 1e4);
        EXPECT_LT(std::abs(next), std::abs(v));
        v = next;
    }
}
