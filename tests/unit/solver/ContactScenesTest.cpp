#include "unit/solver/kindScenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

Part withoutPoisson(const std::string& name)
{
    Part part = aluminium(PartKind::elastic, HourglassForm::stiffness, name);
    part.poissonsRatio = 0;
    return part;
}

/// Largest change of the angular momentum, a share of it, in an oblique impact of free blocks
/// beside the centre of both.
double obliqueImpact(ContactKind kind, double friction)
{
    Model model = twoBlocks(metal(), metal(), {3e4, -2e4, -6e4}, friction);
    for (const Index node : nodesOfPart(model.mesh, "upper")) { // no node below another's edge
        Point& p = model.mesh.points[std::size_t(node)];
        p = {p[0] + 0.4, p[1] + 0.5, p[2]};
    }
    if (kind == ContactKind::general) {
        model.mesh.contact.clear();
        model.contactPairs.clear();
        addGeneral(model).friction = friction;
    }
    const auto solver = startedSolver(model);
    const Point before = angularMomentum(*solver);
    double change = 0, strongest = 0;
    for (int step = 0; step < 250; ++step) {
        solver->advance(1, 1);
        strongest = std::max(strongest, lengthOf(solver->contact().force(0).force));
        const Point after = angularMomentum(*solver);
        const Point d{after[0] - before[0], after[1] - before[1], after[2] - before[2]};
        change = std::max(change, lengthOf(d));
    }
    EXPECT_GT(strongest, 0);
    return change / lengthOf(before);
}

TEST(ContactScenes, AnObliqueImpactKeepsTheAngularMomentum)
{
    for (const ContactKind kind : {ContactKind::pair, ContactKind::general})
        for (const double friction : {0.0, 0.3})
            EXPECT_LT(obliqueImpact(kind, friction), 1e-11) << "friction " << friction;
}

/// A cube thrown along the diagonal into the corner of three loose walls, each a part of its own.
Model cornerOfWalls(bool general, ContactSearch search)
{
    Model model;
    addBox(model.mesh, "floor", {3, 3, 1}, {0, 0, -1}, {3, 3, 1});
    addBox(model.mesh, "left", {1, 3, 3}, {-1, 0, 0}, {1, 3, 3});
    addBox(model.mesh, "back", {3, 1, 3}, {0, -1, 0}, {3, 1, 3});
    addBox(model.mesh, "cube", {2, 2, 2}, {0.02, 0.02, 0.02}, {1, 1, 1});
    renumber(model.mesh);
    model.parts.assign(4, metal());
    const char* names[4] = {"floor", "left", "back", "cube"};
    for (std::size_t i = 0; i < 4; ++i) model.parts[i].name = names[i];
    holdFixed(model, nodesWhere(model.mesh, [](Point p) {
                  return p[0] < -0.99 || p[1] < -0.99 || p[2] < -0.99;
              }));
    model.initialVelocities.push_back(
        {"throw", nodesOfPart(model.mesh, "cube"), {-4e4, -4e4, -4e4}});
    model.control.backend = "serial";
    if (general) {
        addGeneral(model).apart = {{0, 1}, {0, 2}, {1, 2}};
        return model;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        Point in{0, 0, 0}, out{0, 0, 0};
        const std::size_t axis = i == 0 ? 2 : i == 1 ? 0 : 1;
        in[axis] = 1;
        out[axis] = -1;
        addContact(model, names[i], facing(model.mesh, "cube", out),
                   facing(model.mesh, names[i], in))
            .search = search;
    }
    return model;
}

TEST(ContactScenes, ACubeThrownIntoTheCornerOfThreeLooseWallsComesBack)
{
    struct Way {
        bool general;
        ContactSearch search;
    };
    for (const Way way : {Way{false, ContactSearch::faces}, Way{true, ContactSearch::faces},
                          Way{false, ContactSearch::closestParticle}}) {
        const Model model = cornerOfWalls(way.general, way.search);
        const auto solver = startedSolver(model);
        const std::vector<Index> cube = nodesOfPart(model.mesh, "cube");
        const double before = momentum(*solver, cube)[0];
        double deepest = 0;
        for (int call = 0; call < 40; ++call) {
            solver->advance(3e-6, 20);
            ASSERT_EQ(solver->clock().failed, 0);
            EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
            const NodeValues values = solver->nodes().values(cube);
            for (std::size_t i = 0; i < values.count; ++i)
                for (const double x : values.at(0, i)) deepest = std::max(deepest, -x);
        }
        const Point after = momentum(*solver, cube);
        for (const double p : after) {
            EXPECT_GT(p, -0.5 * before); // back along all three axes
            EXPECT_NEAR(p, after[0], 0.02 * std::abs(before));
        }
        EXPECT_LT(deepest, 0.1);
        for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair) {
            EXPECT_EQ(solver->contact().force(pair).released, 0);
            EXPECT_EQ(solver->contact().force(pair).crowded, 0);
        }
    }
}

TEST(ContactScenes, ARowOfRodsPassesTheBlowToItsLast)
{
    // Equal rods that touch, nu = 0: the wave leaves all but the last at rest.
    const int rods = 5;
    Model model;
    for (int i = 0; i < rods; ++i) {
        const std::string name = "rod" + std::to_string(i);
        addBox(model.mesh, name, {1, 1, 20}, {0, 0, 10.0 * i}, {1, 1, 10});
        model.parts.push_back(withoutPoisson(name));
    }
    renumber(model.mesh);
    addGeneral(model);
    model.initialVelocities.push_back({"blow", nodesOfPart(model.mesh, "rod0"), {0, 0, 5e3}});
    model.control.backend = "serial";
    const auto solver = startedSolver(model);
    const double all = momentum(*solver)[2], run = 10 / std::sqrt(70000 / 2.7e-9);
    solver->advance(8 * run, 100000);
    for (int i = 0; i < rods; ++i) {
        const double share =
            momentum(*solver, nodesOfPart(model.mesh, "rod" + std::to_string(i)))[2] / all;
        EXPECT_NEAR(share, i == rods - 1 ? 1 : 0, 0.05) << "rod " << i;
    }
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
}

/// A block falling on a plate, friction between; one quarter of both, or all of it.
Model fallOnPlate(bool quarter)
{
    const double from = quarter ? 0 : -1;
    const Index twice = quarter ? 1 : 2;
    Model model;
    addBox(model.mesh, "plate", {3 * twice, 3 * twice, 2}, {3 * from, 3 * from, -2},
           {3 - 3 * from, 3 - 3 * from, 2});
    addBox(model.mesh, "block", {2 * twice, 2 * twice, 3}, {1.5 * from, 1.5 * from, 0},
           {1.5 - 1.5 * from, 1.5 - 1.5 * from, 2});
    renumber(model.mesh);
    model.parts = {metal(), metal()};
    model.parts[0].name = "plate";
    model.parts[1].name = "block";
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -1.99; }));
    if (quarter)
        for (std::size_t axis = 0; axis < 2; ++axis) {
            std::array<bool, 3> held{false, false, false};
            held[axis] = true;
            model.boundaryConditions.push_back(condition(
                BoundaryCondition::Kind::fixed, axis == 0 ? "mirrorX" : "mirrorY",
                nodesWhere(model.mesh, [&](Point p) { return std::abs(p[axis]) < 1e-9; }), held));
        }
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "block"), {0, 0, -4e4}});
    addContact(model, "touch", facing(model.mesh, "block", {0, 0, -1}),
               facing(model.mesh, "plate", {0, 0, 1}))
        .friction = 0.2;
    model.control.backend = "serial";
    return model;
}

/// How far the momentum of the block after its bounce is from four times that of a quarter of it.
double quarterError(ContactSearch search, double scale)
{
    double after[2];
    for (const bool quarter : {false, true}) {
        Model model = fallOnPlate(quarter);
        model.contactPairs[0].search = search;
        model.contactPairs[0].normalScale = scale;
        model.control.contactStepLimit = 0.3; // the error of springs alone, not that of their steps
        const auto solver = startedSolver(model);
        const std::vector<Index> block = nodesOfPart(model.mesh, "block");
        const double before = momentum(*solver, block)[2];
        solver->advance(8e-6, 100000);
        after[quarter ? 1 : 0] = (quarter ? 4 : 1) * momentum(*solver, block)[2];
        EXPECT_EQ(solver->contact().force(0).active, 0);
        EXPECT_GT(after[quarter ? 1 : 0], (quarter ? 4 : 1) * -0.5 * before);
    }
    return std::abs(after[1] / after[0] - 1);
}

TEST(ContactScenes, AQuarterModelIsTheWholeOneButForItsSprings)
{
    // Contactors lie exactly on edges and corners of faces, in the quarter on its rim. Those on the
    // mirrors have a whole spring for half a node: what differs goes with the springs' length.
    for (const ContactSearch search : {ContactSearch::faces, ContactSearch::closestParticle}) {
        const double soft = quarterError(search, 1), hard = quarterError(search, 30);
        EXPECT_LT(soft, 0.04);
        EXPECT_LT(hard, 0.3 * soft);
    }
}

/// A block pressed on another by a force that swings, and sheared to and fro beyond sticking.
TEST(ContactScenes, CyclicShearUnderChangingPressureOnlyLosesEnergy)
{
    for (const bool paper : {false, true}) {
        Model model;
        addBox(model.mesh, "lower", {3, 3, 1}, {-1, -1, -1}, {3, 3, 1});
        addBox(model.mesh, "upper", {2, 2, 1}, {-0.3, -0.4, -0.01}, {1.5, 1.5, 1});
        renumber(model.mesh);
        model.parts = {metal(), metal()};
        holdFixed(model, nodesOfPart(model.mesh, "lower"));
        Amplitude along{Amplitude::Kind::table, {{0, 0}}}, down = along;
        const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
        for (int n = 1; n <= 400; ++n) {
            along.rows.push_back({n * 1e-7, 0.02 * std::sin(0.05 * n)});
            down.rows.push_back({n * 1e-7, -0.008 * std::sin(0.13 * n)});
        }
        model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::displacement, "x",
                                                     upper, {true, true, false}, {1, 0.5, 0},
                                                     along));
        model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::displacement, "z",
                                                     upper, {false, false, true}, {0, 0, 1}, down));
        ContactPair& pair = addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                                       facing(model.mesh, "lower", {0, 0, 1}));
        pair.friction = 0.3;
        pair.paperFriction = paper;
        model.control.backend = "serial";
        model.control.fixedTimeStep = 5e-9;
        const auto solver = startedSolver(model);
        double last = 0, worst = 0;
        while (solver->clock().time < 4e-5) {
            solver->advance(4e-5, 20);
            const double lost = solver->ledger().energies().friction;
            EXPECT_GE(lost, last);
            last = lost;
            const Energies now = solver->ledger().energies();
            worst = std::max(worst, std::abs(now.balance));
        }
        EXPECT_GT(last, 0);
        EXPECT_LT(worst, 1e-9);
    }
}

} // namespace
} // namespace fpm::test
