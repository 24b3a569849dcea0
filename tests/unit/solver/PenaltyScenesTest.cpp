#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

constexpr double young = 70000, density = 2.7e-9;

Part elasticWithoutPoisson(const std::string& name)
{
    Part part = aluminium(PartKind::elastic, HourglassForm::stiffness, name);
    part.poissonsRatio = 0;
    return part;
}

/// `layers` loose layers of 1 x 1 x 0.5 on top of each other, each the contactor of the one below;
/// the lowest face is held. nu = 0: one-dimensional, known exactly.
Model stack(int layers, double scale)
{
    Model model;
    const auto name = [](int i) { return "layer" + std::to_string(i); };
    for (int i = 0; i < layers; ++i) {
        addBox(model.mesh, name(i), {1, 1, 2}, {0, 0, 0.5 * i}, {1, 1, 0.5});
        model.parts.push_back(elasticWithoutPoisson(name(i)));
    }
    renumber(model.mesh);
    for (int i = 1; i < layers; ++i)
        addContact(model, name(i), facing(model.mesh, name(i), {0, 0, -1}),
                   facing(model.mesh, name(i - 1), {0, 0, 1}))
            .normalScale = scale;
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < 1e-9; }));
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

std::vector<Index> topOf(const Model& model, int layers)
{
    return nodesWhere(model.mesh, [&](Point p) { return p[2] > 0.5 * layers - 1e-9; });
}

/// Mean of a component of the displacement.
double meanDisplacement(Solver& solver, const Model& model, const std::vector<Index>& nodes)
{
    const NodeValues values = solver.nodes().values(nodes);
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        sum += values.at(0, i)[2] - model.mesh.points[std::size_t(nodes[i])][2];
    return sum / double(nodes.size());
}

TEST(Penalty, StackOfLayersIsAsSoftAsItsLayersAndSpringsInSeries)
{
    const double load = 100, scale = 0.1;
    for (const int layers : {1, 2, 5}) {
        Model model = stack(layers, scale);
        const std::vector<Index> top = topOf(model, layers);
        model.boundaryConditions.push_back(
            condition(BoundaryCondition::Kind::force, "load", top, {false, false, true},
                      {0, 0, -load}, {Amplitude::Kind::smooth, {{0, 0}, {2e-5, 1}}}));
        model.control.massDamping = 1e6;
        const auto solver = startedSolver(model);
        solver->advance(1.5e-4, 1000000);

        // Logarithmic strain of the layers; four springs s K A^2 / V a joint, K = E / 3, h = 0.25.
        const double spring = scale * young / 3 / 0.25;
        const double exact =
            0.5 * layers * (1 - std::exp(-load / young)) + (layers - 1) * load / (4 * spring);
        EXPECT_NEAR(-meanDisplacement(*solver, model, top), exact, 2e-3 * exact)
            << layers << " layers";
    }
}

/// Two columns of 20 cells, the upper one falling at 10 m/s on the held one below.
Model twoColumns(double scale)
{
    Model model;
    addBox(model.mesh, "lower", {1, 1, 20}, {0, 0, -10}, {0.5, 0.5, 10});
    addBox(model.mesh, "upper", {1, 1, 20}, {0, 0, 1e-3}, {0.5, 0.5, 10});
    renumber(model.mesh);
    model.parts = {elasticWithoutPoisson("lower"), elasticWithoutPoisson("upper")};
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -9.99; }));
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "upper"), {0, 0, -1e4}});
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}))
        .normalScale = scale;
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

TEST(Penalty, NoStiffnessMakesEnergyAtTheStepTheSolverChooses)
{
    const double run = 10 / std::sqrt(young / density);
    for (const double scale : {1e-2, 0.1, 1.0, 10.0, 100.0}) {
        const auto solver = startedSolver(twoColumns(scale));
        double worst = 0;
        while (solver->clock().time < 6 * run) {
            solver->advance(6 * run, 100);
            ASSERT_EQ(solver->clock().failed, 0) << "scale " << scale;
            worst = std::max(worst, std::abs(solver->ledger().energies().balance));
        }
        EXPECT_LT(worst, 0.01) << "scale " << scale;
    }
}

TEST(Penalty, StiffestFixedStepIsTheBoundOfElementsAndSprings)
{
    // The step of an element alone is beyond the bound once a hard spring is near, and is refused.
    for (const double scale : {0.1, 10.0}) {
        const auto probe = startedSolver(twoColumns(scale));
        probe->advance(1, 2);
        const double bound = probe->clock().stableStep, element = probe->clock().elementStep;
        ASSERT_LT(bound, element);

        Model inside = twoColumns(scale);
        inside.control.fixedTimeStep = 0.99 * bound;
        const auto runs = startedSolver(inside);
        runs->advance(1, 200);
        EXPECT_EQ(runs->clock().failed, 0) << "scale " << scale;

        Model beyond = twoColumns(scale);
        beyond.control.fixedTimeStep = 1.01 * bound;
        const auto stops = startedSolver(beyond);
        stops->advance(1, 200);
        EXPECT_EQ(stops->clock().failed, 2) << "scale " << scale;
    }
}

TEST(Penalty, SlowPressingDoesNotChatter)
{
    // Two blocks of unlike meshes pressed together slowly: force about its own mean course.
    Model model;
    addBox(model.mesh, "lower", {5, 5, 3}, {0, 0, -3}, {5, 5, 3});
    addBox(model.mesh, "upper", {7, 7, 4}, {0, 0, 0}, {5, 5, 3});
    renumber(model.mesh);
    model.parts = {elasticWithoutPoisson("lower"), elasticWithoutPoisson("upper")};
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -2.99; }));
    const double end = 4e-4, depth = 0.01;
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::displacement, "press",
                  nodesWhere(model.mesh, [](Point p) { return p[2] > 2.99; }), {true, true, true},
                  {0, 0, -depth}, {Amplitude::Kind::smooth, {{0, 0}, {end, 1}}}));
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}));
    model.control.backend = "serial";
    model.control.endTime = 1;
    const auto solver = startedSolver(model);
    const BoundaryCondition& press = model.boundaryConditions.back();
    std::vector<double> ratios; // force over travel, from a tenth of the way on
    while (solver->clock().time < end) {
        solver->advance(end, 20);
        const double travel = depth * press.amplitude(solver->clock().time);
        if (travel > 0.1 * depth) ratios.push_back(solver->contact().force(0).force[2] / travel);
    }
    const double atRest = ratios.back();
    double squares = 0;
    for (const double ratio : ratios) squares += std::pow(ratio / atRest - 1, 2);
    ASSERT_GT(ratios.size(), 50U);
    EXPECT_LT(std::sqrt(squares / double(ratios.size())), 0.01);
    // No stiffer than the two columns without any joint, no softer than with one cell's springs.
    const double columns = young * 25 / 6;
    EXPECT_LT(atRest, columns);
    EXPECT_GT(atRest, 0.8 * columns);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
}

/// With `penalty mass` nothing resists where neither side can move: no force, and no number lost.
TEST(Penalty, MassOfSidesThatCannotMoveIsNoSpring)
{
    Model model = twoBlocks(elasticWithoutPoisson("upper"), elasticWithoutPoisson("lower"),
                            {0, 0, 0}, 0.3, -0.01);
    model.parts[0].kind = PartKind::rigidPrescribed;
    holdFixed(model, nodesOfPart(model.mesh, "lower"));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < 0 && p[2] > -0.5; }));
    model.contactPairs[0].penalty = PenaltyRule::mass;
    const auto solver = startedSolver(model);
    solver->advance(1, 20);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_EQ(solver->ledger().energies().contact, 0);
    EXPECT_EQ(solver->ledger().energies().balance, 0);
}

TEST(Penalty, RunsRepeatThemselves)
{
    const Model model =
        twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {4e4, -2e4, -4e4}, 0.3);
    std::vector<std::uint64_t> sums;
    for (int run = 0; run < 2; ++run) {
        const auto solver = startedSolver(model);
        solver->advance(1, 300);
        sums.push_back(stateChecksum(*solver));
    }
    EXPECT_EQ(sums[0], sums[1]);
}

} // namespace
} // namespace fpm::test
