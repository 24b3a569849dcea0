#include "kernels/particle/RigidBody.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace fpm;

namespace {

using Vec = Vec3<double>;

/// Steel brick 0.3 x 0.2 x 0.1 m: m = 47.1 kg, I = (0.19625, 0.39250, 0.51025) kg m^2.
RigidBody brick()
{
    RigidBody body{};
    body.mass = 47.1;
    body.inertia = {{0.19625, 0, 0}, {0, 0.39250, 0}, {0, 0, 0.51025}};
    body.inverseInertia = {{1 / 0.19625, 0, 0}, {0, 1 / 0.39250, 0}, {0, 0, 1 / 0.51025}};
    body.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    body.turns = 3;
    body.q[3] = 1;
    return body;
}

Vec localSpin(const RigidBody& body)
{
    return transpose(rotationOf(body.q)) * spinOf(body, body.momentum);
}
double energy(const RigidBody& body)
{
    return 0.5 * dot(body.momentum, spinOf(body, body.momentum));
}

struct Flight {
    std::vector<double> flips; ///< zeros of the local omega_y
    double energyDrift = 0, momentumDrift = 0, largestX = 0, largestZ = 0, lengthError = 0;
};

Flight fly(RigidBody body, double dt, double end)
{
    Flight out;
    StepClock clock;
    clock.step = clock.mean = dt;
    const BodyStep step{&body, 0, &clock};
    const double start = energy(body);
    const Vec momentum = body.momentum;
    double before = localSpin(body).y;
    for (int n = 1; n <= int(std::lround(end / dt)); ++n) {
        step(0);
        const Vec spin = localSpin(body);
        if (spin.y * before < 0) out.flips.push_back((n - 1 + before / (before - spin.y)) * dt);
        before = spin.y;
        out.energyDrift = std::max(out.energyDrift, std::abs(energy(body) / start - 1));
        out.largestX = std::max(out.largestX, std::abs(spin.x));
        out.largestZ = std::max(out.largestZ, std::abs(spin.z));
    }
    const Vec change = body.momentum - momentum;
    out.momentumDrift = std::sqrt(dot(change, change) / dot(momentum, momentum));
    const auto& q = body.q;
    out.lengthError = std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1);
    return out;
}

} // namespace

/// Exact times by elliptic functions; the intermediate axis is unstable.
TEST(RigidBody, TorqueFreeBrickFlipsAboutItsIntermediateAxis)
{
    RigidBody body = brick();
    body.momentum = body.inertia * Vec{0.1, 100, 0.1};
    EXPECT_NEAR(energy(body), 1962.5035, 1e-4);
    const Flight flight = fly(body, 1e-5, 1.0);
    ASSERT_EQ(flight.flips.size(), 3u);
    const double exact[3] = {0.19860, 0.54999, 0.90138};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(flight.flips[i], exact[i], 2e-4 * exact[i]);
    EXPECT_NEAR(flight.largestX, 86.603, 0.01);
    EXPECT_NEAR(flight.largestZ, 69.338, 0.01);
    EXPECT_LT(flight.energyDrift, 1e-11);
    EXPECT_EQ(flight.momentumDrift, 0);
    EXPECT_LT(flight.lengthError, 1e-14);
}

/// Energy is kept whatever the step; the error of the path falls with its square.
TEST(RigidBody, PathIsOfSecondOrderAndEnergyIsKeptInLargeSteps)
{
    RigidBody body = brick();
    body.momentum = body.inertia * Vec{20, 60, 30};
    const double exact = fly(body, 1e-6, 0.25).flips.front();
    const Flight coarse = fly(body, 2e-3, 0.25), fine = fly(body, 1e-3, 0.25);
    EXPECT_LT(coarse.energyDrift, 1e-12);
    EXPECT_NEAR((coarse.flips.front() - exact) / (fine.flips.front() - exact), 4, 0.4);
}

TEST(RigidBody, AMomentGivesTheAngularMomentumItsImpulse)
{
    RigidBody body = brick();
    body.contact.moment = {0.3, -0.2, 0.5};
    body.outer.force = {47.1, 0, -471};
    StepClock clock;
    clock.step = clock.mean = 1e-3;
    const BodyStep step{&body, 0, &clock};
    for (int n = 0; n < 100; ++n) step(0);
    EXPECT_NEAR(body.momentum.x, 0.03, 1e-15);
    EXPECT_NEAR(body.momentum.z, 0.05, 1e-15);
    EXPECT_NEAR(body.velocity.z, -1, 1e-14);
    // The works are the kinetic energy, but for the open half of the last step.
    double work = 0;
    for (const NodeWork k : {contactBefore, contactAfter, externalBefore, externalAfter})
        work += body.work[k];
    EXPECT_NEAR(work, energy(body) + 0.5 * 47.1 * dot(body.velocity, body.velocity), 1e-12);
}

TEST(RigidBody, HeldTurnsLeaveOneAxisOrNone)
{
    RigidBody body = brick();
    body.inertia.x.y = body.inertia.y.x = 0.05; // the axis is no principal one
    body.turns = 1;
    body.axis = {0, 1, 0};
    body.axisInertia = 0.39250;
    body.contact.moment = {5, 0.3925, -4};
    StepClock clock;
    clock.step = clock.mean = 1e-3;
    const BodyStep step{&body, 0, &clock};
    for (int n = 0; n < 100; ++n) step(0);
    const Vec spin = spinOf(body, body.momentum);
    EXPECT_EQ(spin.x, 0);
    EXPECT_EQ(spin.z, 0);
    EXPECT_NEAR(spin.y, 0.1, 1e-15);
    body.turns = 0;
    for (int n = 0; n < 100; ++n) step(0);
    EXPECT_EQ(body.momentum.y, 0);
}

TEST(RigidBody, HeldTranslationsStayInAnyDirection)
{
    RigidBody body = brick();
    body.axes = {{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}};
    body.held = 1;
    body.outer.force = {47.1, 0, 47.1};
    StepClock clock;
    clock.step = clock.mean = 1e-3;
    const BodyStep step{&body, 0, &clock};
    for (int n = 0; n < 100; ++n) step(0);
    EXPECT_NEAR(body.velocity.x, 0.64 * 0.1, 1e-15);
    EXPECT_NEAR(body.velocity.y, -0.48 * 0.1, 1e-15);
    EXPECT_NEAR(0.6 * body.centre.x + 0.8 * body.centre.y, 0, 1e-15);
}
