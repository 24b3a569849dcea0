#include "unit/kernels/oneContactor.h"
#include "unit/kernels/rotated.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace fpm {
namespace {

using namespace test;

/// Skew, warped faces with a valley between them, and a contactor below.
std::vector<V> warped(const V& contactor)
{
    return {contactor,       {0, 0, 0.1},      {2, 0.1, 0.05}, {4.1, -0.2, 0.5},
            {-0.3, 2, 0.25}, {2.1, 1.8, -0.2}, {3.9, 2.2, 0.6}};
}
const std::vector<V> insidePlaces{{0.5, 1.3, -0.2}, {1.2, 0.4, -0.3}, {3.1, 1.2, -0.1}};
const V inValley{2.02, 1.1, -0.4}, beyondTheRim{0.8, -0.05, -0.3};

std::vector<V> noise(unsigned seed, double most)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-most, most);
    std::vector<V> out(7);
    for (V& v : out) v = {any(random), any(random), any(random)};
    return out;
}
/// Work of the forces of the pair, trapezoidal, while its nodes move; those of friction alone are
/// what is left without the forces of a frictionless one.
double frictionWork(OneContactor& rough, OneContactor& smooth, const std::vector<V>& way)
{
    double work = 0;
    for (std::size_t i = 0; i < way.size(); ++i)
        work += 0.5 * dot(rough.force(i) - smooth.force(i), way[i]);
    rough.move(way);
    smooth.move(way);
    for (std::size_t i = 0; i < way.size(); ++i)
        work += 0.5 * dot(rough.force(i) - smooth.force(i), way[i]);
    return work;
}

TEST(FrictionMoment, ForcesOfFaceAndContactorHaveNone)
{
    std::vector<V> places = insidePlaces;
    places.push_back(inValley);
    for (const double mu : {0.01, 10.0}) // slides, sticks
        for (const V& place : places) {
            OneContactor pair(mu, warped(place));
            pair.move(noise(1, 0.02));
            V sum{0, 0, 0};
            for (std::size_t i = 0; i < 7; ++i) sum += pair.force(i);
            EXPECT_GT(pair.held(), 0);
            EXPECT_EQ(size(sum), 0);
            EXPECT_LT(size(pair.moment()), 1e-9) << "mu " << mu << " x " << place.x;
        }
}

TEST(FrictionMoment, BeyondARimFrictionHasNoneEither)
{
    OneContactor rough(10, warped(beyondTheRim)), smooth(0, warped(beyondTheRim));
    const std::vector<V> way = noise(2, 0.005);
    rough.move(way);
    smooth.move(way);
    EXPECT_TRUE(rough.onBorder());
    EXPECT_GT(rough.held(), 0);
    EXPECT_LT(size(rough.moment() - smooth.moment()), 1e-9);
}

TEST(FrictionMoment, RigidMotionsDoNoWorkAndTurnTheForces)
{
    const V axis{0.4, 0.7, -1}, shift{0.3, -0.2, 0.5};
    for (const V& place : insidePlaces)
        for (const double angle : {1e-3, 0.3}) {
            OneContactor pair(10, warped(place));
            pair.move(noise(3, 0.02));
            std::vector<V> way, before;
            for (std::size_t i = 0; i < 7; ++i) {
                way.push_back(rotated(pair.nodes()[i], axis, angle) + shift - pair.nodes()[i]);
                before.push_back(pair.force(i));
            }
            const double held = pair.held();
            pair.move(way);
            EXPECT_NEAR(pair.held(), held, 1e-10 * held);
            for (std::size_t i = 0; i < 7; ++i)
                EXPECT_LT(size(pair.force(i) - rotated(before[i], axis, angle)), 1e-9);
        }
}

TEST(FrictionMoment, WorkIsTheForceTimesTheSlipThatIsMeasured)
{
    // All nodes move, faces turn, stretch and warp: what the tangential spring takes is the work of
    // the friction forces, the better the smaller the motion.
    for (const V& place : insidePlaces)
        for (unsigned seed = 0; seed < 5; ++seed) {
            double error[2];
            for (const double small : {1e-4, 1e-5}) {
                OneContactor rough(10, warped(place)), smooth(0, warped(place));
                const std::vector<V> first = noise(7, 0.05);
                rough.move(first);
                smooth.move(first);
                const double held = rough.held(),
                             work = frictionWork(rough, smooth, noise(seed, small));
                error[small < 5e-5] = std::abs(rough.held() - held + work) / small;
            }
            EXPECT_LT(error[0], 3e-3) << seed;
            EXPECT_LT(error[1], 0.2 * error[0] + 1e-9) << seed;
        }
}

/// Plane faces that fall to the edge x = 2 between them, and a contactor half a unit below them.
std::vector<V> valley(double x, double y)
{
    const double rise = 0.4;
    return {{x, y, -0.5}, {0, 0, rise}, {2, 0, 0},   {4, 0, rise},
            {0, 2, rise}, {2, 2, 0},    {4, 2, rise}};
}

TEST(FrictionMoment, DoesNotDependOnWhichOfTwoFacesTheProjectionIsTracked)
{
    for (const double mu : {0.05, 10.0}) {
        OneContactor a(mu, valley(2, 0.8), 0), b(mu, valley(2, 0.8), 1);
        std::vector<V> way(7, V{0, 0, 0});
        way[0] = {2e-3, 1e-3, 0}; // along the edge and out to face 1
        EXPECT_TRUE(a.onBorder() && b.onBorder());
        EXPECT_NE(a.face(), b.face());
        for (int n = 0; n < 100; ++n) {
            a.move(way);
            b.move(way);
            for (std::size_t i = 0; i < 7; ++i)
                ASSERT_LT(size(a.force(i) - b.force(i)), 1e-9) << "mu " << mu << " step " << n;
        }
        EXPECT_GT(a.held(), 0);
        EXPECT_EQ(a.face(), 1);
        EXPECT_EQ(b.face(), 1);
    }
}

/// A pocket of three walls, in whose corner a contactor lies midway between two of them.
TEST(FrictionMoment, DoesNotDependOnWhichOfThreeFacesTheProjectionIsTracked)
{
    const Faces walls{
        {1, 2, 3, 4, 1, 5, 6, 2, 1, 4, 7, 5},
        {4, 7, 2, 9, 8, 11, 6, 1, 0, 3, 10, 5},
        {7, freeEdge, freeEdge, 8, 11, freeEdge, freeEdge, 0, 3, freeEdge, freeEdge, 4}};
    const std::vector<V> nodes{{-0.5, -0.5, -0.25}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0},
                               {0, 2, 0},           {0, 0, 2}, {2, 0, 2}, {0, 2, 2}};
    std::vector<OneContactor> pairs; // they point at themselves
    pairs.reserve(3);
    for (const Index face : {0, 1, 2}) pairs.emplace_back(0.05, nodes, face, walls);
    for (OneContactor& pair : pairs) {
        pair.hold({0.1, -0.1, 0});
        pair.move(std::vector<V>(nodes.size(), V{0, 0, 0}));
    }
    EXPECT_GT(pairs[0].held(), 0);
    for (Index face = 0; face < 3; ++face) {
        const OneContactor& pair = pairs[std::size_t(face)];
        EXPECT_EQ(pair.face(), face);
        EXPECT_NEAR(pair.lost(), pairs[0].lost(), 1e-9) << face;
        for (std::size_t node = 0; node < nodes.size(); ++node)
            EXPECT_LT(size(pair.force(node) - pairs[0].force(node)), 1e-9) << face;
    }
}

TEST(FrictionMoment, NodesWorkThroughAValleyIsLostOrStored)
{
    // Deep below a valley the projection point stays in it while the contactor moves on, 0.2 here.
    for (const double direction : {1.0, -1.0}) {
        const std::vector<V> nodes = valley(2 - direction, 1);
        OneContactor rough(0.1, nodes), smooth(0, nodes);
        std::vector<V> way(7, V{0, 0, 0});
        way[0] = {direction * 1e-3, 0, 0};
        double work = 0;
        bool waited = false;
        for (int n = 0; n < 2000; ++n) {
            work -= frictionWork(rough, smooth, way);
            waited = waited || rough.onBorder();
        }
        EXPECT_TRUE(waited);
        EXPECT_EQ(rough.face(), direction > 0 ? 1 : 0);
        EXPECT_NEAR(rough.lost() + rough.held(), work, 0.01 * work);
    }
}

TEST(FrictionMoment, WhoCrossesARidgeKeepsWhatIsStored)
{
    // At one step it is as near to both faces, as a contactor on a plane of symmetry would be.
    const double rise = -0.4, side = 0x1p-8;
    OneContactor pair(10, {{2 - 4 * side, 0.8, -0.5},
                           {0, 0, rise},
                           {2, 0, 0},
                           {4, 0, rise},
                           {0, 2, rise},
                           {2, 2, 0},
                           {4, 2, rise}});
    std::vector<V> way(7, V{0, 0, 0});
    way[0] = {side, 0, 0};
    for (int n = 0; n < 8; ++n) {
        const double held = pair.held();
        pair.move(way);
        EXPECT_GT(pair.held(), held) << n; // it sticks
    }
    EXPECT_EQ(pair.face(), 1);
    EXPECT_LT(pair.lost(), 1e-13 * pair.held()); // rounding of its length
}

} // namespace
} // namespace fpm
