#include "unit/solver/kindScenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// The model of `twoBlocks` with another kind of contact.
Model blocks(ContactKind kind, int passes, Point velocity, double friction, double gap = 0)
{
    Model model = twoBlocks(metal(), metal(), velocity, friction, gap);
    if (kind == ContactKind::general) {
        model.mesh.contact.clear();
        model.contactPairs.clear();
        addGeneral(model).friction = friction;
    } else
        model.contactPairs[0].passes = passes;
    return model;
}

double impulseOn(const Model& model, double time)
{
    const auto solver = startedSolver(model);
    const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
    const double before = momentum(*solver, upper)[2];
    solver->advance(time, 100000);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
    return momentum(*solver, upper)[2] - before;
}

TEST(ContactKinds, GiveTheSameImpulse)
{
    const Point down{0, 0, -2e4};
    const double one = impulseOn(blocks(ContactKind::pair, 1, down, 0), 3e-6);
    EXPECT_GT(one, 0);
    EXPECT_NEAR(impulseOn(blocks(ContactKind::pair, 2, down, 0), 3e-6), one, 0.05 * one);
    EXPECT_NEAR(impulseOn(blocks(ContactKind::general, 1, down, 0), 3e-6), one, 0.05 * one);
}

TEST(ContactKinds, KeepLinearMomentum)
{
    for (const int kind : {0, 1, 2}) {
        const Model model = blocks(kind == 2 ? ContactKind::general : ContactKind::pair,
                                   kind == 1 ? 2 : 1, {2e4, -1e4, -4e4}, 0.3);
        const auto solver = startedSolver(model);
        const Point before = momentum(*solver);
        const double scale = std::abs(before[0]) + std::abs(before[1]) + std::abs(before[2]);
        solver->advance(1e-6, 100000);
        EXPECT_GT(solver->contact().force(0).active, 0);
        solver->advance(4e-6, 100000);
        const Point after = momentum(*solver);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(after[c], before[c], 1e-12 * scale) << "kind " << kind;
    }
}

TEST(ContactKinds, TwoPassesAddTheForcesOfBothSidesWithHalfTheStiffness)
{
    // A block held 0.01 inside another with equal faces: both passes find four nodes each.
    Model model;
    addBox(model.mesh, "lower", {1, 1, 1}, {0, 0, -1}, {1, 1, 1});
    addBox(model.mesh, "upper", {1, 1, 1}, {0, 0, -0.01}, {1, 1, 1});
    renumber(model.mesh);
    Part part = metal();
    part.poissonsRatio = 0;
    model.parts = {part, part};
    holdFixed(model, nodesWhere(model.mesh, [](Point) { return true; }));
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}))
        .passes = 2;
    model.control.backend = "serial";
    const auto solver = startedSolver(model);
    const PairForce force = solver->contact().force(0);
    EXPECT_EQ(force.active, 8);
    EXPECT_NEAR(force.force[2], 4 * 0.01 * 70000 / 3, 1e-6);
    EXPECT_NEAR(solver->ledger().energies().contact, 0.5 * 4 * 0.01 * 0.01 * 70000 / 3, 1e-6);
}

/// F12: a coarse block under pressure on a fine one. How deep the worst node of the fine one is.
double deepestFineNode(int passes)
{
    Model model;
    addBox(model.mesh, "fine", {12, 12, 2}, {0, 0, -1}, {3, 3, 1});
    addBox(model.mesh, "coarse", {1, 1, 1}, {0.25, 0.25, 0}, {2.5, 2.5, 1});
    renumber(model.mesh);
    model.parts = {metal(), metal()};
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -0.99; }));
    const auto top = [](Point p) { return p[2] > 0.99; };
    model.boundaryConditions.push_back(condition(
        BoundaryCondition::Kind::force, "load", nodesWhere(model.mesh, top), {false, false, true},
        {0, 0, -2000}, {Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}}}));
    addContact(model, "touch", facing(model.mesh, "coarse", {0, 0, -1}),
               facing(model.mesh, "fine", {0, 0, 1}))
        .passes = passes;
    model.control.backend = "serial";
    model.control.massDamping = 1e6;
    const auto solver = startedSolver(model);
    solver->advance(2e-5, 1000000);
    EXPECT_NEAR(solver->contact().force(0).force[2], 2000, 40);
    const NodeValues values = solver->nodes().values({});
    double lowest = 1e9, highest = -1e9;
    for (const Index node : model.contactPairs[0].contactorNodes)
        lowest = std::min(lowest, values.at(0, std::size_t(node))[2]);
    for (const Index node : nodesOf(model.mesh, model.contactPairs[0].targetSides)) {
        const Point p = values.at(0, std::size_t(node));
        if (p[0] > 0.5 && p[0] < 2.5 && p[1] > 0.5 && p[1] < 2.5) highest = std::max(highest, p[2]);
    }
    return highest - lowest;
}

TEST(ContactKinds, TwoPassesKeepFineTargetNodesOutOfACoarseContactor)
{
    const double one = deepestFineNode(1), two = deepestFineNode(2);
    EXPECT_GT(one, 0.02);
    EXPECT_LT(two, 0.25 * one);
}

/// F9: three layers of one element, a tenth as thick as wide, pressed between two blocks.
Model stack(bool general)
{
    Model model;
    addBox(model.mesh, "ground", {4, 4, 1}, {0, 0, -0.5}, {2, 2, 0.5});
    for (int layer = 0; layer < 3; ++layer)
        addBox(model.mesh, "layer" + std::to_string(layer), {4, 4, 1}, {0, 0, 0.05 * layer},
               {2, 2, 0.05});
    addBox(model.mesh, "stamp", {2, 2, 1}, {0.5, 0.5, 0.15}, {1, 1, 0.5});
    renumber(model.mesh);
    model.parts.assign(5, metal());
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -0.49; }));
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "stamp"), {0, 0, -3e4}});
    model.control.backend = "serial";
    if (general) {
        addGeneral(model);
        return model;
    }
    const std::vector<std::string> order{"ground", "layer0", "layer1", "layer2", "stamp"};
    for (std::size_t i = 1; i < order.size(); ++i)
        addContact(model, order[i], facing(model.mesh, order[i], {0, 0, -1}),
                   facing(model.mesh, order[i - 1], {0, 0, 1}));
    return model;
}

TEST(ContactKinds, ThinLayersAreHeldFromTheSideTheyAreTouched)
{
    for (const bool general : {false, true}) {
        const Model model = stack(general);
        const auto solver = startedSolver(model);
        for (int call = 0; call < 20; ++call) {
            solver->advance(1e-5, 50);
            ASSERT_FALSE(solver->clock().failed);
            EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
        }
        const NodeValues values = solver->nodes().values({});
        // No layer has passed through another: their middles stay in order.
        double below = -1;
        for (const char* part : {"ground", "layer0", "layer1", "layer2", "stamp"}) {
            double sum = 0;
            const auto nodes = nodesOfPart(model.mesh, part);
            for (const Index node : nodes) sum += values.at(0, std::size_t(node))[2];
            EXPECT_GT(sum / double(nodes.size()), below + 0.01) << part;
            below = sum / double(nodes.size());
        }
        for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair) {
            EXPECT_EQ(solver->contact().force(pair).released, 0);
            EXPECT_EQ(solver->contact().force(pair).crowded, 0);
        }
    }
}

TEST(ContactKinds, ACompressedLayerDoesNotCaptureItsOwnOtherSide)
{
    // One element thick, squeezed to three tenths by imposed motion: no force from itself.
    Model model;
    addBox(model.mesh, "layer", {4, 4, 1}, {0, 0, 0}, {2, 2, 0.2});
    renumber(model.mesh);
    model.parts = {metal()};
    const auto driven = nodesWhere(model.mesh, [](Point p) { return p[2] > 0.1; });
    model.initialVelocities.push_back({"press", driven, {0, 0, -1e4}});
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "press", driven,
                                                 {true, true, true}, {0, 0, -1e4}));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < 0.1; }));
    addGeneral(model);
    model.control.backend = "serial";
    const auto solver = startedSolver(model);
    while (solver->clock().time < 1.4e-5) {
        solver->advance(1.4e-5, 20);
        ASSERT_EQ(solver->contact().force(0).active, 0);
    }
}

TEST(ContactKinds, OneNodeTouchesThreeBodiesAtOnce)
{
    // A cube in the corner of three blocks, 0.01 inside each: all three push its corner node.
    Model model;
    addBox(model.mesh, "floor", {3, 3, 1}, {-1, -1, -1}, {3, 3, 1});
    addBox(model.mesh, "left", {1, 3, 3}, {-1, -1, -1}, {1, 3, 3});
    addBox(model.mesh, "back", {3, 1, 3}, {-1, -1, -1}, {3, 1, 3});
    addBox(model.mesh, "cube", {1, 1, 1}, {-0.01, -0.01, -0.01}, {1, 1, 1});
    renumber(model.mesh);
    Part part = metal();
    part.poissonsRatio = 0;
    model.parts.assign(4, part);
    holdFixed(model, nodesWhere(model.mesh, [](Point) { return true; }));
    ContactPair& pair = addGeneral(model);
    pair.apart = {{0, 1}, {0, 2}, {1, 2}};
    model.control.backend = "serial";
    const auto solver = startedSolver(model);
    const auto corner = nodesWhere(
        model.mesh, [](Point p) { return p[0] == -0.01 && p[1] == -0.01 && p[2] == -0.01; });
    ASSERT_EQ(corner.size(), 1u);
    const Point force = solver->nodes().values(corner).at(3, 0);
    // Half the stiffness K A^2 / V for the node, and what the nodes of the others give its faces.
    for (std::size_t c = 0; c < 3; ++c) EXPECT_GE(force[c], 0.5 * 0.01 * 70000 / 3 - 1e-6);
    EXPECT_EQ(solver->contact().force(0).crowded, 0);
}

TEST(ContactKinds, RigidBodiesAreLeftOutOfGeneralContactWithEachOther)
{
    // F24: two rigid blocks overlap, a deformable one lies between neither.
    Model model;
    addBox(model.mesh, "a", {2, 2, 2}, {0, 0, 0}, {1, 1, 1});
    addBox(model.mesh, "b", {2, 2, 2}, {0.1, 0.1, 0.95}, {1, 1, 1});
    addBox(model.mesh, "c", {2, 2, 2}, {0.1, 0.1, 1.94}, {1, 1, 1});
    renumber(model.mesh);
    model.parts.assign(3, metal());
    model.parts[0].kind = model.parts[1].kind = PartKind::rigidPrescribed;
    std::vector<Index> rigid = nodesOfPart(model.mesh, "a");
    for (const Index node : nodesOfPart(model.mesh, "b")) rigid.push_back(node);
    std::sort(rigid.begin(), rigid.end());
    holdFixed(model, rigid);
    addGeneral(model);
    model.control.backend = "serial";
    const auto solver = startedSolver(model);
    const auto forceOn = [&](const char* part) {
        double sum = 0;
        const NodeValues values = solver->nodes().values(nodesOfPart(model.mesh, part));
        for (std::size_t i = 0; i < values.count; ++i) sum += values.at(3, i)[2];
        return sum;
    };
    EXPECT_EQ(forceOn("a"), 0);
    EXPECT_GT(forceOn("c"), 0);
    EXPECT_NEAR(forceOn("b"), -forceOn("c"), 1e-9 * forceOn("c"));
}

TEST(ContactKinds, PairsOfTheirOwnAreLeftOutOfGeneralContact)
{
    Model model = blocks(ContactKind::general, 1, {0, 0, -1e4}, 0, -0.05);
    EXPECT_GT(startedSolver(model)->contact().force(0).active, 0);
    model.contactPairs[0].apart = {{1, 0}};
    EXPECT_EQ(startedSolver(model)->contact().force(0).active, 0);
}

TEST(ContactKinds, AFoldThatClosesMeetsItself)
{
    for (const bool general : {false, true}) {
        Model model = closingFold();
        const std::vector<ElementSide> sides = skin(model.mesh, 0);
        if (general)
            addGeneral(model);
        else
            addContact(model, "own", sides, sides).kind = ContactKind::self;
        const auto solver = startedSolver(model);
        EXPECT_EQ(solver->contact().force(0).active, 0) << "nothing touches at the start";
        Index most = 0;
        while (solver->clock().time < 8e-6) {
            solver->advance(8e-6, 20);
            ASSERT_FALSE(solver->clock().failed);
            most = std::max(most, solver->contact().force(0).active);
            EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
        }
        EXPECT_GT(most, 8);
        EXPECT_EQ(solver->contact().force(0).released, 0);
        // The arms are still apart: every upper node over its lower one.
        const NodeValues values = solver->nodes().values({});
        for (const Index upper : nodesWhere(
                 model.mesh, [](Point p) { return std::abs(p[2] - 1.5) < 1e-9 && p[0] > 1.1; })) {
            const Point& start = model.mesh.points[std::size_t(upper)];
            const auto lower = nodesWhere(model.mesh, [&](Point p) {
                return std::abs(p[2] - 1) < 1e-9 && std::abs(p[0] - start[0]) < 1e-9
                       && std::abs(p[1] - start[1]) < 1e-9;
            });
            ASSERT_EQ(lower.size(), 1u);
            EXPECT_GT(values.at(0, std::size_t(upper))[2],
                      values.at(0, std::size_t(lower[0]))[2] - 0.1);
        }
    }
}

} // namespace
} // namespace fpm::test
