#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

Part column()
{
    Part part = aluminium(PartKind::elastic, HourglassForm::stiffness);
    part.poissonsRatio = 0;
    return part;
}

/// A column of 40 cells falling on an equal one that stands on the ground, nu = 0: one-dimensional
/// waves, known exactly. Speed 10 m/s, start just above.
Model fallingColumn(ContactSearch search = ContactSearch::faces)
{
    Model model;
    addBox(model.mesh, "lower", {2, 2, 40}, {0, 0, -20}, {1, 1, 20});
    addBox(model.mesh, "upper", {2, 2, 40}, {0, 0, 1e-3}, {1, 1, 20});
    renumber(model.mesh);
    model.parts = {column(), column()};
    model.parts[0].name = "lower";
    model.parts[1].name = "upper";
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -19.99; }));
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "upper"), {0, 0, -1e4}});
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}))
        .search = search;
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

struct Bounce {
    double impulse = 0, plateau = 0, first = 0, last = 0;
    std::vector<double> force;
};

/// Steps through the bounce; `plateau`: mean force over the middle of the contact.
Bounce bounce(Solver& solver, double end)
{
    Bounce out;
    double before = 0, time = 0;
    while (solver.clock().time < end) {
        solver.advance(end, 1);
        const double force = solver.contact().force(0).force[2], step = solver.clock().time - time;
        time = solver.clock().time;
        out.impulse += step * (force + before) / 2;
        before = force;
        out.force.push_back(force);
        if (force > 0) {
            if (out.first == 0) out.first = time;
            out.last = time;
        }
    }
    return out;
}

TEST(Contact, ColumnBouncesWithItsOwnMomentumAfterFourRunsOfTheWave)
{
    const Model model = fallingColumn();
    const auto solver = startedSolver(model);
    const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
    const double before = momentum(*solver, upper)[2];
    const double c = std::sqrt(70000 / 2.7e-9), run = 20 / c;
    const Bounce result = bounce(*solver, 6 * run);
    const double after = momentum(*solver, upper)[2];

    EXPECT_NEAR(after, -before, 0.02 * std::abs(before)); // coefficient of restitution 1
    EXPECT_NEAR(result.impulse, after - before, 0.005 * std::abs(before));
    EXPECT_NEAR(result.last - result.first, 4 * run, 0.1 * run);
    EXPECT_EQ(result.force.back(), 0);
    EXPECT_EQ(solver->contact().force(0).active, 0);
    EXPECT_EQ(solver->contact().force(0).released, 0);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.002);
}

TEST(Contact, ForceOfTheImpactIsHalfTheImpedanceTimesTheSpeed)
{
    const auto solver = startedSolver(fallingColumn());
    const double c = std::sqrt(70000 / 2.7e-9), run = 20 / c;
    solver->advance(0.5 * run, 100000);
    double sum = 0;
    int count = 0;
    while (solver->clock().time < 1.5 * run) {
        solver->advance(1, 1);
        sum += solver->contact().force(0).force[2];
        ++count;
    }
    const double exact = 2.7e-9 * c * 1e4 / 2;
    EXPECT_NEAR(sum / count, exact, 0.01 * exact);
}

TEST(Contact, FastBlockIsFoundBeforeItIsDeep)
{
    // 400 m/s: in ten steps the block moves further than the skin.
    Model model =
        twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::physical), {0, 0, -4e5}, 0, 2.9);
    const auto solver = startedSolver(model);
    const double reach = solver->contact().setUp().passes[0].reach;
    double least = 1e9;
    while (solver->clock().time < 1.2e-5) {
        const std::int64_t searches = solver->times().searches;
        const double before = solver->clock().time;
        solver->advance(1.2e-5, 10);
        const double way = 4e5 * (solver->clock().time - before);
        least =
            std::min(least, 0.5 * reach * double(solver->times().searches - searches + 1) / way);
        ASSERT_EQ(solver->clock().failed, 0);
    }
    EXPECT_GE(least, 1) << "a list was used for more than half a skin of displacement";
    EXPECT_EQ(solver->contact().force(0).released, 0);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
}

TEST(Contact, ListsThatAJumpOutrunsAreReported)
{
    // At rest no list check foresees 1500 m/s; the same speed from the start is foreseen.
    const auto late = [](double rest) {
        Model model = twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                                aluminium(PartKind::elastic, HourglassForm::physical), {}, 0, 1);
        model.boundaryConditions.push_back(condition(
            BoundaryCondition::Kind::velocity, "jump", nodesOfPart(model.mesh, "upper"),
            {true, true, true}, {0, 0, 1.5e6},
            Amplitude{Amplitude::Kind::table, {{0, rest}, {3.5e-6, rest}, {3.51e-6, 1}}}));
        const auto solver = startedSolver(model);
        solver->advance(5e-6, 1000);
        EXPECT_GE(solver->clock().time, 5e-6);
        return solver->contact().force(0).late;
    };
    EXPECT_EQ(late(1), 0);
    EXPECT_GT(late(0), 0);
}

TEST(Contact, ClosestParticleAndFacesAgreeOnMatchingMeshes)
{
    const double run = 20 / std::sqrt(70000 / 2.7e-9);
    const auto faces = startedSolver(fallingColumn(ContactSearch::faces)),
               particle = startedSolver(fallingColumn(ContactSearch::closestParticle));
    const Bounce a = bounce(*faces, 5 * run), b = bounce(*particle, 5 * run);
    ASSERT_EQ(a.force.size(), b.force.size());
    const double scale = *std::max_element(a.force.begin(), a.force.end());
    EXPECT_GT(scale, 0);
    for (std::size_t i = 0; i < a.force.size(); ++i)
        EXPECT_NEAR(a.force[i], b.force[i], 1e-9 * scale);
}

TEST(Contact, PenetrationAtRestIsForceOverStiffness)
{
    for (const double scale : {0.1, 1.0}) {
        Model model;
        addBox(model.mesh, "lower", {1, 1, 1}, {0, 0, -1}, {1, 1, 1});
        addBox(model.mesh, "upper", {1, 1, 1}, {0, 0, 0}, {1, 1, 1});
        renumber(model.mesh);
        model.parts = {column(), column()};
        model.parts[0].name = "lower";
        model.parts[1].name = "upper";
        const auto below = [](Point p) { return p[2] < -0.99; };
        const auto above = [](Point p) { return p[2] > 0.99; };
        holdFixed(model, nodesWhere(model.mesh, below));
        model.boundaryConditions.push_back(condition(
            BoundaryCondition::Kind::force, "load", nodesWhere(model.mesh, above),
            {false, false, true}, {0, 0, -100}, {Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}}}));
        addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                   facing(model.mesh, "lower", {0, 0, 1}))
            .normalScale = scale;
        model.control.backend = "serial";
        model.control.massDamping = 2e6;
        const auto solver = startedSolver(model);
        solver->advance(6e-5, 1000000);

        const PairForce force = solver->contact().force(0);
        EXPECT_NEAR(force.force[2], 100, 0.01);
        EXPECT_EQ(force.active, 4);
        // Four springs of s K A^2 / V, K = E / 3; the faces lie above each other.
        const double gap = 100 / (4 * scale * 70000 / 3);
        const NodeValues values = solver->nodes().values({});
        double upper = 0, lower = 0;
        for (const Index i : model.contactPairs[0].contactorNodes)
            upper += values.at(0, std::size_t(i))[2] / 4;
        for (const Index i : nodesOf(model.mesh, model.contactPairs[0].targetSides))
            lower += values.at(0, std::size_t(i))[2] / 4;
        EXPECT_NEAR(lower - upper, gap, 1e-3 * gap);
        EXPECT_NEAR(solver->ledger().energies().contact, 0.5 * 100 * gap, 2e-3 * 50 * gap);
    }
}

/// Balance after an impact of blocks whose meshes do not match, sliding included.
double worstBalance(const Model& model)
{
    const auto solver = startedSolver(model);
    double worst = 0;
    for (int call = 0; call < 60; ++call) {
        solver->advance(1, 20);
        EXPECT_FALSE(solver->clock().failed);
        worst = std::max(worst, std::abs(solver->ledger().energies().balance));
    }
    EXPECT_EQ(solver->contact().force(0).released, 0);
    return worst;
}

Model slidingImpact(bool swapped, double friction)
{
    Model model = twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical),
                            aluminium(PartKind::elastic, HourglassForm::stiffness),
                            {4e4, -2e4, -4e4}, friction);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    if (!swapped) return model;
    const ContactSurfaces old = model.mesh.contact[0];
    model.mesh.contact.clear();
    model.contactPairs.clear();
    addContact(model, "touch", old.targetSides, old.contactorSides).friction = friction;
    return model;
}

TEST(Contact, EnergyIsKeptWhicheverSideIsTheContactor)
{
    for (const bool swapped : {false, true})
        for (const double friction : {0.0, 0.3})
            EXPECT_LT(worstBalance(slidingImpact(swapped, friction)), 0.01)
                << (swapped ? "swapped" : "as it is") << ", friction " << friction;
}

TEST(Contact, SwappedSidesGiveTheSameImpulse)
{
    std::vector<double> result;
    for (const bool swapped : {false, true}) {
        const Model model = slidingImpact(swapped, 0);
        const auto solver = startedSolver(model);
        const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
        const double before = momentum(*solver, upper)[2];
        solver->advance(4e-6, 100000);
        result.push_back(momentum(*solver, upper)[2] - before);
    }
    EXPECT_GT(result[0], 0);
    EXPECT_NEAR(result[1], result[0], 0.1 * result[0]);
}

TEST(Contact, FrictionSlowsByItsCoefficientTimesTheNormalImpulse)
{
    const double mu = 0.2;
    Model model =
        twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {8e4, 0, -1e4}, mu);
    // Where the slip slows at once its damping acts as up to a third of the contactors' mass.
    model.contactPairs[0].slipDamping = 0;
    const auto solver = startedSolver(model);
    const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
    const Point before = momentum(*solver, upper);
    solver->advance(4e-6, 100000); // sliding throughout
    const Point after = momentum(*solver, upper);
    const double normal = after[2] - before[2];
    EXPECT_GT(normal, 0);
    EXPECT_NEAR(after[0] - before[0], -mu * normal, 0.03 * mu * normal);
    EXPECT_GT(solver->ledger().energies().friction, 0);
}

} // namespace
} // namespace fpm::test
