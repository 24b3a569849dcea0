#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// Depth of a node inside the plane z = 0 of the lower block, which does not move.
double depthOf(Solver& solver, Index node)
{
    return std::max(0.0, -solver.nodes().values({node}).at(0, 0)[2]);
}

/// A block that was pushed into another, both held so that nothing but the depth counts.
Model pushed(double depth, const std::string& precision = "double")
{
    const Part part = aluminium(PartKind::elastic, HourglassForm::stiffness);
    Model model = twoBlocks(part, part, {0, 0, 0}, 0.3, -depth);
    if (precision == "single") model.control.precision = Precision::single;
    return model;
}

TEST(PairStatus, TellsTheDeepestContactorAndTheMeanOfThoseInTouch)
{
    for (const std::string precision : {"double", "single"}) {
        Model model = pushed(0.02, precision);
        const auto solver = startedSolver(model);
        const PairStatus status = solver->contact().status(0);
        EXPECT_EQ(status.active, 30);
        EXPECT_EQ(status.active, solver->contact().force(0).active);
        EXPECT_NEAR(status.maxDepth, 0.02, 1e-6);
        EXPECT_NEAR(status.meanDepth, 0.02, 1e-6);
        EXPECT_NEAR(status.thickness, 1, 1e-6); // four layers of 4 mm
        ASSERT_GE(status.deepest, 0);
        EXPECT_NEAR(depthOf(*solver, status.deepest), status.maxDepth, 1e-6);
        // Nothing slips yet: the force of the pair is that of its normal springs.
        EXPECT_NEAR(status.normal, solver->contact().force(0).force[2], 1e-5 * status.normal);
        EXPECT_EQ(status.speed, 0);
    }
}

TEST(PairStatus, HalfAModelTellsTheMeansOfTheWhole)
{
    // A block tilted about the axis across the plane of symmetry x = 0: depths of 0.01 to 0.03.
    const auto statusOf = [](bool half) {
        Model model;
        addBox(model.mesh, "block", {half ? 2 : 4, 2, 2}, {half ? 0.0 : -2.0, 0, 0},
               {half ? 2.0 : 4.0, 2, 2});
        for (Point& p : model.mesh.points)
            if (p[2] == 0) p[2] = -0.01 - 0.01 * std::abs(p[0]);
        renumber(model.mesh);
        model.parts = {aluminium(PartKind::elastic, HourglassForm::stiffness, "block")};
        ContactPair& pair = addContact(model, "touch", facing(model.mesh, "block", {0, 0, -1}), {});
        pair.surface = 0;
        pair.enforcement = Enforcement::penalty;
        RigidSurface wall;
        wall.name = "wall";
        wall.axis = {0, 0, 1};
        model.rigidSurfaces.push_back(wall);
        if (half) {
            BoundaryCondition symmetry = condition(
                BoundaryCondition::Kind::fixed, "symmetry",
                nodesWhere(model.mesh, [](Point p) { return p[0] == 0; }), {true, false, false});
            symmetry.mirror = true;
            model.boundaryConditions.push_back(symmetry);
        }
        model.control.backend = "serial";
        model.control.endTime = 1;
        return startedSolver(model)->contact().status(0);
    };
    const PairStatus whole = statusOf(false), half = statusOf(true);
    EXPECT_EQ(whole.active, 15);
    EXPECT_EQ(half.active, 9);
    EXPECT_NEAR(whole.meanDepth, 0.01 + 0.01 * 6 / 5, 1e-12);
    EXPECT_NEAR(half.meanDepth, 0.01 + 0.01 * (0.5 * 0 + 1 + 2) / 2.5, 1e-12);
    EXPECT_NEAR(half.maxDepth, whole.maxDepth, 1e-12);
    EXPECT_NEAR(2 * half.normal, whole.normal, 1e-9 * whole.normal);
}

TEST(PairStatus, SlidingDeliversCoulombsFriction)
{
    const Part part = aluminium(PartKind::elastic, HourglassForm::stiffness);
    Model model = twoBlocks(part, part, {2e4, 0, -1e4}, 0.3);
    model.contactPairs[0].slipDamping = 0; // the slip slows at once
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    const auto solver = startedSolver(model);
    solver->advance(1e-6, 100000);
    const PairStatus status = solver->contact().status(0);
    const PairForce force = solver->contact().force(0);
    ASSERT_GT(status.normal, 0);
    EXPECT_GT(status.slip[0], 0.5 * 2e4);
    EXPECT_NEAR(status.friction[0], -0.3 * status.normal, 0.02 * status.normal);
    EXPECT_NEAR(status.friction[0], force.force[0], 0.02 * status.normal);
    EXPECT_GE(status.maxDepth, status.meanDepth);
}

TEST(PairStatus, AskingChangesNoBit)
{
    const Part part = aluminium(PartKind::elastic, HourglassForm::stiffness);
    const Model model = twoBlocks(part, part, {2e4, 0, -1e5}, 0.3);
    const auto asked = startedSolver(model), silent = startedSolver(model);
    for (int step = 0; step < 200; ++step) {
        asked->advance(1, 1);
        asked->contact().status(0);
        asked->ledger().energies();
        silent->advance(1, 1);
    }
    EXPECT_EQ(stateChecksum(*asked), stateChecksum(*silent));
}

TEST(PairStatus, AnAnalyticSurfaceHasDepthAndNoThickness)
{
    Model model;
    addBox(model.mesh, "block", {2, 2, 2}, {0, 0, -0.05}, {2, 2, 2});
    renumber(model.mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::stiffness, "block")};
    ContactPair& pair = addContact(model, "touch", facing(model.mesh, "block", {0, 0, -1}), {});
    pair.surface = 0;
    pair.enforcement = Enforcement::penalty;
    RigidSurface wall;
    wall.name = "wall";
    wall.axis = {0, 0, 1};
    model.rigidSurfaces.push_back(wall);
    model.control.backend = "serial";
    model.control.endTime = 1;
    const auto solver = startedSolver(model);
    const PairStatus status = solver->contact().status(0);
    EXPECT_EQ(status.active, 9);
    EXPECT_NEAR(status.maxDepth, 0.05, 1e-12);
    EXPECT_EQ(status.thickness, 0);
    EXPECT_NEAR(status.normal, solver->contact().force(0).force[2], 1e-9 * status.normal);
}

} // namespace
} // namespace fpm::test
