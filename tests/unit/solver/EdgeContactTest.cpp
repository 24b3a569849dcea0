#include "unit/solver/edgeScenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

double meanVelocity(Solver& solver, const Model& model, const std::string& part)
{
    const std::vector<Index> nodes = nodesOfPart(model.mesh, part);
    double mass = 0;
    for (const Index node : nodes) mass += solver.nodes().setUp().mass[std::size_t(node)];
    return momentum(solver, nodes)[2] / mass;
}

/// Two cubes of steel meet edge on edge at 2 m/s. Springs so soft that they swing as rigid bodies
/// part with the speed they met with; the impulse is 2 m* v, m* half of their mass.
TEST(EdgeContact, FreeCubesPartWithTheSpeedTheyMetWith)
{
    for (const Index cells : {1, 3}) { // the crossing in the middle of segments
        Model model = crossedRoofs({cells, cells}, 10, 0.01, {0, 0, -2000});
        model.contactPairs[0].normalScale = 1e-3;
        const auto solver = startedSolver(model, true);
        const Point before = momentum(*solver), spin = angularMomentum(*solver);
        solver->advance(1e-4, 1000000);
        EXPECT_GT(solver->contact().force(0).active, 0) << cells;
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3) << cells;
        solver->advance(4e-4, 1000000);
        EXPECT_EQ(solver->contact().force(0).active, 0) << cells;
        EXPECT_NEAR(meanVelocity(*solver, model, "high"), 0, 2) << cells;
        EXPECT_NEAR(meanVelocity(*solver, model, "low"), -2000, 2) << cells;
        const Point after = momentum(*solver), turned = angularMomentum(*solver);
        const double scale = lengthOf(before);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(after[c], before[c], 1e-12 * scale) << cells;
            EXPECT_NEAR(turned[c], spin[c], 1e-10 * scale * 10) << cells;
        }
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3) << cells;
        EXPECT_EQ(solver->contact().force(0).released, 0);
    }
}

/// Off the middle, with spin: momenta and energy are kept.
TEST(EdgeContact, KeepsMomentaAndEnergyOffTheMiddle)
{
    Model model = crossedRoofs({3, 3}, 10, 0.01, {300, -200, -2000});
    for (const Index node : nodesOfPart(model.mesh, "high"))
        for (std::size_t c = 0; c < 2; ++c)
            model.mesh.points[std::size_t(node)][c] += c ? 1.7 : 2.1;
    model.contactPairs[0].normalScale = 0.01;
    const auto solver = startedSolver(model, true);
    const Point before = momentum(*solver), spin = angularMomentum(*solver);
    const double scale = lengthOf(before);
    solver->advance(1.5e-4, 1000000);
    EXPECT_GT(meanVelocity(*solver, model, "high"), -1600);
    const Point after = momentum(*solver), turned = angularMomentum(*solver);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(after[c], before[c], 1e-12 * scale);
        EXPECT_NEAR(turned[c], spin[c], 1e-10 * scale * 10);
    }
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
}

/// Two wires of 1 x 1 x 60 mm cross on their edges, one held, the other thrown onto it at 5 m/s: it
/// bends and comes back.
TEST(EdgeContact, AWireThatIsThrownOnAnotherComesBack)
{
    Model model;
    const double half = std::sqrt(0.5);
    addRoof(model.mesh, "low", 0, {6, 1}, {60, 1}, -half);
    addRoof(model.mesh, "high", 1, {6, 1}, {60, 1}, half + 0.1);
    for (const Index node : nodesOfPart(model.mesh, "high"))
        for (std::size_t c = 0; c < 2; ++c) model.mesh.points[std::size_t(node)][c] += 5;
    renumber(model.mesh);
    model.parts = {steel("low"), steel("high")};
    throwPart(model, "high", {0, 0, -5000});
    holdFixed(model, nodesOfPart(model.mesh, "low"));
    addGeneral(model).edges = true;
    model.control.backend = "serial";
    model.control.endTime = 1;
    model.control.fixedTimeStep = 2.5e-8; // leapfrog errs by its square, 1 % at 1e-7
    const auto solver = startedSolver(model, true);
    double deepest = 0;
    for (int call = 0; call < 250; ++call) {
        solver->advance(4e-6 * (call + 1), 100000);
        deepest = std::max(deepest, solver->contact().status(0).maxDepth);
        ASSERT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
    }
    EXPECT_GT(deepest, 0);
    EXPECT_LT(deepest, 0.01); // of a millimetre
    EXPECT_GT(meanVelocity(*solver, model, "high"), 1000);
    EXPECT_EQ(solver->contact().force(0).released, 0);
}

/// Without it they pass: no node meets a face.
TEST(EdgeContact, IsWhatHoldsCrossedEdges)
{
    Model model = crossedRoofs({1, 1}, 10, 0.01, {0, 0, -2000});
    model.contactPairs[0].edges = false;
    const auto solver = startedSolver(model);
    solver->advance(1e-4, 1000000);
    EXPECT_EQ(solver->contact().force(0).active, 0);
    EXPECT_NEAR(meanVelocity(*solver, model, "high"), -2000, 1e-6);
}

/// Two roofs whose nodes are all driven: "high" goes with a velocity, "low" is at rest. Only the
/// nodes of the roof whose joints are not passed over are contactors, and meet no face.
Model drivenRoofs(Point velocity, double friction)
{
    Model model = crossedRoofs({6, 1}, 30, 0.001, {0, 0, 0});
    for (const Index node : nodesOfPart(model.mesh, "high"))
        for (std::size_t c = 0; c < 2; ++c) model.mesh.points[std::size_t(node)][c] += 0.3;
    model.initialVelocities.clear();
    model.mesh.contact.clear();
    model.contactPairs.clear();
    const Index contactor = velocity[0] != 0;
    addContact(model, "edges", skin(model.mesh, contactor), skin(model.mesh, 1 - contactor)).edges =
        true;
    holdFixed(model, nodesOfPart(model.mesh, "low"));
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "drive",
                                                 nodesOfPart(model.mesh, "high"),
                                                 {true, true, true}, velocity));
    model.contactPairs[0].friction = friction;
    model.control.fixedTimeStep = 1e-7;
    return model;
}

/// K A^2 / V of the two sides at the edge, alike.
double stiffnessOf()
{
    return 210000 / (3 * (1 - 2 * 0.3)) * 5; // A 50, V 500, mean of equal sides
}

TEST(EdgeContact, SlidesAlongEdgesAndOverTheirJointsWithTheFrictionOfCoulomb)
{
    const double mu = 0.3, step = 1e-7;
    for (const Point& velocity : {Point{2e4, 0, -200}, Point{0, -2e4, -200}}) {
        const Model model = drivenRoofs(velocity, mu);
        const auto solver = startedSolver(model);
        const double speed = std::hypot(velocity[0], velocity[1]);
        double last = 0, lastFriction = 0;
        int sliding = 0;
        while (solver->clock().time < 6e-4) { // 12 mm: over the joints at 0, 5 and 10 mm
            solver->advance(1, 1);
            const double depth = 200 * solver->clock().time - 0.001;
            const PairForce force = solver->contact().force(0);
            if (depth < 0) {
                EXPECT_EQ(force.active, 0);
                continue;
            }
            EXPECT_LE(force.active, 1);
            const double normal = std::abs(force.force[2]);
            EXPECT_NEAR(normal, stiffnessOf() * depth, 1e-6 * stiffnessOf());
            EXPECT_LT(std::abs(normal - last), stiffnessOf() * 200 * step * 1.001);
            last = normal;
            const double along =
                std::abs(force.force[0] * velocity[0] + force.force[1] * velocity[1]) / speed;
            const double across =
                std::abs(force.force[0] * velocity[1] - force.force[1] * velocity[0]) / speed;
            EXPECT_LE(along, mu * normal * (1 + 1e-9) + 1e-9);
            EXPECT_LT(across, 1e-6 * normal + 1e-9);
            // No more than the stiffness times the motion.
            EXPECT_LT(std::abs(along - lastFriction), 0.8 * stiffnessOf() * speed * step * 1.001);
            lastFriction = along;
            if (depth > 0.02) {
                EXPECT_NEAR(along, mu * normal, 1e-6 * normal);
                ++sliding;
            }
        }
        EXPECT_GT(sliding, 1000);
        EXPECT_GT(solver->ledger().energies().friction, 0);
        EXPECT_EQ(solver->contact().force(0).overEdge, 0);
    }
}

/// Blocks that lie flat on each other: nodes bear them, and edges add nothing.
TEST(EdgeContact, AddsNothingWhereNodesBear)
{
    std::vector<double> forces;
    for (const bool edges : {false, true}) {
        Model model = twoBlocks(metal(), metal(), {0, 0, -2e4}, 0, 1e-3);
        model.contactPairs.clear();
        model.mesh.contact.clear();
        addGeneral(model).edges = edges;
        const auto solver = startedSolver(model);
        solver->advance(2e-6, 100000);
        EXPECT_GT(solver->contact().force(0).active, 0);
        if (edges) {
            ASSERT_EQ(solver->contact().setUp().passes.size(), 2u);
            EXPECT_EQ(solver->contact().sumsOf(1)[sumTouching], 0);
        }
        forces.push_back(solver->contact().force(0).springEnergy);
    }
    EXPECT_NEAR(forces[1], forces[0], 0.02 * forces[0]); // the steps may differ
}

TEST(EdgeContact, TheMirrorImageMovesAsTheMirrorImage)
{
    const auto states = [](bool image) {
        Model model = slidingRoofs();
        if (image) {
            for (Point& p : model.mesh.points) p[0] = -p[0];
            for (Hexahedron& h : model.mesh.hexahedra)
                for (std::size_t k = 0; k < 4; ++k) std::swap(h[k], h[k + 4]);
            // Turned inside out by the image, right again by the swap of its two ends.
            model.initialVelocities[0].velocity[0] *= -1;
            std::vector<ElementSide> sides;
            for (std::size_t part = 0; part < 2; ++part)
                for (const ElementSide& side : skin(model.mesh, Index(part))) sides.push_back(side);
            std::sort(sides.begin(), sides.end());
            model.mesh.contact[0].contactorSides = model.mesh.contact[0].targetSides = sides;
            model.contactPairs[0].targetSides = sides;
        }
        const auto solver = startedSolver(model);
        solver->advance(1e-5, 100000);
        EXPECT_GT(solver->contact().sumsOf(1)[sumTouching], 0);
        return momentum(*solver, nodesOfPart(model.mesh, "high"));
    };
    const Point one = states(false), other = states(true);
    const double scale = lengthOf(one);
    EXPECT_NEAR(other[0], -one[0], 1e-9 * scale);
    EXPECT_NEAR(other[1], one[1], 1e-9 * scale);
    EXPECT_NEAR(other[2], one[2], 1e-9 * scale);
}

TEST(EdgeContact, OfAPairHasOnlyEdgesOfTheTwoSurfaces)
{
    Model model = crossedRoofs({3, 2}, 30, 0.01, {0, 0, -2000});
    model.mesh.contact.clear();
    model.contactPairs.clear();
    addContact(model, "pair", skin(model.mesh, 1), skin(model.mesh, 0)).edges = true;
    const auto solver = startedSolver(model);
    const ContactPassSetup& edges = solver->contact().setUp().passes.back();
    EXPECT_TRUE(edges.ofEdges);
    EXPECT_EQ(edges.nodeCount, edges.firstTarget);
    EXPECT_EQ(edges.nodeCount, 4 * (3 + 2 + 2));
    solver->advance(8e-6, 100000);
    EXPECT_GT(solver->contact().force(0).active, 0);
    EXPECT_GT(solver->contact().force(0).force[2], 0); // on the contactor, which is above
}

TEST(EdgeContact, AnOverlapAtTheStartIsToldAndForgiven)
{
    Model model = crossedRoofs({3, 2}, 30, -0.02, {0, 0, 0});
    model.initialVelocities.clear();
    for (const InitialOverlap kind : {InitialOverlap::offset, InitialOverlap::report}) {
        model.contactPairs[0].initialOverlap = kind;
        const auto solver = startedSolver(model);
        EXPECT_EQ(solver->contact().initialOverlap(0).count, 1);
        EXPECT_NEAR(solver->contact().initialOverlap(0).deepest, 0.02, 1e-6);
        const double stiffness = 210000 / (3 * (1 - 2 * 0.3)) * 10; // A 50, V 250
        EXPECT_NEAR(solver->contact().force(0).springEnergy,
                    kind == InitialOverlap::report ? 0.5 * stiffness * 0.02 * 0.02 : 0,
                    1e-6 * stiffness * 0.02 * 0.02);
    }
}

} // namespace
} // namespace fpm::test
