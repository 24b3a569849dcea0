#include "unit/kernels/oneContactor.h"
#include "unit/kernels/rotated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fpm {
namespace {

using namespace test;

/// Plane faces that fall to the edge x = 2 between them, and a contactor half a unit below it.
std::vector<V> valley()
{
    return {{2, 0.8, -0.5}, {0, 0, 0.4}, {2, 0, 0},  {4, 0, 0.4},
            {0, 2, 0.4},    {2, 2, 0},   {4, 2, 0.4}};
}
void expectEqual(const OneContactor& a, const OneContactor& b)
{
    EXPECT_GT(size(a.force(0)), 0);
    EXPECT_DOUBLE_EQ(a.springEnergy(), b.springEnergy());
    for (std::size_t i = 0; i < a.nodes().size(); ++i)
        EXPECT_LT(size(a.force(i) - b.force(i)), 1e-9) << "node " << i;
}

TEST(ContactPoint, UnequalStiffnessAtACommonEdgeIsThatOfBoth)
{
    for (const double mu : {0.0, 0.3}) {
        const Setting setting{.faceStiffness = {60, 140}};
        OneContactor a(mu, valley(), 0, twoFaces(), setting),
            b(mu, valley(), 1, twoFaces(), setting);
        ASSERT_TRUE(a.onBorder() && b.onBorder() && a.face() != b.face());
        expectEqual(a, b);
        EXPECT_NEAR(size(a.force(0)), 100 * 0.5, 1e-9); // each carries half of its own spring
    }
}

TEST(ContactPoint, WhoIsDeeperThanOneOfThemIsThickIsHeldByTheOther)
{
    const Setting setting{.faceThickness = {0.3f, 3}}, thin{.faceThickness = {0.3f, 0.4f}};
    OneContactor a(0.3, valley(), 0, twoFaces(), setting), b(0.3, valley(), 1, twoFaces(), setting);
    expectEqual(a, b);
    for (const Index face : {0, 1})
        EXPECT_EQ(OneContactor(0.3, valley(), face, twoFaces(), thin).face(), releasedFace);
}

TEST(ContactPoint, ContactDampingHasTheLeastMassOfAllOfThem)
{
    const std::vector<V> in{{0, 0, -1e-3}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
                            {0, 0, 0},     {0, 0, 0}, {0, 0, 0}};
    const auto pressed = [&](Index face, std::vector<double> masses) {
        OneContactor pair(0.3, valley(), face, twoFaces(),
                          {.faceMass = std::move(masses), .contactorMass = 1, .damping = 0.2});
        pair.move(in);
        return size(pair.force(0));
    };
    const double elastic = normalStiffness * 0.501;
    const double rate = 1e-3 / step, damped = 2 * 0.2 * std::sqrt(normalStiffness * 0.04) * rate;
    for (const Index face : {0, 1}) {
        EXPECT_NEAR(pressed(face, {0.04, 0.5}), elastic + damped, 1e-9);
        EXPECT_NEAR(pressed(face, {0.04, 0}), elastic + damped, 1e-9); // 0: held, no mass to move
    }
}

/// The normal of face 0 does not oppose the contactor's, that of face 1 does.
TEST(ContactPoint, OneThatDoesNotOpposeIsNoPartnerWhicheverIsTracked)
{
    const V ownNormal{std::sin(1.4), 0, -std::cos(1.4)};
    for (const double mu : {0.0, 0.3}) {
        OneContactor a(mu, valley(), 0, twoFaces(), {.ownNormal = ownNormal}),
            b(mu, valley(), 1, twoFaces(), {.ownNormal = ownNormal});
        ASSERT_TRUE(a.onBorder() && b.onBorder());
        EXPECT_EQ(a.face(), 1);
        EXPECT_EQ(b.face(), 1);
        expectEqual(a, b);
    }
}

/// For a contactor the surface ends where the next face does not oppose it, just as at a free edge:
/// the displacement beyond the end counts in both cases.
TEST(ContactPoint, ASurfaceThatTurnsAwayEndsAsOneThatHasAnEdge)
{
    // Face 1 hangs down from the edge x = 2 and a little back.
    const std::vector<V> nodes{{1.9, 0.8, -0.3}, {0, 0, 0}, {2, 0, 0},   {1.9, 0, -2},
                               {0, 2, 0},        {2, 2, 0}, {1.9, 2, -2}};
    const Faces alone{{1, 2, 5, 4}, {0, 1, 2, 3}, {freeEdge, freeEdge, freeEdge, freeEdge}};
    const Setting setting{.ownNormal = {0, 0, -1}};
    OneContactor turns(10, nodes, 0, twoFaces(), setting), ends(10, nodes, 0, alone, setting);
    std::vector<V> way(nodes.size(), V{0, 0, 0});
    for (const double sign : {1.0, -1.0}) {
        way[0] = {sign * 0.01, 0.002, 0};
        for (int n = 0; n < 25; ++n) { // to x = 2.15 and back
            turns.move(way);
            ends.move(way);
            ASSERT_EQ(turns.face(), 0);
            for (std::size_t i = 0; i < nodes.size(); ++i)
                ASSERT_LT(size(turns.force(i) - ends.force(i)), 1e-9) << "step " << n;
        }
    }
    EXPECT_GT(turns.held(), 0);
}

/// Two bytes a component: off by half a part of ownNormalScale in each.
TEST(OwnNormal, InTwoBytesAComponentKeepsItsDirection)
{
    OneContactor pair(0.3, valley());
    const auto view = pair.view();
    std::mt19937 random(3);
    std::normal_distribution<double> any(0, 1);
    const double bound = std::sqrt(3.0) * 0.5 / ownNormalScale;
    double most = 0;
    for (int n = 0; n < 100000; ++n) {
        V normal{any(random), any(random), any(random)};
        if (n < 6)
            normal = {n == 0   ? 1.0
                      : n == 1 ? -1.0
                               : 0,
                      n == 2   ? 1.0
                      : n == 3 ? -1.0
                               : 0,
                      n == 4   ? 1.0
                      : n == 5 ? -1.0
                               : 0};
        normal = (1 / size(normal)) * normal;
        view.setOwnNormal(0, normal);
        most = std::max(most, size(view.ownNormalOf(0) - normal));
        if (n < 6) {
            EXPECT_EQ(most, 0);
        }
    }
    EXPECT_LT(most, 1.001 * bound);
    EXPECT_GT(most, 0.8 * bound);
    view.setOwnNormal(0, {0, 0, 0});
    EXPECT_EQ(size(view.ownNormalOf(0)), 0);
}

} // namespace
} // namespace fpm
