#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// F11: a round rod lying in a round groove of the same radius, with 10 and 14 facets: their
/// chords overlap by up to some ten thousandths of the radius.
Model rodInGroove(InitialOverlap option, double rampTime = 0)
{
    Model model;
    addBox(model.mesh, "die", {14, 2, 2}, {-1, 0, 0}, {2, 1, 1});
    addBox(model.mesh, "rod", {10, 2, 4}, {-1, 0, 2}, {2, 1, 1});
    const double radius = 5;
    const auto arc = [&](double x) {
        const double angle = x * 0.6;
        return Point{radius * std::sin(angle), 0, -radius * std::cos(angle)};
    };
    for (Point& p : model.mesh.points) {
        const Point on = arc(p[0]);
        const double out = p[2] < 1.5 ? 1 - p[2] : 2 - p[2]; // away from the common arc
        p = {on[0] * (1 + out / radius), p[1], on[2] * (1 + out / radius)};
    }
    renumber(model.mesh, 64);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::physical, "die"),
                   aluminium(PartKind::elastic, HourglassForm::physical, "rod")};
    std::vector<ElementSide> rod, die;
    for (const std::string part : {"rod", "die"})
        for (const ElementSide& side : skin(model.mesh, model.mesh.findPart(part))) {
            const Point c = centre(model.mesh, side), n = normal(model.mesh, side);
            const double r = std::hypot(c[0], c[2]);
            const double along = (c[0] * n[0] + c[2] * n[2]) / r;
            if (std::abs(r - radius) < 0.1 && std::abs(along) > 0.9)
                (part == "rod" ? rod : die).push_back(side);
        }
    ContactPair& pair = addContact(model, "touch", rod, die);
    pair.initialOverlap = option;
    pair.rampTime = rampTime;
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

double largestSpeed(Solver& solver)
{
    double most = 0;
    for (const Point& v : halfStepVelocities(solver))
        most = std::max({most, std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    return most;
}

TEST(InitialOverlap, IsReportedWithItsNumberDepthAndPlace)
{
    const Model model = rodInGroove(InitialOverlap::report);
    const auto solver = startedSolver(model);
    const PairOverlap overlap = solver->contact().initialOverlap(0);
    EXPECT_GE(overlap.count, 10);
    // A node on the arc lies at most the sagitta of a facet of the die behind it.
    const double sagitta = 5 * (1 - std::cos(0.6 / 14));
    EXPECT_GT(overlap.deepest, 0.5 * sagitta);
    EXPECT_LE(overlap.deepest, 1.01 * sagitta);
    const Point& place = model.mesh.points[std::size_t(overlap.node)];
    EXPECT_NEAR(std::hypot(place[0], place[2]), 5, 1e-9);
}

TEST(InitialOverlap, PushesTheBodiesApartUnlessItIsForgiven)
{
    const auto pushed = startedSolver(rodInGroove(InitialOverlap::report));
    const auto forgiven = startedSolver(rodInGroove(InitialOverlap::offset));
    EXPECT_GT(pushed->ledger().energies().contact, 0);
    EXPECT_EQ(forgiven->ledger().energies().contact, 0);
    EXPECT_EQ(forgiven->contact().initialOverlap(0).count,
              pushed->contact().initialOverlap(0).count);
    pushed->advance(3e-6, 100000);
    forgiven->advance(3e-6, 100000);
    EXPECT_GT(largestSpeed(*pushed), 10);
    EXPECT_EQ(largestSpeed(*forgiven), 0);
}

TEST(InitialOverlap, OffsetHoldsWhatPressesOnAndDecaysAsTheGapOpens)
{
    // A block 0.02 inside: led 0.01 deeper, out again by 0.02, and in by 0.02 once more.
    Model model;
    addBox(model.mesh, "lower", {3, 3, 1}, {-1, -1, -1}, {3, 3, 1});
    addBox(model.mesh, "upper", {1, 1, 1}, {0, 0, -0.02}, {1, 1, 1});
    renumber(model.mesh);
    Part part = aluminium(PartKind::elastic, HourglassForm::physical);
    part.poissonsRatio = 0;
    model.parts = {part, part};
    holdFixed(model, nodesOfPart(model.mesh, "lower"));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::displacement, "led", nodesOfPart(model.mesh, "upper"),
                  {true, true, true}, {0, 0, 1},
                  {Amplitude::Kind::table, {{0, 0}, {1e-6, -0.01}, {3e-6, 0.01}, {5e-6, -0.01}}}));
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}))
        .initialOverlap = InitialOverlap::offset;
    model.control.backend = "serial";
    const auto solver = startedSolver(model);
    const double stiffness = 4 * 70000.0 / 3;
    solver->advance(1e-6, 100000);
    EXPECT_NEAR(solver->contact().force(0).force[2], stiffness * 0.01, 1e-6 * stiffness);
    solver->advance(3e-6, 100000);
    EXPECT_EQ(solver->contact().force(0).force[2], 0);
    solver->advance(5e-6, 100000); // of the 0.02, 0.01 is still forgiven
    EXPECT_NEAR(solver->contact().force(0).force[2], stiffness * 0.02, 1e-3 * stiffness * 0.02);
}

TEST(InitialOverlap, RampBringsTheForceGentlyAndBooksItsWork)
{
    const auto ramp = startedSolver(rodInGroove(InitialOverlap::ramp, 2e-5));
    const auto report = startedSolver(rodInGroove(InitialOverlap::report));
    EXPECT_EQ(ramp->contact().force(0).active, 0);
    double fastest = 0, pushed = 0;
    while (ramp->clock().time < 2.5e-5) {
        ramp->advance(2.5e-5, 20);
        report->advance(2.5e-5, 20);
        fastest = std::max(fastest, largestSpeed(*ramp));
        pushed = std::max(pushed, largestSpeed(*report));
        EXPECT_LT(std::abs(ramp->ledger().energies().balance), 0.01);
    }
    EXPECT_GT(ramp->ledger().energies().external, 0);
    EXPECT_GT(fastest, 0);
    EXPECT_LT(fastest, 0.3 * pushed);
}

/// A block led from beside an open table, 0.1 below its top, in under it.
Model cameInSideways()
{
    Model model;
    addBox(model.mesh, "table", {4, 4, 1}, {0, 0, -1}, {4, 4, 1});
    addBox(model.mesh, "block", {1, 1, 1}, {-1.5, 1.1, -0.1}, {1, 1, 1});
    renumber(model.mesh);
    model.parts.assign(2, aluminium(PartKind::elastic, HourglassForm::physical));
    const std::vector<Index> block = nodesOfPart(model.mesh, "block");
    const Point velocity{1e6, 0, 0};
    holdFixed(model, nodesOfPart(model.mesh, "table"));
    model.initialVelocities.push_back({"led", block, velocity});
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::velocity, "led", block, {true, true, true}, velocity));
    addContact(model, "touch", facing(model.mesh, "block", {0, 0, -1}),
               facing(model.mesh, "table", {0, 0, 1}));
    model.control.backend = "serial";
    return model;
}

TEST(InitialOverlap, NodesThatEnterOverAnEdgeGetNoForceFromTheirDepth)
{
    const auto solver = startedSolver(cameInSideways());
    while (solver->clock().time < 3e-6) {
        solver->advance(3e-6, 10);
        EXPECT_NEAR(solver->ledger().energies().contact, 0, 1e-9);
    }
    EXPECT_GE(solver->contact().force(0).inside, 4);
}

/// While depths fade, what comes in fades with them: it starts without force, has all of it at the
/// end, and what that puts into springs is booked as work from outside.
TEST(InitialOverlap, WhatIsFirstFoundInsideInMidRampFadesWithTheRest)
{
    Model model = cameInSideways();
    model.contactPairs[0].initialOverlap = InitialOverlap::ramp;
    model.contactPairs[0].rampTime = 2.5e-6;
    model.control.fixedTimeStep = 2e-8;
    const auto solver = startedSolver(model);
    double last = 0, jump = 0;
    std::int64_t found = 0;
    double foundAt = 0;
    while (solver->clock().time < 3e-6) {
        solver->advance(3e-6, 1);
        const Energies e = solver->ledger().energies();
        const std::int64_t inside = solver->contact().force(0).inside;
        if (inside > found) foundAt = e.time;
        jump = std::max(jump, std::abs(e.contact - last));
        last = e.contact;
        found = inside;
        EXPECT_NEAR(e.external, e.total - e.kinetic, 1e-3 * 0.01 * 70000.0 / 3) << e.time;
    }
    const PairForce end = solver->contact().force(0);
    EXPECT_GT(foundAt, 4e-7);
    EXPECT_LT(foundAt, 2e-6);
    ASSERT_EQ(end.active, 4);
    EXPECT_NEAR(end.springEnergy, 4 * 0.5 * 70000.0 / 3 * 0.1 * 0.1 * 2.5, 1);
    EXPECT_LT(jump, 0.06 * last);
}

} // namespace
} // namespace fpm::test
