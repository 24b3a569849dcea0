#include "kernels/contact/law/RigidSurface.h"
#include "unit/kernels/rotated.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace fpm {
namespace {

using V = Vec3<double>;
using test::rotated;
using test::size;

FrictionLaw<double> law(double mu)
{
    return {mu, mu, 0, 0.1, false};
}
TEST(Friction, FallsFromStaticToDynamicWithTheSpeedOfTheSlip)
{
    const FrictionLaw<double> slow{0.4, 0.3, 2.0, 0.1, false};
    const double step = 1e-3;
    EXPECT_NEAR(slow.coefficient(0, step), 0.4, 1e-15);
    EXPECT_NEAR(slow.coefficient(1.5 * step, step), 0.3 + 0.1 * std::exp(-3.0), 1e-14);
    EXPECT_NEAR(slow.coefficient(1, step), 0.3, 1e-15);
    EXPECT_EQ(law(0.4).coefficient(1, step), 0.4);
}

TEST(Friction, IsASpringUpToItsCapAndThenSlides)
{
    double lost = 0;
    const double k = 50, normal = 10, mu = 0.3;
    V force{0, 0, 0};
    force = frictionForce(law(mu), force, {0.04, 0, 0}, k, normal, 1.0, lost); // sticks
    EXPECT_NEAR(force.x, -2, 1e-14);
    EXPECT_EQ(lost, 0);
    force = frictionForce(law(mu), force, {0.04, 0, 0}, k, normal, 1.0, lost); // would be 4
    EXPECT_NEAR(force.x, -3, 1e-14);
    // Nodes' work (2 + 3) / 2 * 0.04 less what the spring gained, (9 - 4) / 100.
    EXPECT_NEAR(lost, 2.5 * 0.04 - 5 / 100.0, 1e-14);
}

TEST(Friction, GivesNothingBackOverACycle)
{
    // Cyclic shear under an oscillating normal force, in and out of phase: the work taken from the
    // nodes is what the spring holds and what is lost, and the loss never falls.
    for (const double phase : {0.0, 0.7, 1.57, 3.0}) {
        double lost = 0, work = 0, last = 0;
        V force{0, 0, 0};
        const double k = 40;
        for (int n = 1; n <= 20000; ++n) {
            const double t = 2 * M_PI * n / 500.0, before = 2 * M_PI * (n - 1) / 500.0;
            const V way{0.5 * (std::sin(t) - std::sin(before)),
                        0.2 * (std::cos(2 * t) - std::cos(2 * before)), 0};
            const double normal = 10 * (1 + 0.9 * std::sin(1.3 * t + phase));
            const V old = force;
            force = frictionForce(law(0.3), force, way, k, normal, 1.0, lost);
            work -= 0.5 * dot(old + force, way);
            EXPECT_GE(lost, last - 1e-12) << "step " << n;
            last = lost;
        }
        EXPECT_GT(lost, 1);
        EXPECT_NEAR(work, lost + dot(force, force) / (2 * k), 1e-9 * work);
    }
}

/// Turning points (and the position at the end) of a mass on a spring with friction: m x'' = load -
/// k x + F.
std::vector<double>
turningPoints(double mass, double k, double load, double mu, double normal, double x, double end)
{
    std::vector<double> out;
    V force{0, 0, 0};
    double v = 0, lost = 0;
    const double kt = 1e4 * k, dt = 0.1 / std::sqrt(kt / mass);
    for (double t = 0; t < end; t += dt) {
        const double before = v;
        v += dt * (load - k * x + force.x) / mass;
        if (v * before < 0) out.push_back(x);
        x += dt * v;
        force = frictionForce(law(mu), force, {dt * v, 0, 0}, kt, normal, dt, lost);
    }
    out.push_back(x);
    return out;
}

TEST(Friction, MassOnASpringLosesTheSameAmplitudeEachHalfCycleAndSticks)
{
    // Each half cycle takes 2 mu m g / k = 0.3924 mm; it sticks in the 13th at 0.1012 mm.
    const auto x = turningPoints(1, 1e4, 0, 0.2, 9.81, 5e-3, 0.6);
    double exact = 5e-3;
    for (std::size_t n = 0; n < 12; ++n) {
        exact = -(exact > 0 ? exact - 0.3924e-3 : exact + 0.3924e-3);
        EXPECT_NEAR(x[n], exact, 2e-6) << "half cycle " << n;
    }
    EXPECT_NEAR(std::abs(x.back()), 0.1012e-3, 2e-6);
}

TEST(Friction, PadOnASpringTurnsAndSticksWhereTheLawSays)
{
    const auto x = turningPoints(7000, 24e3, 200e3, 0.3, 70e3, 0, 12);
    const double exact[] = {14.9167, 3.5, 11.4167, 7.0};
    for (std::size_t n = 0; n < 4; ++n) EXPECT_NEAR(x[n], exact[n], 0.005 * exact[n]);
    EXPECT_NEAR(x.back(), 7.9167, 0.005 * 7.9167);
}

TEST(Friction, SlidesAlikeInEveryDirection)
{
    for (const double angle : {0.0, 0.3, M_PI / 4, 1.1, 2.5, 4.0}) {
        double lost = 0;
        V force{0, 0, 0};
        const V d{std::cos(angle), std::sin(angle), 0};
        for (int n = 0; n < 30; ++n)
            force = frictionForce(law(0.25), force, 0.02 * d, 40.0, 8.0, 1.0, lost);
        EXPECT_NEAR(size(force), 2, 1e-13);
        EXPECT_NEAR(dot(force, d), -2, 1e-13);
        EXPECT_NEAR(lost, 2 * (30 * 0.02 - 2 / 40.0), 0.4 * 0.02); // a part of one step
    }
}

/// A warped face and a point above it.
struct Scene {
    std::array<V, 4> corner{V{0, 0, 0}, V{2, 0.1, 0.05}, V{2.1, 1.8, -0.1}, V{-0.1, 2, 0.1}};
    V contactor{0.8, 1.3, -0.05};

    FaceCorners<double> face(const V& axis, double angle, V shift = {0, 0, 0}) const
    {
        FaceCorners<double> out;
        const V at = rotated(contactor, axis, angle) + shift;
        for (int k = 0; k < 4; ++k) out.corner[k] = rotated(corner[k], axis, angle) + shift - at;
        return out;
    }
};

TEST(Friction, FramesTurnWithTheirFace)
{
    const Scene scene;
    const V axis{0.3, -1, 0.5}, stored{3, -4, 2};
    const FaceCorners<double> start = scene.face(axis, 0);
    const V first = vectorIn(FaceFrame<double>(start), stored),
            there = vectorIn(PointFrame<double>(start, 0.3, -0.6), stored);
    EXPECT_LT(size(componentsIn(FaceFrame<double>(start), first) - stored), 1e-14);
    for (double angle = 0.1; angle < 6.3; angle += 0.1) {
        const FaceCorners<double> face = scene.face(axis, angle);
        EXPECT_LT(size(vectorIn(FaceFrame<double>(face), stored) - rotated(first, axis, angle)),
                  1e-12);
        EXPECT_LT(size(vectorIn(PointFrame<double>(face, 0.3, -0.6), stored)
                       - rotated(there, axis, angle)),
                  1e-12);
    }
}

TEST(Friction, ForceKeepsItsLengthInAnotherPlane)
{
    // A force along the fold between two planes stays as it is, one across it turns by the angle.
    const double angle = 0.5, c = std::cos(angle), s = std::sin(angle);
    const V normal{s, 0, c};
    EXPECT_LT(size(intoPlane(V{0, 2, 0}, normal) - V{0, 2, 0}), 1e-15);
    EXPECT_LT(size(intoPlane(V{2, 0, 0}, normal) - V{2 * c, 0, -2 * s}), 1e-14);
    EXPECT_EQ(size(intoPlane(V{0, 0, 0}, normal)), 0);
}

TEST(Penalty, TakesTheSideAsked)
{
    const double own[] = {2.0, 0.0};
    PassLaw<double> pair{};
    EXPECT_EQ(pair.stiffness(0, 3.0), 3);
    pair.contactorStiffness = own;
    EXPECT_EQ(pair.stiffness(0, 3.0), 3);
    EXPECT_EQ(pair.stiffness(0, 0.0), 2); // rigid face
    pair.rule = PenaltyRules::indexOf<LesserPenalty>();
    EXPECT_EQ(pair.stiffness(0, 3.0), 2);
    EXPECT_EQ(pair.stiffness(0, 1.0), 1);
    EXPECT_EQ(pair.stiffness(1, 3.0), 3); // rigid contactor
    pair.rule = PenaltyRules::indexOf<SeriesPenalty>();
    EXPECT_NEAR(pair.stiffness(0, 3.0), 6 / 5.0, 1e-15);
    EXPECT_EQ(pair.stiffness(0, 0.0), 2);

    pair.contactorMass = own;
    EXPECT_EQ(pair.lesserMass(0, 3.0), 2);
    EXPECT_EQ(pair.lesserMass(0, 1.0), 1);
    EXPECT_EQ(pair.lesserMass(0, 0.0), 2); // a face that cannot move
    EXPECT_EQ(pair.lesserMass(1, 3.0), 3); // a contactor that cannot
    EXPECT_EQ(pair.lesserMass(1, 0.0), 0);
}

TEST(ContactDamping, ReboundOfAMassIsThatOfTheDampedSpring)
{
    // Half a period of a damped oscillator: e = exp(-zeta pi / sqrt(1 - zeta^2)) where the spring
    // may pull; it may not, and separates a little faster.
    for (const double zeta : {0.05, 0.2}) {
        double force = 0, damped = 0;
        PassLaw<double> pair{};
        pair.dampingRatio = zeta;
        pair.dampingForce = &force;
        pair.damped = &damped;
        const double k = 100, mass = 4, omega = 5, dt = 1e-4 / omega;
        double x = 0, v = -1;
        double lowest = 0;
        do {
            x += dt * v;
            lowest = std::min(lowest, x);
            const double f = x < 0 ? pair.normalForce(0, k, x, mass, dt * v, dt) : 0;
            EXPECT_GE(f, 0);
            v += dt * f / mass;
        } while (x < 0);
        pair.bookDamping(0, 0, dt * v);
        const double exact = std::exp(-M_PI * zeta / std::sqrt(1 - zeta * zeta));
        // The force of the free oscillator is 0 at phase pi - 2 asin(zeta), before it pulls.
        const double phi =
            M_PI - std::atan2(2 * zeta * std::sqrt(1 - zeta * zeta), 1 - 2 * zeta * zeta);
        const double separated = std::exp(-zeta * phi / std::sqrt(1 - zeta * zeta));
        EXPECT_GT(v, exact);
        EXPECT_NEAR(v, separated, 1e-3) << zeta;
        EXPECT_NEAR(damped, 0.5 * mass * (1 - v * v), 2e-4 * mass);
    }
}

TEST(SurfaceShape, GapAndNormalAreExact)
{
    SurfaceShape s{};
    s.kind = SurfaceShape::cylinder;
    s.bounded = true;
    s.point = {0, -10, 0};
    s.axis = {0, 1, 0};
    s.length = 20;
    s.radius = 5;
    const SurfacePoint out = s.at({3, 1, 4.8});
    EXPECT_NEAR(out.gap, std::hypot(3, 4.8) - 5, 1e-14);
    EXPECT_NEAR(out.normal.x, 3 / std::hypot(3, 4.8), 1e-15);
    EXPECT_TRUE(out.opposite);
    EXPECT_FALSE(s.at({3, 10.1, 4}).opposite);
    EXPECT_FALSE(s.at({0, 0, 0}).opposite);
    s.bounded = false;
    EXPECT_TRUE(s.at({3, 10.1, 4}).opposite);
    s.inside = true;
    EXPECT_NEAR(s.at({0, 1, 4}).gap, 1, 1e-15);
    EXPECT_NEAR(s.at({0, 1, 4}).normal.z, -1, 1e-15);

    s.kind = SurfaceShape::sphere;
    s.inside = false;
    s.point = {1, 1, 1};
    EXPECT_NEAR(s.at({1 + 2, 1 + 3, 1 + 6}).gap, 2, 1e-14);
    s.kind = SurfaceShape::plane;
    s.axis = {0, 0, -1};
    EXPECT_NEAR(s.at({7, 8, 3}).gap, -2, 1e-15);
}

TEST(SurfaceShape, TravelOfAVelocityIsTheIntegralOfItsAmplitude)
{
    const double rows[] = {0.1, 0.0, 0.3, 2.0, 0.4, -1.0};
    for (const int smooth : {0, 1}) {
        Condition c{};
        c.kind = ConditionKind::velocity;
        c.smooth = smooth;
        c.rowCount = 3;
        double sum = 0;
        const double dt = 1e-5;
        for (int n = 0; n < 60000; ++n) {
            if (n % 7919 == 0) {
                EXPECT_NEAR(travelAt(c, rows, n * dt), sum, 1e-8);
            }
            sum += dt * amplitudeAt(c, rows, (n + 0.5) * dt);
        }
        EXPECT_NEAR(travelAt(c, rows, 0.6), sum, 1e-8);
        EXPECT_EQ(travelAt(c, rows, 0), 0);
    }
}

} // namespace
} // namespace fpm
