#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <random>

namespace fpm::test {
namespace {

using Kind = BoundaryCondition::Kind;

Model block(std::array<Index, 3> cells = {3, 2, 2}, Point size = {3, 2, 2})
{
    Model model = boxModel(cells, size, aluminium(PartKind::elastic, HourglassForm::physical));
    model.control.massDamping = 0;
    return model;
}

BoundaryCondition sideLoad(Kind kind, const Mesh& mesh, Point direction, Point value)
{
    BoundaryCondition load = condition(kind, "load", {}, {true, true, true}, value);
    load.sides = direction == Point{0, 0, 0} ? skin(mesh, 0) : facing(mesh, "box", direction);
    load.nodes = nodesOf(mesh, load.sides);
    return load;
}

BoundaryCondition gravity(const Mesh& mesh, Point value)
{
    BoundaryCondition load = condition(Kind::gravity, "gravity", {}, {true, true, true}, value);
    for (Index part = 0; part < Index(mesh.parts.size()); ++part) load.parts.push_back(part);
    for (Index node = 0; node < Index(mesh.points.size()); ++node) load.nodes.push_back(node);
    return load;
}

struct Sum {
    Point force{0, 0, 0}, moment{0, 0, 0};
    double largest = 0;
};

/// Of what acts on the nodes, about the origin.
Sum sumOfForces(Solver& solver)
{
    Sum sum;
    const NodeValues values = solver.nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i) {
        const Point x = values.at(0, i), f = values.at(3, i);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
            sum.force[c] += f[c];
            sum.moment[c] += x[d] * f[e] - x[e] * f[d];
            sum.largest = std::max(sum.largest, std::abs(f[c]));
        }
    }
    return sum;
}

TEST(Loads, PressureOnAClosedBodyHasNoForceAndNoMoment)
{
    Model model = block({4, 3, 3}, {4, 3, 3});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    for (Point& point : model.mesh.points)
        for (double& x : point) x += jitter(random);
    model.boundaryConditions.push_back(sideLoad(Kind::pressure, model.mesh, {0, 0, 0}, {50, 0, 0}));
    const auto solver = startedSolver(model);
    const Sum sum = sumOfForces(*solver);
    EXPECT_GT(sum.largest, 10);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(sum.force[c], 0, 1e-12 * sum.largest);
        EXPECT_NEAR(sum.moment[c], 0, 1e-11 * sum.largest);
    }
}

TEST(Loads, PressureAllRoundIsAUniformStress)
{
    Model model = block();
    BoundaryCondition load = sideLoad(Kind::pressure, model.mesh, {0, 0, 0}, {70, 0, 0});
    load.amplitude = {Amplitude::Kind::smooth, {{0, 0}, {2e-5, 1}}};
    model.boundaryConditions.push_back(load);
    model.control.massDamping = 2e6;
    const auto solver = startedSolver(model);
    solver->advance(8e-5, 1000000);
    const ElementValues values = solver->elements().values();
    for (std::size_t i = 0; i < values.stress.size(); ++i)
        EXPECT_NEAR(values.stress[i], i % 6 < 3 ? -70 : 0, 0.02);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
}

TEST(Loads, PressureFollowsTheFacesItPressesOn)
{
    // The block turns by 90 degrees about z; the pressure on its +x side turns with it.
    Model model = block();
    BoundaryCondition turn =
        condition(Kind::rotation, "turn", nodesOfPart(model.mesh, "box"), {true, true, true});
    turn.line = {Point{0, 0, 0}, Point{0, 0, 1}};
    turn.angle = 90;
    turn.amplitude = {Amplitude::Kind::smooth, {{0, 0}, {1e-4, 1}}};
    model.boundaryConditions.push_back(turn);
    model.boundaryConditions.push_back(sideLoad(Kind::pressure, model.mesh, {1, 0, 0}, {50, 0, 0}));
    const auto solver = startedSolver(model);
    EXPECT_NEAR(sumOfForces(*solver).force[0], -50 * 4, 1e-9);
    solver->advance(1e-4, 1000000);
    EXPECT_NEAR(sumOfForces(*solver).force[0], 0, 1e-5);
    EXPECT_NEAR(sumOfForces(*solver).force[1], -50 * 4, 1e-5);
}

TEST(Loads, WeightOfABlockIsTheReactionOfItsBase)
{
    Model model = block();
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < 0.01; }));
    BoundaryCondition load = gravity(model.mesh, {0, 0, -9.81e6});
    load.amplitude = {Amplitude::Kind::smooth, {{0, 0}, {2e-5, 1}}};
    model.boundaryConditions.push_back(load);
    model.control.massDamping = 2e6;
    const auto solver = startedSolver(model);
    solver->advance(1.5e-4, 1000000);
    const NodeValues base = solver->nodes().values(model.boundaryConditions[0].nodes);
    double reaction = 0;
    for (std::size_t i = 0; i < base.count; ++i) reaction -= base.at(3, i)[2];
    const double weight = 2.7e-9 * 12 * 9.81e6;
    EXPECT_NEAR(reaction, weight, 1e-4 * weight);
}

TEST(Loads, GravityIsTheSameAccelerationEverywhere)
{
    Model model = block();
    model.boundaryConditions.push_back(gravity(model.mesh, {100, 0, -9810}));
    const auto solver = startedSolver(model);
    solver->advance(1e-4, 1000000);
    const NodeValues values = solver->nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i) {
        EXPECT_NEAR(values.at(2, i)[2], -9810, 1e-4);
        EXPECT_NEAR(values.at(1, i)[0], 0.01, 1e-10);
    }
}

TEST(Loads, TractionIsSharedAsTheFacesAre)
{
    // Faces 1 and 2 wide: a quarter of each goes to each of its corners.
    Model model = block({2, 1, 1}, {2, 1, 1});
    for (Point& p : model.mesh.points)
        if (p[0] > 1.5) p[0] = 3;
    model.boundaryConditions.push_back(sideLoad(Kind::traction, model.mesh, {0, 0, 1}, {8, 0, 0}));
    const auto solver = startedSolver(model);
    const NodeValues values = solver->nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i) {
        const Point x = values.at(0, i);
        const double wanted = x[2] < 0.5 ? 0 : x[0] < 0.5 ? 2 : x[0] < 1.5 ? 6 : 4;
        EXPECT_NEAR(values.at(3, i)[0], wanted, 1e-13);
    }
    EXPECT_NEAR(sumOfForces(*solver).force[0], 24, 1e-12);
}

TEST(Loads, ForceByAreaKeepsItsTotal)
{
    Model model = block({2, 1, 1}, {2, 1, 1});
    for (Point& p : model.mesh.points)
        if (p[0] > 1.5) p[0] = 3;
    model.boundaryConditions.push_back(sideLoad(Kind::force, model.mesh, {0, 0, 1}, {0, 0, 12}));
    const auto solver = startedSolver(model);
    const NodeValues values = solver->nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i) {
        const Point x = values.at(0, i);
        const double wanted = x[2] < 0.5 ? 0 : x[0] < 0.5 ? 1 : x[0] < 1.5 ? 3 : 2;
        EXPECT_NEAR(values.at(3, i)[2], wanted, 1e-13);
    }
}

/// Steel-like cube in free rotation, ten turns: angular momentum and energy stay.
TEST(Loads, AnInitialRotationOfADeformableCubeGoesOn)
{
    Model model = block({2, 2, 2}, {2, 2, 2});
    InitialVelocity spin;
    spin.nodes = nodesOfPart(model.mesh, "box");
    spin.rotates = true;
    spin.centre = {1, 1, 1};
    spin.spin = {0, 0, 2e5};
    model.initialVelocities.push_back(spin);
    const auto solver = startedSolver(model);
    const auto angular = [&] {
        const NodeValues values = solver->nodes().values({});
        double sum = 0;
        for (std::size_t i = 0; i < values.count; ++i) {
            const Point x = values.at(0, i), v = values.at(1, i);
            sum += solver->nodes().setUp().mass[i] * (x[0] * v[1] - x[1] * v[0]);
        }
        return sum;
    };
    const double start = angular(), energy = solver->ledger().energies().total;
    EXPECT_GT(start, 0);
    solver->advance(10 * 2 * 3.14159265 / 2e5, 1000000);
    EXPECT_NEAR(angular(), start, 1e-3 * start);
    EXPECT_NEAR(solver->ledger().energies().total, energy, 1e-3 * energy);
}

} // namespace
} // namespace fpm::test
