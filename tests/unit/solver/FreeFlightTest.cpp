#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace fpm::test {
namespace {

Point midStepAngularMomentum(Solver& solver)
{
    const std::vector<Point> v = halfStepVelocities(solver);
    const NodeValues values = solver.nodes().values({});
    const double half = 0.5 * solver.clock().step;
    Point sum{0, 0, 0};
    for (std::size_t i = 0; i < v.size(); ++i) {
        // Positions at the time of the velocities, half a step back.
        Point x = values.at(0, i);
        for (std::size_t c = 0; c < 3; ++c) x[c] -= half * v[i][c];
        const double m = solver.nodes().setUp().mass[i];
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t a = (c + 1) % 3, b = (c + 2) % 3;
            sum[c] += m * (x[a] * v[i][b] - x[b] * v[i][a]);
        }
    }
    return sum;
}

/// Velocity of every node from a field.
void setVelocity(Model& model, const std::function<Point(Point)>& field)
{
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i)
        model.initialVelocities.push_back({"", {Index(i)}, field(model.mesh.points[i])});
}

TEST(FreeFlight, TranslationLeavesNoStressAndKeepsMomentum)
{
    for (const HourglassForm form :
         {HourglassForm::stiffness, HourglassForm::viscous, HourglassForm::physical}) {
        Model model = boxModel({3, 4, 5}, {3, 4, 5}, aluminium(PartKind::elastic, form));
        setVelocity(model, [](Point) { return Point{3e4, -7e4, 1e5}; });
        const auto solver = startedSolver(model);
        const Point before = momentum(*solver);
        solver->advance(1, 2000);
        const Point after = momentum(*solver);
        // Coordinates of the flight (40 mm) are rounded to 4e-15, strain to 1e-15 a step.
        EXPECT_LT(largestStress(*solver), 1e-6 * 285);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], 1e-12 * 1e5);
        EXPECT_NEAR(solver->ledger().energies().balance, 0, 1e-12);
    }
}

TEST(FreeFlight, SpinningBlockIsStretchedByItsSpinOnlyAndKeepsItsMomenta)
{
    Part part = aluminium(PartKind::elastic, HourglassForm::physical);
    part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    Model model = boxModel({4, 4, 3}, {4, 4, 3}, part);
    const double spin = 2e4; // rad/s about z through the centre
    setVelocity(model, [&](Point p) { return Point{-spin * (p[1] - 2), spin * (p[0] - 2), 0}; });
    const auto solver = startedSolver(model);
    const Point linear = momentum(*solver), angular = midStepAngularMomentum(*solver);
    const double turn = 2 * std::numbers::pi / spin;
    solver->advance(turn / 4, 1000000);
    const Point linearAfter = momentum(*solver), angularAfter = midStepAngularMomentum(*solver);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(linearAfter[c], linear[c], 1e-12 * std::abs(angular[2]));
        EXPECT_NEAR(angularAfter[c], angular[c], 1e-6 * angular[2]);
    }
    // Centrifugal stress is of the order rho (omega r)^2, twice that while the block breathes.
    const double centrifugal = 2.7e-9 * std::pow(spin * 2 * std::sqrt(2.0), 2);
    EXPECT_LT(largestStress(*solver), 3 * centrifugal);
    EXPECT_NEAR(solver->ledger().energies().balance, 0, 1e-4);

    // A quarter of a turn takes (4, 2) to (2, 4), up to the centrifugal stretch.
    Index corner = 0;
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const Point& p = model.mesh.points[i];
        if (p[0] > 3.99 && std::abs(p[1] - 2) < 0.01 && p[2] < 0.01) corner = Index(i);
    }
    const Point at = solver->nodes().values({corner}).at(0, 0);
    EXPECT_NEAR(at[0], 2, 1e-3);
    EXPECT_NEAR(at[1], 4, 1e-3);
}

TEST(TwoBodyImpact, KeepsLinearMomentum)
{
    const Model model =
        twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {2e4, -1e4, -8e4}, 0.3);
    const auto solver = startedSolver(model);
    const Point before = momentum(*solver);
    const double scale = std::abs(before[2]);
    double strongest = 0;
    for (int call = 0; call < 30; ++call) {
        solver->advance(1, 20);
        strongest = std::max(strongest, solver->contact().force(0).force[2]);
        const Point after = momentum(*solver);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], 1e-12 * scale);
    }
    EXPECT_GT(strongest, 0);
    EXPECT_EQ(solver->contact().force(0).released, 0);
}

} // namespace
} // namespace fpm::test
