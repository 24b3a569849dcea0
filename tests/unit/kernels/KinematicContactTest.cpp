#include "kernels/contact/law/KinematicContact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace fpm {
namespace {

using Vector = Vec3<double>;

double length(const Vector& v)
{
    return std::sqrt(dot(v, v));
}

SurfaceShape plane(const Vector& point, const Vector& normal)
{
    SurfaceShape shape{};
    shape.kind = SurfaceShape::plane;
    shape.point = point;
    shape.axis = (1 / length(normal)) * normal;
    return shape;
}

SurfaceShape round(SurfaceShape::Kind kind, double radius, bool inside)
{
    SurfaceShape shape{};
    shape.kind = kind;
    shape.radius = radius;
    shape.inside = inside;
    shape.axis = {0, 0, 1};
    return shape;
}

/// One node and the surfaces it may meet.
struct Node {
    std::vector<KinematicPass> passes;
    std::vector<SurfaceUse> uses;
    std::vector<Index> start{0, 0};
    std::vector<double> lost = std::vector<double>(3 * 8), rows{0, 0};
    FreeDirections free{true, {}};
    Vector force{0, 0, 0};

    void add(const SurfaceShape& shape, double friction)
    {
        double* mine = &lost[3 * passes.size()];
        passes.push_back({.count = 1,
                          .shape = shape,
                          .friction = {friction, friction, 0, 1, false},
                          .push = 0.1,
                          .dissipated = mine,
                          .impact = mine + 1,
                          .work = mine + 2,
                          .reading = nullptr});
        uses.push_back({Index(uses.size()), 0});
        start[1] = Index(uses.size());
    }
    /// Increment of a step of length 1 and unit mass.
    Vector step(const Vector& place, const Vector& velocity, const Vector& predicted)
    {
        const KinematicContact contact{start.data(), uses.data(), passes.data(), rows.data()};
        SurfaceStep step{place, velocity, predicted, 0, 1, 1, 1, 1, free};
        force = contact.correct(0, step, SurfaceBooks::running);
        return step.increment;
    }
    double dissipated() const
    {
        double sum = 0;
        for (std::size_t i = 0; i < passes.size(); ++i) sum += lost[3 * i];
        return sum;
    }
    double impact() const
    {
        double sum = 0;
        for (std::size_t i = 0; i < passes.size(); ++i) sum += lost[3 * i + 1];
        return sum;
    }
    double worstDepth(const Vector& x) const
    {
        double worst = 0;
        for (const KinematicPass& pass : passes) worst = std::max(worst, -pass.shape.at(x).gap);
        return worst;
    }
};

/// A bead in a bowl: it stays on the surface to rounding and keeps its energy, as a pendulum does.
TEST(KinematicContact, BeadInABowlKeepsItsEnergy)
{
    for (const SurfaceShape::Kind kind : {SurfaceShape::sphere, SurfaceShape::cylinder}) {
        Node node;
        node.add(round(kind, 1, true), 0);
        const double g = 1e-5; // a swing takes some thousand steps
        const Vector down{0, -g, 0};
        Vector x{0.8, -0.6, 0}, v{0, 0, 1e-4};
        v = v - 0.5 * down; // half a step earlier
        double least = 1e300, most = -1e300, worst = 0;
        for (int n = 0; n < 20000; ++n) {
            const Vector u = node.step(x, v, v + down);
            // 1/2 m v^- . v^+ is the kinetic energy at the time of x.
            const double energy = 0.5 * dot(v, u) - dot(down, x);
            if (n > 0) {
                least = std::min(least, energy + node.impact());
                most = std::max(most, energy + node.impact());
            }
            v = u;
            x = x + u;
            worst = std::max(worst, std::abs(node.passes[0].shape.at(x).gap));
        }
        EXPECT_LT(worst, 1e-14);
        EXPECT_LT(most - least, 1e-3 * g); // of the energy of its height, 1 g
        EXPECT_LT(std::abs(node.impact()), 1e-3 * g);
    }
}

/// Nearest place to `predicted` outside all planes through the origin, by Hildreth's iteration.
Vector nearest(const std::vector<Vector>& normals, const Vector& predicted)
{
    Vector x = predicted;
    std::vector<double> factor(normals.size());
    for (int sweep = 0; sweep < 4000; ++sweep)
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const double change = std::max(-factor[i], -dot(normals[i], x));
            factor[i] += change;
            x += change * normals[i];
        }
    return x;
}

/// In corners of three planes at any angles the node ends at the nearest place to the predicted one
/// that is outside all of them: none is entered, none pulls.
TEST(KinematicContact, CornersOfThreePlanesTakeTheNearestPlace)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int trial = 0; trial < 300; ++trial) {
        Node node;
        std::vector<Vector> normals;
        for (int i = 0; i < 3; ++i) {
            node.add(plane({0, 0, 0}, {any(random), any(random), 1.2 + any(random)}), 0);
            normals.push_back(node.passes.back().shape.axis);
        }
        const Vector predicted{any(random), any(random), any(random)};
        const Vector x = node.step({0, 0, 0}, {0, 0, 0}, predicted);
        EXPECT_LT(node.worstDepth(x), 1e-13) << trial;
        EXPECT_LT(length(x - nearest(normals, predicted)), 1e-6) << trial;
    }
}

TEST(KinematicContact, FrictionHoldsUpToTheBoundAndIsSharedInACorner)
{
    Node floor;
    floor.add(plane({0, 0, 0}, {0, 0, 1}), 0.3);
    const Vector sticks = floor.step({0, 0, 0}, {0, 0, 0}, {0.2, -0.2, -1});
    EXPECT_LT(length(sticks), 1e-15);
    EXPECT_NEAR(floor.force.x, -0.2, 1e-15);
    const Vector slides = floor.step({0, 0, 0}, {0, 0, 0}, {0.8, -0.6, -1});
    EXPECT_NEAR(slides.x, 0.8 * 0.7, 1e-14);
    EXPECT_NEAR(slides.y, -0.6 * 0.7, 1e-14);

    Node corner;
    corner.add(plane({0, 0, 0}, {0, 0, 1}), 0.3);
    corner.add(plane({0, 0, 0}, {1, 0, 0}), 0.2);
    const Vector along = corner.step({0, 0, 0}, {0, 1, 0}, {-1, 1, -1});
    EXPECT_NEAR(along.y, 1 - 0.3 - 0.2, 1e-14);
    EXPECT_NEAR(corner.dissipated(), 0.5 * (1 + along.y) * 0.5, 1e-14);
}

/// Sticking on a round surface is rest, and sliding on it ends on it.
TEST(KinematicContact, FrictionOnARoundSurfaceEndsOnTheSurface)
{
    for (const bool inside : {false, true}) {
        Node node;
        node.add(round(SurfaceShape::sphere, 2, inside), 0.5);
        const Vector radial = Vector{0.6, 0, 0.8}, place = 2.0 * radial;
        const Vector into = (inside ? 0.1 : -0.1) * radial;
        const Vector rest = node.step(place, {0, 0, 0}, into + Vector{0, 0.04, 0});
        EXPECT_LT(length(rest), 1e-14);
        const Vector slides = node.step(place, {0, 0, 0}, into + Vector{0, 0.2, 0});
        EXPECT_LT(std::abs(node.passes[0].shape.at(place + slides).gap), 1e-14);
        EXPECT_GT(slides.y, 0.1);
        const Vector n = inside ? -radial : radial;
        const double press = dot(node.force, n);
        EXPECT_NEAR(length(node.force - press * n), 0.5 * press, 1e-12);
    }
}

/// A node that a support holds in one direction follows in the others only.
TEST(KinematicContact, MovesInFreeDirectionsOnly)
{
    Node node;
    node.add(plane({0, 0, 0}, {0, 0.6, 0.8}), 0);
    node.free = {false, {{1, 0, 0}, {0, 0, 0}, {0, 0, 1}}};
    const Vector u = node.step({0, 0, 0}, {0, 0, 0}, {0.1, 0, -1});
    EXPECT_NEAR(u.x, 0.1, 1e-15);
    EXPECT_EQ(u.y, 0);
    EXPECT_NEAR(u.z, 0, 1e-15);
    EXPECT_NEAR(node.force.z, 1, 1e-14);
    EXPECT_NEAR(node.force.y, 0.75, 1e-14); // the support bears it
    node.free = {false, {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
    const Vector held = node.step({0, 0, -0.1}, {0, 0, 0}, {0.1, 0, 0});
    EXPECT_EQ(held.x, 0.1);
    EXPECT_EQ(length(node.force), 0); // it cannot follow
}

/// What starts inside comes out by a bounded way in each step, and that is work, no impact.
TEST(KinematicContact, DeepNodesComeOutSlowly)
{
    Node node;
    node.add(plane({0, 0, 0}, {0, 0, 1}), 0);
    EXPECT_NEAR(node.step({0, 0, -0.05}, {0, 0, 0}, {0, 0, 0}).z, 0.05, 1e-15);
    EXPECT_NEAR(node.step({0, 0, -5}, {0, 0, 0}, {0, 0, -1}).z, 0.1, 1e-15);
    EXPECT_EQ(node.impact(), 0);
    EXPECT_GT(node.lost[2], 0);
}

/// What follows the closest point need not lie beside a cylinder that ends.
TEST(KinematicContact, ACylinderEndsAtItsEnds)
{
    for (const double along : {-0.1, 0.5}) {
        Node node;
        SurfaceShape die = round(SurfaceShape::cylinder, 1, false);
        die.bounded = true;
        die.length = 1;
        node.add(die, 0);
        const Vector u = node.step({1.01, 0, along}, {0, 0, 0}, {-0.05, 0, 0});
        EXPECT_NEAR(u.x, along < 0 ? -0.05 : -0.01, 1e-14);
    }
}

/// Impulse of an impact: m v / h, and half of m v^2 is lost in it whatever the phase.
TEST(KinematicContact, ImpactLosesTheEnergyOfTheNode)
{
    for (const double gap : {0.1, 0.5, 0.9}) {
        Node node;
        node.add(plane({0, 0, 0}, {0, 0, 1}), 0);
        Vector x{0, 0, gap}, v{0, 0, -1};
        double impulse = 0;
        for (int n = 0; n < 4; ++n) {
            const Vector u = node.step(x, v, v);
            impulse += node.force.z;
            v = u;
            x = x + u;
        }
        EXPECT_EQ(x.z, 0);
        EXPECT_NEAR(impulse, 1, 1e-14);
        EXPECT_NEAR(node.impact(), 0.5, 1e-14);
    }
}

} // namespace
} // namespace fpm
