#include "kernels/contact/ContactForce.h"
#include "parallel/CpuExecutor.h"
#include "unit/kernels/rotated.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace fpm {
namespace {

using V = Vec3<double>;
using test::rotated;
using test::size;
constexpr double normalStiffness = 100, tangentialRatio = 0.5, step = 1e-3;

/// One contactor, node 0, against faces of the nodes 1 to 6: 1 2 5 4 and 2 3 6 5.
class OneContactor
{
public:
    explicit OneContactor(double friction, std::vector<V> nodes, Index face = 0)
        : x_(std::move(nodes)),
          v_(x_.size(), V{0, 0, 0}),
          face_(face)
    {
        law_.count = 1;
        law_.stored = stored_;
        law_.storedFace = &storedFace_;
        law_.spring = &spring_;
        law_.dissipated = &dissipated_;
        law_.limitFactor = 1;
        clock_.step = step;
        press(); // finds the foot
        law_.friction = {friction, friction, 0, tangentialRatio, false};
        press();
    }

    /// Moves the nodes in one step.
    void move(const std::vector<V>& way)
    {
        for (std::size_t i = 0; i < x_.size(); ++i) {
            x_[i] += way[i];
            v_[i] = (1 / step) * way[i];
        }
        press();
    }
    const std::vector<V>& nodes() const { return x_; }
    V force(std::size_t node) const
    {
        const auto at = [&](std::size_t c) { return scale_.toForce(sums_[4 * node + c]); };
        return {at(0), at(1), at(2)};
    }
    V moment() const
    {
        V sum{0, 0, 0};
        for (std::size_t i = 0; i < x_.size(); ++i) sum += cross(x_[i], force(i));
        return sum;
    }
    /// Energy of the tangential spring.
    double held() const
    {
        return (stored_[0] * stored_[0] + stored_[1] * stored_[1])
               / (2 * tangentialRatio * normalStiffness);
    }
    double lost() const { return dissipated_; }
    Index face() const { return face_; }
    bool onBorder() const { return std::abs(xi_) >= 1 || std::abs(eta_) >= 1; }

private:
    void press()
    {
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < x_.size(); ++i) {
                position_[c * x_.size() + i] = c == 0 ? x_[i].x : c == 1 ? x_[i].y : x_[i].z;
                velocity_[c * x_.size() + i] = c == 0 ? v_[i].x : c == 1 ? v_[i].y : v_[i].z;
            }
        sums_.assign(4 * x_.size(), 0);
        PairView<DoublePrecision> pair{};
        pair.contactorCount = pair.nodeCount = 1;
        pair.faceCount = 2;
        pair.contactor = &contactor_;
        pair.contactNumber = contactNumber_;
        pair.faceNode = faceNode_;
        pair.nextAround = nextAround_;
        pair.neighbour = neighbour_;
        pair.faceStiffness = faceStiffness_;
        pair.faceThickness = faceThickness_;
        pair.ownNormal = ownNormal_;
        pair.face = &face_;
        pair.xi = &xi_;
        pair.eta = &eta_;
        pair.around = &around_;
        pair.force = force_;
        pair.counts = counts_;
        pair.overlap = &overlap_;
        pair.position = position_;
        pair.velocity = velocity_;
        pair.nodeStride = x_.size();
        pair.sums = {sums_.data(), scale_, true, nullptr};
        pair.clock = &clock_;
        pair.reach = 1;
        pair.law = law_;
        ContactForce<DoublePrecision, true>{pair, {}}(CpuTeam<64>(nullptr), 0);
    }

    std::vector<V> x_, v_;
    PairLaw<double> law_{};
    StepClock clock_;
    ForceScale scale_{0x1p40, 0x1p-40, 0x1p20, 0x1p-20};
    std::vector<std::int64_t> sums_;
    Index contactor_ = 0, face_, storedFace_ = 0;
    Index faceNode_[8]{1, 2, 5, 4, 2, 3, 6, 5}, contactNumber_[7]{0, 1, 2, 3, 4, 5, 6},
        nextAround_[8]{0, 4, 7, 3, 1, 5, 6, 2},
        neighbour_[8]{freeEdge, 7, freeEdge, freeEdge, freeEdge, freeEdge, freeEdge, 1};

    double faceStiffness_[2]{normalStiffness, normalStiffness},
        xi_ = 0, eta_ = 0, stored_[2]{}, spring_ = 0, dissipated_ = 0, position_[21]{},
        velocity_[21]{};
    float faceThickness_[2]{10, 10}, overlap_ = 0;
    std::int16_t ownNormal_[3]{};
    std::uint8_t around_ = aroundCurved;
    std::int64_t counts_[pairCounts]{}, force_[BlockForce::values]{};
};

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

TEST(FrictionMoment, ItDoesNotMatterWhichOfTwoFacesTheFootIsTrackedOn)
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

TEST(FrictionMoment, NodesWorkThroughAValleyIsLostOrStored)
{
    // Deep below a valley the foot waits in it while the contactor goes on, 0.2 of the way here.
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

} // namespace
} // namespace fpm
