#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace fpm::test {
namespace {

/// An elastic bar of unit cubes along x, nu = 0, free at both ends and started in its first mode.
Model freeBar(double amplitude)
{
    Part part = aluminium(PartKind::elastic, HourglassForm::stiffness);
    part.poissonsRatio = 0;
    part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    Model model = boxModel({20, 1, 1}, {20, 1, 1}, part);
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i)
        model.initialVelocities.push_back(
            {"",
             {Index(i)},
             {amplitude * std::cos(std::numbers::pi * model.mesh.points[i][0] / 20), 0, 0}});
    return model;
}

Index endNode(const Mesh& mesh)
{
    return nodesWhere(mesh, [](Point p) { return p[0] < 0.01; })[0];
}

/// Time between the first and the last upward crossing of u_x of the end, per period.
double period(Solver& solver, Index node, int periods, double rest)
{
    double first = -1, last = -1, before = 0;
    int crossings = 0;
    while (crossings <= periods) {
        const double start = solver.clock().time;
        solver.advance(1, 1);
        const double u = solver.nodes().values({node}).at(0, 0)[0] - rest;
        if (before < 0 && u >= 0) {
            const double at = start + (solver.clock().time - start) * before / (before - u);
            if (first < 0) first = at;
            last = at;
            ++crossings;
        }
        before = u;
    }
    return (last - first) / periods;
}

TEST(BarVibration, FrequencyIsThatOfTheMassesAndTheLeapfrog)
{
    Model model = freeBar(10);
    const double dt = 8e-8;
    model.control.fixedTimeStep = dt;
    const Index node = endNode(model.mesh);
    const auto solver = startedSolver(model);
    const double measured = period(*solver, node, 10, model.mesh.points[std::size_t(node)][0]);

    // Chain of equal masses and springs: omega_h = 2 c / h sin(k h / 2), k = pi / L; the central
    // differences turn it into omega: sin(omega dt / 2) = omega_h dt / 2.
    const double c = std::sqrt(70000 / 2.7e-9);
    const double chain = 2 * c * std::sin(std::numbers::pi / 40);
    const double omega = 2 / dt * std::asin(chain * dt / 2);
    EXPECT_NEAR(measured, 2 * std::numbers::pi / omega, 2e-5 * measured);
    // The bar itself: a mesh of twenty is 1e-3 away.
    EXPECT_NEAR(measured, 40 / c, 2e-3 * measured);
}

TEST(BarVibration, EnergyDoesNotDriftOverTenThousandSteps)
{
    const Model model = freeBar(1000);
    const auto solver = startedSolver(model);
    const double start = solver->ledger().energies().total;
    double worst = 0;
    for (int call = 0; call < 20; ++call) {
        solver->advance(1, 500);
        worst = std::max(worst, std::abs(solver->ledger().energies().total / start - 1));
    }
    EXPECT_EQ(solver->clock().steps, 10000);
    EXPECT_LT(worst, 2e-3); // breathing of the sum with the step, no growth
    EXPECT_NEAR(solver->ledger().energies().total, start, 1e-3 * start);
}

TEST(BarVibration, TimeStepOutsideTheBoundIsSeenInTheEnergy)
{
    Model model = freeBar(1000);
    const auto bound = startedSolver(model);
    bound->advance(1, 1);
    model.control.fixedTimeStep = 2 * bound->clock().elementStep;
    const auto solver = startedSolver(model);
    solver->advance(1, 400);
    EXPECT_TRUE(solver->clock().failed || std::abs(solver->ledger().energies().balance) > 1);
}

} // namespace
} // namespace fpm::test
