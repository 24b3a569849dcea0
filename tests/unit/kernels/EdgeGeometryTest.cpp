#include "kernels/contact/edges/EdgeGeometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace fpm::test {
namespace {

using Vector = Vec3<double>;

/// Nodes of two wedges that meet edge on edge: a along x with its back up, b along y with its back
/// down, 0.02 inside; each node is moved by up to `spread`.
struct Wedges {
    std::array<Vector, 4> x; ///< a.start, a.end, b.start, b.end
    std::array<Vector, 4> far;

    Wedges(std::mt19937& random, double spread)
    {
        std::uniform_real_distribution<double> share(-spread, spread);
        const auto near = [&](double a, double b, double c) {
            return Vector{a + share(random), b + share(random), c + share(random)};
        };
        x = {near(-1, 0, 0), near(1, 0, 0), near(0, -1, -0.02), near(0, 1, -0.02)};
        far = {near(0, 2, -2), near(0, -2, -2), near(2, 0, 2), near(-2, 0, 2)};
    }
    EdgeSegment<double> a() const { return {x[0], x[1], far[0], far[1]}; }
    EdgeSegment<double> b() const { return {x[2], x[3], far[2], far[3]}; }
    EdgeCrossing<double> crossing() const { return {a(), b()}; }
};

double size(const Vector& v)
{
    return std::sqrt(dot(v, v));
}

TEST(EdgeGeometry, TheGapIsTheDistanceOfTheLinesWithTheSignOfTheWedges)
{
    std::mt19937 random(1);
    for (int k = 0; k < 1000; ++k) {
        const Wedges w(random, 0.1);
        const EdgeCrossing<double> at = w.crossing();
        const Vector apart = w.b().at(at.t) - w.a().at(at.s);
        EXPECT_NEAR(size(apart - at.gap * at.normal), 0, 1e-14);
        EXPECT_NEAR(dot(at.normal, w.a().along), 0, 1e-14);
        EXPECT_NEAR(dot(at.normal, w.b().along), 0, 1e-14);
        EXPECT_GT(at.normal.z, 0.8); // out of a, into b
    }
}

TEST(EdgeGeometry, ForcesHaveNeitherResultantNorMomentAndDoTheWorkOfGapAndSlip)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(-1, 1);
    for (int k = 0; k < 1000; ++k) {
        Wedges w(random, 0.1);
        const EdgeCrossing<double> at = w.crossing();
        const Vector friction =
            inPlane(Vector{share(random), share(random), share(random)}, at.normal);
        const double normalForce = 0.7;
        const EdgeForces<double> forces(w.a(), w.b(), at, normalForce, friction);
        Vector sum{0, 0, 0}, moment{0, 0, 0};
        for (std::size_t i = 0; i < 4; ++i) {
            sum += forces.node[i];
            moment += cross(w.x[i], forces.node[i]);
        }
        EXPECT_LT(size(sum), 1e-14);
        EXPECT_LT(size(moment), 1e-14);
        // Against central differences of gap and places for any motion of the four nodes.
        const double h = 1e-6;
        Wedges before = w, after = w;
        double work = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vector moved{share(random), share(random), share(random)};
            work += dot(forces.node[i], moved);
            before.x[i] = w.x[i] - h * moved;
            after.x[i] = w.x[i] + h * moved;
        }
        const EdgeCrossing<double> last = before.crossing(), next = after.crossing();
        const Vector slip = ((next.t - last.t) / (2 * h)) * w.b().along
                            - ((next.s - last.s) / (2 * h)) * w.a().along;
        const double expected = normalForce * (next.gap - last.gap) / (2 * h) + dot(friction, slip);
        EXPECT_NEAR(work, expected, 2e-9);
    }
}

TEST(EdgeGeometry, ACommonRotationIsNoSlip)
{
    std::mt19937 random(3);
    const Wedges w(random, 0.1);
    Wedges turned = w;
    const double c = std::cos(0.7), s = std::sin(0.7);
    for (auto* points : {&turned.x, &turned.far})
        for (Vector& p : *points) p = {c * p.x - s * p.y + 3, s * p.x + c * p.y, p.z - 1};
    const EdgeCrossing<double> before = w.crossing(), after = turned.crossing();
    EXPECT_NEAR(after.s, before.s, 1e-14);
    EXPECT_NEAR(after.t, before.t, 1e-14);
    EXPECT_NEAR(after.gap, before.gap, 1e-14);
    // The frame of friction turns with them.
    const EdgeFrame<double> old(w.a(), w.b(), before.normal),
        now(turned.a(), turned.b(), after.normal);
    const Vector stored = old.components(w.a().along), found = now.components(turned.a().along);
    EXPECT_NEAR(found.x, stored.x, 1e-14);
    EXPECT_NEAR(found.y, stored.y, 1e-14);
}

TEST(EdgeGeometry, TheRolesOfTheTwoEdgesAreAlike)
{
    std::mt19937 random(4);
    const Wedges w(random, 0.1);
    const EdgeCrossing<double> one = w.crossing(), other(w.b(), w.a());
    EXPECT_NEAR(other.s, one.t, 1e-14);
    EXPECT_NEAR(other.t, one.s, 1e-14);
    EXPECT_NEAR(other.gap, one.gap, 1e-14);
    EXPECT_NEAR(size(other.normal + one.normal), 0, 1e-14);
    const Vector friction = inPlane(Vector{0.3, -0.2, 0.1}, one.normal);
    const EdgeForces<double> first(w.a(), w.b(), one, 0.7, friction),
        second(w.b(), w.a(), other, 0.7, -friction);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(size(first.node[i] - second.node[(i + 2) % 4]), 0, 1e-14);
}

TEST(EdgeGeometry, TheMirrorImageHasTheMirrorImageOfTheForces)
{
    std::mt19937 random(5);
    const Wedges w(random, 0.1);
    Wedges image = w;
    const auto mirrored = [](const Vector& v) { return Vector{-v.x, v.y, v.z}; };
    for (std::size_t i = 0; i < 4; ++i) image.x[i] = mirrored(w.x[i]);
    // Its faces run the other way round: the left one is the image of the right one.
    for (std::size_t i = 0; i < 4; ++i) image.far[i] = mirrored(w.far[i ^ 1]);
    const EdgeCrossing<double> at = w.crossing(), there = image.crossing();
    EXPECT_NEAR(there.gap, at.gap, 1e-14);
    EXPECT_NEAR(there.cone, at.cone, 1e-14);
    EXPECT_NEAR(size(there.normal - mirrored(at.normal)), 0, 1e-14);
    const Vector friction = inPlane(Vector{0.3, -0.2, 0.1}, at.normal);
    const EdgeForces<double> forces(w.a(), w.b(), at, 0.7, friction),
        images(image.a(), image.b(), there, 0.7, mirrored(friction));
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(size(images.node[i] - mirrored(forces.node[i])), 0, 1e-14);
}

/// Edges at an angle, one 0.01 inside the other; `lean` turns the upper wedge about its edge.
EdgeCrossing<double> crossed(double angle, double lean)
{
    const double c = std::cos(angle), s = std::sin(angle), z = -0.01;
    const EdgeSegment<double> a({-1, 0, 0}, {1, 0, 0}, {0, 2, -2}, {0, -2, -2});
    const double left = 0.25 * 3.14159265358979324 - lean, right = 0.5 * 3.14159265358979324 - left;
    const auto far = [&](double side, double from) { // at an angle `from` from straight up
        return Vector{2 * side * s * std::sin(from), -2 * side * c * std::sin(from),
                      2 * z + 2 * std::cos(from)};
    };
    return {a, EdgeSegment<double>({-c, -s, z}, {c, s, z}, far(1, left), far(-1, right))};
}

TEST(EdgeGeometry, PairsCloseWithinTheConesOfBothWedgesAndNotAlmostParallel)
{
    const double degree = 3.14159265358979324 / 180;
    EXPECT_TRUE(crossed(90 * degree, 0).mayClose());
    EXPECT_TRUE(crossed(11 * degree, 0).mayClose());
    EXPECT_FALSE(crossed(9 * degree, 0).mayClose());
    EXPECT_TRUE(crossed(9 * degree, 0).mayHold());
    EXPECT_FALSE(crossed(4 * degree, 0).mayHold());
    // The faces lie at 45 degrees to the normal: at 45 degrees of lean one lies flat on the edge.
    for (const double sign : {-1.0, 1.0}) {
        EXPECT_NEAR(crossed(90 * degree, sign * 45 * degree).cone, 0, 1e-12);
        EXPECT_TRUE(crossed(90 * degree, sign * 45 * degree).mayClose());
        EXPECT_FALSE(crossed(90 * degree, sign * 49 * degree).mayClose());
        EXPECT_TRUE(crossed(90 * degree, sign * 60 * degree).mayHold());
        EXPECT_FALSE(crossed(90 * degree, sign * 80 * degree).mayHold());
    }
}

TEST(EdgeGeometry, AtAJointOneOfTheTwoSegmentsHasTheCrossing)
{
    const EdgeSegment<double> b({0, -1, 0}, {0, 1, 0}, {2, 0, 2}, {-2, 0, 2});
    for (const double joint : {-1e-3, 0.0, 1e-3}) {
        const EdgeSegment<double> first({joint - 1, 0, 0}, {joint, 0, 0}, {0, 2, -2}, {0, -2, -2}),
            second({joint, 0, 0}, {joint + 1, 0, 0}, {0, 2, -2}, {0, -2, -2});
        EXPECT_NE(EdgeCrossing<double>(first, b).isInner(),
                  EdgeCrossing<double>(second, b).isInner());
    }
}

TEST(EdgeGeometry, SegmentDistances)
{
    const auto at = [](Vector from, Vector to) {
        return EdgeSegment<double>(from, to, {0, 0, 0}, {0, 0, 0});
    };
    const EdgeSegment<double> a = at({0, 0, 0}, {1, 0, 0});
    EXPECT_NEAR(distanceSquare(a, at({0.5, -1, 0.2}, {0.5, 1, 0.2})), 0.04, 1e-15);
    EXPECT_NEAR(distanceSquare(a, at({2, 1, 0}, {2, 2, 0})), 2, 1e-15); // ends
    EXPECT_NEAR(distanceSquare(a, at({0.3, 0.1, 0}, {0.3, 2, 0})), 0.01, 1e-15);
    EXPECT_NEAR(distanceSquare(a, at({0.2, 0.3, 0}, {0.9, 0.3, 0})), 0.09, 1e-15); // parallel
    EXPECT_NEAR(distanceSquare(a, at({-2, 0.3, 0}, {-1, 0.3, 0})), 1.09, 1e-15);
}

} // namespace
} // namespace fpm::test
