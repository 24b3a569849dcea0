#include "kernels/particle/StepClockUpdate.h"
#include "parallel/CpuExecutor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace fpm;

namespace {

StepClock clockUntil(double stop)
{
    StepClock clock;
    clock.stop = stop;
    return clock;
}

} // namespace

TEST(StepClock, MeetsTheStopExactlyAndStandsStill)
{
    std::mt19937 random(33);
    std::uniform_real_distribution<double> bound(0.5e-3, 2e-3), stop(0.1, 1);
    for (int run = 0; run < 50; ++run) {
        StepClock clock = clockUntil(stop(random));
        while (clock.running) {
            advanceClock(clock, {}, bound(random), 0);
            ASSERT_LT(clock.steps, 10000);
        }
        EXPECT_EQ(clock.time, clock.stop);
        EXPECT_EQ(clock.failed, 0);
        const StepClock before = clock;
        advanceClock(clock, {}, 1e-3, 0);
        EXPECT_EQ(clock.time, before.time);
        EXPECT_EQ(clock.steps, before.steps);
    }
}

TEST(StepClock, NeverEndsWithASliver)
{
    std::mt19937 random(34);
    std::uniform_real_distribution<double> stop(0.5, 20);
    for (int run = 0; run < 1000; ++run) {
        StepClock clock = clockUntil(stop(random));
        double least = 1e300, most = 0;
        while (clock.running) {
            advanceClock(clock, {}, 1.0, 0);
            least = std::min(least, clock.step);
            most = std::max(most, clock.step);
        }
        // A last piece is cut in halves, so no step is shorter than half of the usual one.
        if (clock.stop > 0.9) {
            EXPECT_GT(least, 0.4499);
        }
        EXPECT_LE(most, 0.9 * 1.000002);
    }
}

TEST(StepClock, TakesALeftoverOfRoundingIntoTheLastStep)
{
    StepClock clock = clockUntil(1 + 1e-9);
    StepRules rules;
    rules.fixedStep = 0.1;
    while (clock.running) advanceClock(clock, rules, 1, 0);
    EXPECT_EQ(clock.steps, 10);
    EXPECT_EQ(clock.time, clock.stop);
}

TEST(StepClock, GoesOnFromAStopThatWasMovedOn)
{
    StepClock clock = clockUntil(1);
    while (clock.running) advanceClock(clock, {}, 0.3, 0);
    clock.stop = 2;
    clock.running = 1;
    while (clock.running) advanceClock(clock, {}, 0.3, 0);
    EXPECT_EQ(clock.time, 2);
}

TEST(StepClock, AppliesTheSafetyFactorToTheCombinedFrequency)
{
    StepClock clock = clockUntil(1e9);
    StepRules rules;
    rules.contactLimit = 10;
    advanceClock(clock, rules, 0.5, 9);
    const double stable = 2 / std::sqrt(16.0 + 9.0); // omega_e = 2 / 0.5
    EXPECT_DOUBLE_EQ(clock.stableStep, stable);
    EXPECT_DOUBLE_EQ(clock.step, 0.9 * stable);
    EXPECT_EQ(clock.elementStep, 0.5);
    EXPECT_EQ(clock.contactFrequency, 3);
}

TEST(StepClock, MakesNoStepLongerThanTheMaximumButShorterOnes)
{
    StepClock clock = clockUntil(1e9);
    StepRules rules;
    rules.maximumStep = 0.2;
    advanceClock(clock, rules, 0.5, 0);
    EXPECT_EQ(clock.step, 0.2);
    advanceClock(clock, rules, 0.1, 0);
    EXPECT_DOUBLE_EQ(clock.step, 0.09);
    EXPECT_EQ(clock.failed, 0);
}

TEST(StepClock, KeepsTheContactFrequencyTimesTheStepBelowItsLimit)
{
    StepClock clock = clockUntil(1e9);
    advanceClock(clock, {}, 1.0, 100 * 100);
    EXPECT_DOUBLE_EQ(clock.step * 100, 0.8);
}

TEST(StepClock, GrowsByTenPercentAtMostAndShrinksAtOnce)
{
    StepClock clock = clockUntil(1e9);
    advanceClock(clock, {}, 1.0, 0);
    advanceClock(clock, {}, 10.0, 0);
    EXPECT_DOUBLE_EQ(clock.step, 1.1 * 0.9);
    advanceClock(clock, {}, 0.1, 0);
    EXPECT_DOUBLE_EQ(clock.step, 0.09);
    EXPECT_DOUBLE_EQ(clock.mean, (0.99 + 0.09) / 2);
}

TEST(StepClock, TheFirstMeanStepIsHalfTheFirstStep)
{
    StepClock clock = clockUntil(1e9);
    advanceClock(clock, {}, 1.0, 0);
    EXPECT_DOUBLE_EQ(clock.mean, 0.45);
}

TEST(StepClock, AFixedStepIsKeptBelowTheBoundAndRefusedBeyondIt)
{
    StepClock clock = clockUntil(1);
    StepRules rules;
    rules.fixedStep = 0.25;
    advanceClock(clock, rules, 100, 0);
    EXPECT_EQ(clock.step, 0.25);
    EXPECT_DOUBLE_EQ(clock.stableStep, 100);

    advanceClock(clock, rules, 0.2, 0);
    EXPECT_EQ(clock.failed, 2);
    EXPECT_EQ(clock.running, 0);
    EXPECT_EQ(clock.time, 0.25);
}

TEST(StepClock, AMillionFixedStepsDoNotDrift)
{
    StepClock clock = clockUntil(1e9);
    StepRules rules;
    rules.fixedStep = 0.1;
    for (int n = 0; n < 1000000; ++n) advanceClock(clock, rules, 1, 0);
    EXPECT_NEAR(clock.time, 0.1 * 1e6, 1e-10);
}

TEST(StepClock, StopsWithAFailureOnABoundThatIsNoStep)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double bound : {-1.0, 0.0, nan, infinite, -infinite}) {
        StepClock clock = clockUntil(1);
        advanceClock(clock, {}, bound, 0);
        EXPECT_EQ(clock.failed, 1) << bound;
        EXPECT_EQ(clock.running, 0) << bound;
        EXPECT_EQ(clock.time, 0) << bound;
    }
    for (const double contact : {nan, -1.0}) {
        StepClock clock = clockUntil(1);
        advanceClock(clock, {}, 1, contact);
        EXPECT_EQ(clock.failed, 1) << contact;
        EXPECT_EQ(clock.time, 0) << contact;
    }
}

TEST(StepClock, StandingStillItOnlyJudges)
{
    StepClock clock = clockUntil(1);
    advanceClock(clock, {}, 2, 0.04);
    ASSERT_EQ(clock.time, 1);
    advanceClock(clock, {}, 0.5, 9);
    EXPECT_EQ(clock.elementStep, 2); // of the step that was made
    EXPECT_EQ(clock.contactFrequency, 0.2);
    EXPECT_EQ(clock.failed, 0);
    advanceClock(clock, {}, 0, 0);
    EXPECT_EQ(clock.failed, 1);
}

TEST(StepClock, TakesTheLeastElementStepAndTheStiffestContactOfNodesAndBodies)
{
    const std::vector<double> steps{0.7, 0.2, 0.9, 0.4};
    std::vector<double> limits(40, 1.0), ofBodies{4, 9};
    limits[33] = 25;
    for (const double stiffest : {25.0, 49.0}) {
        ofBodies[1] = stiffest == 25 ? 9 : 49;
        StepClock clock = clockUntil(1e9);
        const StepClockUpdate update{steps.data(), 4,     limits.data(), 40, ofBodies.data(), 2,
                                     {},           &clock};
        CpuExecutor<64>(1, StepClockUpdate::scratch())
            .parallelBlocks(1, StepClockUpdate::scratch(), update);
        EXPECT_EQ(clock.elementStep, 0.2);
        EXPECT_EQ(clock.contactFrequency, std::sqrt(stiffest));
        EXPECT_EQ(clock.running, 1);
    }
}

TEST(StepClock, FailsWhenOneElementHasNoNumber)
{
    std::vector<double> steps(100, 1.0);
    steps[71] = std::numeric_limits<double>::quiet_NaN();
    StepClock clock = clockUntil(1);
    const StepClockUpdate update{steps.data(), 100, nullptr, 0, nullptr, 0, {}, &clock};
    CpuExecutor<64>(1, StepClockUpdate::scratch())
        .parallelBlocks(1, StepClockUpdate::scratch(), update);
    EXPECT_EQ(clock.failed, 1);
}
