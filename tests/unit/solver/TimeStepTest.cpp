#include "base/Error.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

Model fall(double normalScale)
{
    Model model =
        twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {0, 0, -2e4}, 0);
    model.contactPairs[0].normalScale = normalScale;
    return model;
}

TEST(TimeStep, ContactLimitIsHonouredWhateverThePenalty)
{
    for (const double scale : {0.1, 1.0, 10.0}) {
        const auto solver = startedSolver(fall(scale));
        double largest = 0;
        for (int n = 0; n < 300; ++n) {
            solver->advance(1, 1);
            const StepClock clock = solver->clock(); // its frequency chose its step
            largest = std::max(largest, clock.contactFrequency * clock.step);
            EXPECT_LE(clock.step, 0.9 * clock.stableStep * (1 + 1e-12));
        }
        EXPECT_LE(largest, 0.8 * (1 + 1e-12)) << "normalScale " << scale;
        EXPECT_GT(largest, 0.1);
    }
}

TEST(TimeStep, AFixedStepGoesBeyondTheBoundOnlyWhereAllowed)
{
    Model model = fall(1);
    const auto plain = startedSolver(fall(1));
    plain->advance(1, 1);
    model.control.fixedTimeStep = 1.01 * plain->clock().stableStep;
    const auto refusing = startedSolver(model);
    refusing->advance(1, 5);
    EXPECT_EQ(refusing->clock().failed, 2);
    model.control.beyondBound = true;
    const auto going = startedSolver(model);
    going->advance(1, 5);
    EXPECT_EQ(going->clock().failed, 0);
    EXPECT_EQ(going->clock().steps, 5);
}

TEST(TimeStep, SearchesAsOftenAsRequested)
{
    Model model = fall(1);
    model.control.searchInterval = 7;
    const auto solver = startedSolver(model);
    const std::int64_t before = solver->times().searches;
    for (int call = 0; call < 4; ++call) solver->advance(1, 15);
    EXPECT_EQ(solver->times().searches - before, 9); // steps 0, 7, ..., 56 of 60
}

TEST(TimeStep, LimitOfTheControlIsTheOneUsed)
{
    Model model = fall(1);
    model.control.contactStepLimit = 0.1;
    const auto solver = startedSolver(model);
    solver->advance(1, 50);
    EXPECT_NEAR(solver->clock().contactFrequency * solver->clock().step, 0.1, 0.01);
}

TEST(TimeStep, ElementBoundIsThatOfTheSmallestBrick)
{
    Part part = aluminium(PartKind::elastic, HourglassForm::stiffness);
    part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    const Model model = boxModel({4, 2, 2}, {8, 2, 1}, part);
    const auto solver = startedSolver(model);
    solver->advance(1, 1);
    // 1 / (c_d sqrt(1/s1^2 + 1/s2^2 + 1/s3^2)), sides 2, 1, 0.5.
    const double lambda = 70000 * 0.3 / (1.3 * 0.4), mu = 70000 / 2.6;
    const double c = std::sqrt((lambda + 2 * mu) / 2.7e-9);
    EXPECT_NEAR(solver->clock().elementStep, 1 / (c * std::sqrt(0.25 + 1 + 4)), 1e-12);
    EXPECT_NEAR(solver->clock().step, 0.9 * solver->clock().elementStep, 1e-20);
}

TEST(TimeStep, StopTimeIsHitExactly)
{
    const auto solver = startedSolver(fall(1));
    for (const double time : {1e-6, 1.7e-6, 3.3333e-6}) {
        solver->advance(time, 100000);
        EXPECT_EQ(solver->clock().time, time);
    }
}

TEST(TimeStep, InvertedElementFailsAndKeepsTheState)
{
    Model model =
        boxModel({2, 2, 2}, {2, 2, 2}, aluminium(PartKind::elastic, HourglassForm::stiffness));
    // One corner is driven through the block, faster than anything can answer.
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::velocity, "push",
                  nodesWhere(model.mesh, [](Point p) { return p[0] + p[1] + p[2] > 5.99; }),
                  {true, true, true}, {-2e7, -2e7, -2e7}));
    model.control.fixedTimeStep = 2e-8;
    const auto solver = startedSolver(model);
    solver->advance(1, 100000);
    ASSERT_TRUE(solver->clock().failed);
    const std::int64_t steps = solver->clock().steps;
    EXPECT_GT(steps, 0);
    EXPECT_LT(steps, 100);
    const std::uint64_t state = stateChecksum(*solver);
    const double time = solver->clock().time;
    EXPECT_TRUE(std::isfinite(time));
    const NodeValues values = solver->nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i)
        for (const double x : values.at(0, i)) EXPECT_TRUE(std::isfinite(x));
    solver->advance(2, 100);
    EXPECT_EQ(stateChecksum(*solver), state);
    EXPECT_EQ(solver->clock().steps, steps);
    EXPECT_EQ(solver->clock().time, time);
}

TEST(TimeStep, ElementTurnedInsideOutAtTheStartIsRefused)
{
    Model model =
        boxModel({2, 1, 1}, {2, 1, 1}, aluminium(PartKind::elastic, HourglassForm::stiffness));
    for (Point& p : model.mesh.points)
        if (p[0] > 0.5 && p[0] < 1.5) p[0] = 2.5;
    EXPECT_THROW(makeSolver(model), Error);
}

TEST(TimeStep, ForcesOfTheStopTimeStayWhenABatchPassesIt)
{
    const auto solver = startedSolver(fall(1));
    int touching = 0;
    for (int k = 1; k <= 20; ++k) {
        solver->advance(k * 3.1e-7, 1000000); // stops anywhere within a batch
        const PairForce pair = solver->contact().force(0);
        const std::vector<Index> nodes = solver->contact()
                                             .setUp()
                                             .passes[0]
                                             .contactor; // their nodal contact force is the pair's
        const NodeValues values = solver->nodes().values(nodes);
        double sum = 0;
        for (std::size_t i = 0; i < values.count; ++i) sum += values.at(4, i)[2];
        EXPECT_NEAR(sum, pair.force[2], 1e-9 * std::abs(pair.force[2])) << "stop " << k;
        touching += pair.force[2] > 0;
    }
    EXPECT_GE(touching, 5);
}

TEST(TimeStep, FixedStepBeyondTheBoundFails)
{
    Model model = fall(1);
    model.control.fixedTimeStep = 1e-8;
    const auto allowed = startedSolver(model);
    allowed->advance(1, 10);
    EXPECT_EQ(allowed->clock().failed, 0);
    EXPECT_EQ(allowed->clock().step, 1e-8);

    model.control.fixedTimeStep = 1e-5;
    const auto refused = startedSolver(model);
    refused->advance(1, 10);
    EXPECT_EQ(refused->clock().failed, 2);
    EXPECT_EQ(refused->clock().steps, 0);
    EXPECT_LT(refused->clock().stableStep, 1e-5);
}

TEST(TimeStep, RigidPartNeedsNoDensityAndLimitsNothing)
{
    Model model = fall(1);
    model.parts[0].kind = PartKind::rigidPrescribed;
    model.parts[0].density = model.parts[0].youngsModulus = model.parts[0].poissonsRatio = 0;
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "driven",
                                                 nodesOfPart(model.mesh, "lower"),
                                                 {true, true, true}, {0, 0, 1e3}));
    const auto solver = startedSolver(model);
    solver->advance(1, 30);
    EXPECT_EQ(solver->clock().failed, 0);
    EXPECT_GT(solver->contact().force(0).force[2], 0);
    EXPECT_GT(solver->clock().step, 1e-8);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
}

} // namespace
} // namespace fpm::test
