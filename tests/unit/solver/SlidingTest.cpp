#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// A unit block led over a fixed row of faces of half its size with imposed motion: what the
/// contact force does then is geometry alone. `shape`: height of the target's top over x.
Model slider(const std::function<double(double)>& shape,
             double start,
             double height,
             Point velocity)
{
    Model model;
    addBox(model.mesh, "track", {24, 4, 1}, {0, -0.5, -0.5}, {12, 2, 0.5});
    addBox(model.mesh, "block", {1, 1, 1}, {start, 0.1, height}, {1, 0.77, 1});
    renumber(model.mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::stiffness, "track"),
                   aluminium(PartKind::elastic, HourglassForm::stiffness, "block")};
    const std::vector<Index> track = nodesOfPart(model.mesh, "track");
    const std::vector<Index> block = nodesOfPart(model.mesh, "block");
    for (const Index node : track) {
        Point& p = model.mesh.points[std::size_t(node)];
        p[2] += shape(p[0]);
    }
    holdFixed(model, track);
    model.initialVelocities.push_back({"led", block, velocity});
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::velocity, "led", block, {true, true, true}, velocity));
    addContact(model, "touch", facing(model.mesh, "block", {0, 0, -1}),
               facing(model.mesh, "track", {0, 0, 1}));
    model.control.backend = "serial";
    model.control.endTime = 1;
    model.control.fixedTimeStep = 2e-8;
    return model;
}

double flat(double)
{
    return 0;
}

TEST(Sliding, ForceOverFaceBordersOfAFlatTargetIsConstant)
{
    for (const ContactSearch search : {ContactSearch::faces, ContactSearch::closestParticle}) {
        Model model = slider(flat, 0.3, -0.01, {1e6, 0, 0});
        model.contactPairs[0].search = search;
        const auto solver = startedSolver(model);
        const Point first = solver->contact().force(0).force;
        EXPECT_GT(first[2], 0);
        double travelled = 0;
        while (travelled < 10) {
            solver->advance(1, 1);
            travelled += 1e6 * solver->clock().step;
            const PairForce now = solver->contact().force(0);
            ASSERT_EQ(now.active, 4) << "after " << travelled << " mm";
            EXPECT_NEAR(now.force[2], first[2], 1e-9 * first[2]);
            EXPECT_NEAR(now.force[0], 0, 1e-9 * first[2]);
        }
    }
}

/// The track with cells that grow along it by a tenth each, all faces of other stiffness.
Model gradedSlider(double friction)
{
    Model model = slider(flat, 0.3, -0.01, {1e6, 0, 0});
    for (const Index node : nodesOfPart(model.mesh, "track")) {
        double& x = model.mesh.points[std::size_t(node)][0];
        x = 12 * (std::pow(1.1, 2 * x) - 1) / (std::pow(1.1, 24) - 1);
    }
    model.contactPairs[0].friction = friction;
    return model;
}

/// Pairs with friction have a kernel of their own: where it is all but none it does as the other.
TEST(Sliding, AllButNoFrictionIsNone)
{
    const auto wavy = [](double x) { return 0.1 * std::sin(2 * x); };
    Model model = slider(wavy, 0.3, 0.06, {1e6, 0, 0});
    const auto smooth = startedSolver(model);
    model.contactPairs[0].friction = 1e-12;
    const auto rough = startedSolver(model);
    double most = 0, apart = 0;
    for (double travelled = 0; travelled < 8; travelled += 1e6 * smooth->clock().step) {
        smooth->advance(1, 1);
        rough->advance(1, 1);
        const PairForce a = smooth->contact().force(0), b = rough->contact().force(0);
        ASSERT_EQ(a.active, b.active) << "after " << travelled << " mm";
        for (std::size_t c = 0; c < 3; ++c) {
            most = std::max(most, std::abs(a.force[c]));
            apart = std::max(apart, std::abs(a.force[c] - b.force[c]));
        }
    }
    EXPECT_GT(most, 100);
    EXPECT_LT(apart, 1e-11 * most);
    EXPECT_LT(rough->contact().force(0).friction, 1e-11 * most);
}

TEST(Sliding, FacesOfOtherStiffnessNeitherJerkNorMakeEnergy)
{
    // A spring that took the stiffness of each face, which goes with its area, would jump by 10 %
    // of its energy at every border.
    for (const double friction : {0.0, 0.2}) {
        const Model model = gradedSlider(friction);
        const auto solver = startedSolver(model);
        solver->advance(1, 20); // friction slides by then
        const double held = solver->ledger().energies().contact;
        double last = solver->contact().force(0).force[2], travelled = 0.4, worst = 0;
        const double start = solver->ledger().energies().friction, whole = last;
        while (travelled < 10) {
            solver->advance(1, 1);
            travelled += 1e6 * solver->clock().step;
            ASSERT_EQ(solver->contact().force(0).active, 4);
            const double force = solver->contact().force(0).force[2];
            worst = std::max(worst, std::abs(force / last - 1));
            last = force;
        }
        EXPECT_LT(worst, 1e-9);
        EXPECT_NEAR(solver->ledger().energies().contact, held, 1e-9 * held);
        EXPECT_NEAR(solver->ledger().energies().friction - start,
                    friction * whole * (travelled - 0.4), 1e-6 * whole);
    }
}

/// Largest error of the energy balance over that of the springs while a block is led over a ridge
/// of twice 22 degrees, `depth` below its top.
double ridgeError(double depth, double friction, double step)
{
    Model model = slider([](double x) { return -0.4 * std::abs(x - 6); }, 5.4, -depth, {2e5, 0, 0});
    model.contactPairs[0].friction = friction;
    model.control.fixedTimeStep = step;
    const auto solver = startedSolver(model);
    const double start = solver->ledger().energies().total;
    double worst = 0, most = 0;
    while (solver->clock().time < 8e-6) {
        solver->advance(8e-6, 10);
        const Energies now = solver->ledger().energies();
        worst = std::max(worst, std::abs(now.total - now.external - start));
        most = std::max(most, now.contact);
    }
    EXPECT_EQ(solver->ledger().energies().friction > 0, friction > 0);
    return worst / most;
}

TEST(Sliding, OverARidgeEnergyIsKeptHoweverDeep)
{
    // Inside a ridge the projection point jumps to the other side where that becomes the nearer
    // one; the contactor does not jump, and its friction makes no slip. The target is 0.5 thick.
    // The remaining error is that of the step in which the normal turns: the force changes by 0.8 k
    // g along its displacement, over k g^2 / 2.
    for (const double depth : {0.1, 0.2, 0.35})
        for (const double friction : {0.0, 0.3})
            for (const double step : {2e-8, 2e-9})
                EXPECT_LT(ridgeError(depth, friction, step), 0.81 * 2e5 * step / depth)
                    << depth << " deep, friction " << friction;
}

TEST(Sliding, ForceOverAGentlyCurvedTargetJumpsNoMoreThanItsNormals)
{
    const double radius = 160, angle = 0.5 / radius; // of neighbouring faces
    for (const double sign : {-1.0, 1.0}) {          // ridge and valley
        const auto shape = [&](double x) { return sign * (x - 6) * (x - 6) / (2 * radius); };
        const double height = sign < 0 ? -0.11 : -0.02;
        const auto solver = startedSolver(slider(shape, 0.6, height, {1e6, 0, 0}));
        Point before = solver->contact().force(0).force;
        double travelled = 0, worstX = 0, worstZ = 0;
        while (travelled < 9.6) {
            solver->advance(1, 1);
            travelled += 1e6 * solver->clock().step;
            const PairForce now = solver->contact().force(0);
            ASSERT_EQ(now.active, 4) << "after " << travelled << " mm";
            worstX = std::max(worstX, std::abs(now.force[0] - before[0]) / now.force[2]);
            worstZ = std::max(worstZ, std::abs(now.force[2] - before[2]) / now.force[2]);
            before = now.force;
        }
        EXPECT_LT(worstX, 1.2 * angle);
        EXPECT_LT(worstZ, 0.03); // 20 um of displacement a step on a slope of up to 0.03
    }
}

TEST(Sliding, NodesThatLeaveOverAFreeEdgeOpen)
{
    const Model model = slider(flat, 10.3, -0.01, {1e6, 0, 0});
    const auto solver = startedSolver(model);
    const double each = solver->contact().force(0).force[2] / 4;
    double front = 11.3;
    int last = 4;
    while (front < 14) {
        solver->advance(1, 1);
        front += 1e6 * solver->clock().step;
        const PairForce now = solver->contact().force(0);
        EXPECT_LE(now.active, last);
        last = now.active;
        EXPECT_NEAR(now.force[2], each * now.active, 1e-9 * each);
        EXPECT_NEAR(now.force[0], 0, 1e-9 * each);
        // A face ends 5 % of its half size beyond the edge.
        const int wanted = front < 12 ? 4 : front < 13 ? 2 : 0;
        const bool onTheRim = std::abs(front - 12) < 0.04 || std::abs(front - 13) < 0.04;
        EXPECT_TRUE(onTheRim || now.active == wanted) << now.active << " at " << front;
    }
    EXPECT_EQ(solver->contact().force(0).released, 0);
}

TEST(Sliding, NodesPushedThroughTheTargetAreReleasedAndCounted)
{
    const Model model = slider(flat, 5.2, 0.1, {0, 0, -1e6});
    const auto solver = startedSolver(model);
    solver->advance(0.5e-6, 100000); // 0.4 mm deep, the target is 0.5 mm thick
    EXPECT_EQ(solver->contact().force(0).active, 4);
    EXPECT_EQ(solver->contact().force(0).released, 0);
    solver->advance(0.7e-6, 100000); // 0.6 mm
    EXPECT_EQ(solver->contact().force(0).active, 0);
    EXPECT_EQ(solver->contact().force(0).force[2], 0);
    EXPECT_EQ(solver->contact().force(0).released, 4);
    solver->advance(3e-6, 100000);
    EXPECT_EQ(solver->contact().force(0).active, 0);
    EXPECT_EQ(solver->contact().force(0).released, 4);
}

TEST(Sliding, BlockThatStartsDeepIsFoundWhereverTheCellsLie)
{
    // Up to half the thickness of the target a contactor is taken as lying inside it.
    for (const double lift : {0.0, 0.15, 0.3, 0.6, 0.9, 1.2}) {
        const auto raised = [&](double) { return lift; };
        const auto solver = startedSolver(slider(raised, 5.2, lift - 0.2, {0, 0, 0}));
        solver->advance(1, 1);
        EXPECT_EQ(solver->contact().force(0).active, 4) << "lifted by " << lift;
    }
}

TEST(Sliding, FrictionOfALedBlockIsItsCoefficientTimesTheForce)
{
    Model model = slider(flat, 0.3, -0.01, {1e6, 0, 0});
    model.contactPairs[0].friction = 0.25;
    const auto solver = startedSolver(model);
    solver->advance(1, 200); // 4 mm
    const PairForce now = solver->contact().force(0);
    EXPECT_NEAR(now.force[0], -0.25 * now.force[2], 1e-9 * now.force[2]);
    EXPECT_NEAR(now.force[1], 0, 1e-9 * now.force[2]);
    EXPECT_NEAR(solver->ledger().energies().friction, 0.25 * now.force[2] * 4, 0.02 * now.force[2]);
}

} // namespace
} // namespace fpm::test
