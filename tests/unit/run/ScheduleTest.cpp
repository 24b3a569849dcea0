#include "run/Schedule.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

Control everyTenth()
{
    Control control;
    control.endTime = 1;
    control.writeInterval = 0.25;
    control.historyInterval = 0.1;
    return control;
}

StepClock at(double time, std::int64_t steps, double step = 0.01)
{
    StepClock clock;
    clock.time = time;
    clock.steps = steps;
    clock.step = step;
    return clock;
}

TEST(Schedule, FramesEndStepsAndRowsDoNot)
{
    const Control control = everyTenth();
    Schedule schedule(control, -1);
    schedule.startAt(at(0, 0), 0);
    EXPECT_EQ(schedule.stop(), 0.25);
    EXPECT_NEAR(schedule.pause(), 0.1, 1e-8);
    EXPECT_LT(schedule.pause(), 0.1); // a step that rounding left short of it counts
    EXPECT_EQ(schedule.steps(at(0, 0)), 10);
    EXPECT_FALSE(schedule.rowIsDue(at(0.09, 9)));
    EXPECT_TRUE(schedule.rowIsDue(at(0.104, 10)));
    schedule.rowIsDone(at(0.104, 10));
    EXPECT_NEAR(schedule.pause(), 0.2, 1e-8);
    EXPECT_FALSE(schedule.frameIsDue(at(0.24, 24)));
    EXPECT_TRUE(schedule.frameIsDue(at(0.25, 25)));
    schedule.frameIsDone(at(0.25, 25), 0);
    EXPECT_EQ(schedule.stop(), 0.5);
}

TEST(Schedule, GoesOnAsIfItHadBeenThereFromTheStart)
{
    const Control control = everyTenth();
    Schedule whole(control, -1), later(control, -1);
    whole.startAt(at(0, 0), 0);
    for (const double row : {0.1, 0.2, 0.3, 0.404}) whole.rowIsDone(at(row, 1));
    whole.frameIsDone(at(0.25, 25), 0);
    later.startAt(at(0.42, 42), 0);
    EXPECT_EQ(later.stop(), whole.stop());
    EXPECT_EQ(later.pause(), whole.pause());
}

TEST(Schedule, NoRowDependsOnTheEnd)
{
    Control control = everyTenth();
    Schedule schedule(control, -1);
    schedule.startAt(at(0.12, 12), 0);
    const double pause = schedule.pause();
    control.endTime = 1e6;
    schedule.startAt(at(0.12, 12), 0);
    EXPECT_EQ(schedule.pause(), pause);
}

TEST(Schedule, RowsOfEveryStepPauseAfterEach)
{
    Control control = everyTenth();
    control.historyInterval = 0;
    Schedule schedule(control, -1);
    schedule.startAt(at(0.3, 30), 0);
    EXPECT_FALSE(schedule.rowIsDue(at(0.3, 30)));
    EXPECT_TRUE(schedule.rowIsDue(at(0.3 + 1e-16 + 1e-12, 31)));
    EXPECT_EQ(schedule.steps(at(0.3, 30)), 1);
}

TEST(Schedule, TheLastIntervalIsNotASliver)
{
    Control control = everyTenth();
    control.writeInterval = 1.0 / 3 - 1e-9;
    Schedule schedule(control, -1);
    schedule.startAt(at(2 * control.writeInterval, 5), 0);
    EXPECT_EQ(schedule.stop(), 1);
}

TEST(Schedule, EndsAtTheEndAtRestOrAfterItsSteps)
{
    const Control control = everyTenth();
    Schedule schedule(control, 50);
    schedule.startAt(at(0.45, 48), 0);
    EXPECT_FALSE(schedule.atEnd(at(0.5, 49)));
    EXPECT_TRUE(schedule.atEnd(at(0.5, 50)));
    EXPECT_TRUE(schedule.atEnd(at(1, 20)));
    StepClock rests = at(0.5, 20);
    rests.settled = 1;
    EXPECT_TRUE(schedule.atEnd(rests));
    EXPECT_EQ(schedule.steps(at(0.45, 48)), 2);
}

TEST(Schedule, FramesByStepsAndCheckpointsBoundTheStepsNotTheirSize)
{
    Control control = everyTenth();
    control.writeControl = WriteControl::timeStep;
    control.writeInterval = 7;
    control.checkpoint.steps = 10;
    Schedule schedule(control, -1);
    schedule.startAt(at(0, 0), 0);
    EXPECT_EQ(schedule.stop(), 1);
    EXPECT_EQ(schedule.steps(at(0, 0)), 7);
    EXPECT_EQ(schedule.steps(at(0.001, 7)), 3);
    EXPECT_TRUE(schedule.frameIsDue(at(0.05, 14)));
    EXPECT_FALSE(schedule.frameIsDue(at(0.05, 15)));
    EXPECT_TRUE(schedule.checkpointIsDue(at(0.05, 20), 0));
    EXPECT_FALSE(schedule.checkpointIsDue(at(0.05, 21), 0));
}

TEST(Schedule, TheClockOnTheWallChangesNoStep)
{
    Control control = everyTenth();
    control.writeControl = WriteControl::clockTime;
    control.writeInterval = 60;
    Schedule schedule(control, -1);
    schedule.startAt(at(0, 0), 5);
    EXPECT_EQ(schedule.stop(), 1);
    EXPECT_FALSE(schedule.frameIsDueByWall(64));
    EXPECT_TRUE(schedule.frameIsDueByWall(65));
    schedule.checkpointIsDone(5);
    EXPECT_FALSE(schedule.checkpointIsDue(at(0.1, 3), 604));
    EXPECT_TRUE(schedule.checkpointIsDue(at(0.1, 3), 605));
}

/// Times beyond all intervals: a forged checkpoint may hold one.
TEST(Schedule, ComesToAnEndWhateverTheTime)
{
    Control control = everyTenth();
    for (const double interval : {0.1, 1e-300}) {
        control.historyInterval = control.writeInterval = interval;
        Schedule schedule(control, -1);
        for (const double time : {1e17, 1e300}) schedule.startAt(at(time, 1), 0);
        EXPECT_EQ(schedule.stop(), control.endTime);
        EXPECT_TRUE(schedule.atEnd(at(1e300, 1)));
    }
}

} // namespace
} // namespace fpm
