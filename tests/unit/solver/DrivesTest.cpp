#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

using Kind = BoundaryCondition::Kind;

Model bar()
{
    Part part = aluminium(PartKind::elastic, HourglassForm::physical);
    part.poissonsRatio = 0;
    // One cell across: equal shares of a load are a uniform stress.
    return boxModel({6, 1, 1}, {6, 2, 2}, part);
}
std::vector<Index> leftEnd(const Mesh& mesh)
{
    return nodesWhere(mesh, [](Point p) { return p[0] < 0.01; });
}
std::vector<Index> rightEnd(const Mesh& mesh)
{
    return nodesWhere(mesh, [](Point p) { return p[0] > 5.99; });
}
double reaction(Solver& solver, const std::vector<Index>& nodes)
{
    double sum = 0;
    const NodeValues values = solver.nodes().values(nodes);
    for (std::size_t i = 0; i < values.count; ++i) sum -= values.at(3, i)[0];
    return sum;
}

TEST(Drives, PrescribedDisplacementIsTrackedExactly)
{
    Model model = bar();
    const Amplitude smooth{Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}, {2e-5, -0.5}}};
    model.boundaryConditions.push_back(condition(Kind::displacement, "pull", rightEnd(model.mesh),
                                                 {true, false, false}, {0.02, 0, 0}, smooth));
    holdFixed(model, leftEnd(model.mesh));
    const auto solver = startedSolver(model);
    for (int call = 0; call < 40; ++call) {
        solver->advance(3e-5, 7);
        const double wanted = 0.02 * smooth(solver->clock().time);
        const NodeValues values = solver->nodes().values(rightEnd(model.mesh));
        for (std::size_t i = 0; i < values.count; ++i)
            EXPECT_NEAR(values.at(0, i)[0] - 6, wanted, 1e-13);
    }
}

TEST(Drives, PrescribedVelocityIsThatOfTheMiddleOfTheStep)
{
    Model model = bar();
    const Amplitude ramp{Amplitude::Kind::table, {{0, 0}, {1e-5, 1}}};
    model.boundaryConditions.push_back(condition(Kind::velocity, "pull", rightEnd(model.mesh),
                                                 {true, false, false}, {500, 0, 0}, ramp));
    const auto solver = startedSolver(model);
    solver->advance(1e-5, 1000);
    // A linear ramp is integrated exactly by its mid-step values.
    for (const Index node : rightEnd(model.mesh))
        EXPECT_NEAR(solver->nodes().values({node}).at(0, 0)[0] - 6, 500 * 1e-5 / 2, 1e-13);
}

TEST(Drives, ABodyDrivenFromTheStartIsNotStruck)
{
    const double energy = 0.5 * 2.7e-9 * 24 * 500 * 500;
    for (const Kind kind : {Kind::velocity, Kind::displacement}) {
        Model model = bar();
        const std::vector<Index> everyNode = nodesWhere(model.mesh, [](Point) { return true; });
        const Amplitude amplitude = kind == Kind::velocity
                                        ? Amplitude{Amplitude::Kind::table, {{0, 1}}}
                                        : Amplitude{Amplitude::Kind::table, {{0, 0}, {1e-3, 1e-3}}};
        model.boundaryConditions.push_back(
            condition(kind, "drive", everyNode, {true, false, false}, {500, 0, 0}, amplitude));
        const auto solver = startedSolver(model);
        EXPECT_NEAR(solver->ledger().energies().kinetic, energy, 1e-9 * energy);
        solver->advance(1e-6, 5);
        EXPECT_NEAR(solver->ledger().energies().kinetic, energy, 1e-9 * energy);
        EXPECT_NEAR(solver->ledger().energies().external, 0, 1e-9 * energy);
    }
}

TEST(Drives, ReactionEqualsTheLoadAtRest)
{
    Model model = bar();
    const std::vector<Index> held = leftEnd(model.mesh);
    holdFixed(model, held);
    model.boundaryConditions.push_back(condition(Kind::force, "load", rightEnd(model.mesh),
                                                 {true, false, false}, {400, 0, 0},
                                                 {Amplitude::Kind::smooth, {{0, 0}, {5e-5, 1}}}));
    model.control.massDamping = 1e6; // about the first frequency of the bar: comes to rest
    const auto solver = startedSolver(model);
    solver->advance(2e-4, 1000000);
    EXPECT_NEAR(reaction(*solver, held), -400, 0.01);
    // F L / (E A): 400 N over 4 mm2, 6 mm.
    const double stretch = 400.0 / 4 / 70000 * 6;
    for (const Index node : rightEnd(model.mesh))
        EXPECT_NEAR(solver->nodes().values({node}).at(0, 0)[0] - 6, stretch, 5e-3 * stretch);
    // Work of the load: all of it is stored or was damped.
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
}

TEST(Drives, DrivenEndNeedsTheForceOfTheBar)
{
    Model model = bar();
    const std::vector<Index> pulled = rightEnd(model.mesh);
    holdFixed(model, leftEnd(model.mesh));
    model.boundaryConditions.push_back(condition(Kind::displacement, "pull", pulled,
                                                 {true, false, false}, {0.006, 0, 0},
                                                 {Amplitude::Kind::smooth, {{0, 0}, {5e-5, 1}}}));
    model.control.massDamping = 1e6;
    const auto solver = startedSolver(model);
    solver->advance(2e-4, 1000000);
    EXPECT_NEAR(reaction(*solver, pulled), 0.001 * 70000 * 4, 0.005 * 280);
    EXPECT_NEAR(solver->ledger().energies().external,
                solver->ledger().energies().internal + solver->ledger().energies().damping,
                0.01 * solver->ledger().energies().external);
}

TEST(Drives, LoadInProportionToTheMassIsGravity)
{
    Model model = bar();
    const double g = 9810;
    const SolverSetUp data = makeSetUp(model);
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i)
        model.boundaryConditions.push_back(condition(Kind::force, "weight", {Index(i)},
                                                     {false, false, true},
                                                     {0, 0, -g * data.nodes.mass[i]}));
    const auto solver = startedSolver(model);
    const double t = 1e-4;
    solver->advance(t, 1000000);
    const NodeValues values = solver->nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i) {
        EXPECT_NEAR(values.at(2, i)[2], -g, 1e-6 * g);
        EXPECT_NEAR(values.at(1, i)[2], -g * t, 1e-9 * g * t);
        EXPECT_NEAR(values.at(0, i)[2] - model.mesh.points[i][2], -g * t * t / 2, 1e-9);
    }
    EXPECT_LT(largestStress(*solver), 1e-6);
    // The kinetic energy 1/2 m v^(n-1/2) . v^(n+1/2) lacks (dt / 2 t)^2.
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-6);
}

TEST(Drives, MassDampingSlowsAFreeBlock)
{
    Model model = bar();
    model.control.massDamping = 1e4;
    model.initialVelocities.push_back({"", nodesOfPart(model.mesh, "box"), {1000, 0, 0}});
    const auto solver = startedSolver(model);
    solver->advance(1e-4, 1000000);
    const double expected = 1000 * std::exp(-1.0);
    EXPECT_NEAR(solver->nodes().values({0}).at(1, 0)[0], expected, 1e-3 * expected);
    // Damping is booked a step at a time: the ledger is exact to the order xi dt.
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 2e4 * solver->clock().step);
}

} // namespace
} // namespace fpm::test
