#include "run/Schedule.h"

#include "run/RunForecast.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpm {

namespace {

/// The first multiple of `interval` that is more than `beyond` after `time`.
double multipleAfter(double time, double interval, double beyond)
{
    double number = std::floor(time / interval);
    // No next multiple where the numbers are too large to count on.
    while (number * interval <= time + beyond && number + 1 > number) ++number;
    return number * interval;
}

std::int64_t stepsToMultiple(std::int64_t done, std::int64_t of)
{
    return of - done % of;
}

} // namespace

Schedule::Schedule(const Control& control, std::int64_t maxSteps)
    : control_(control),
      maxSteps_(maxSteps)
{
}

void Schedule::startAt(const StepClock& clock, double wall)
{
    frameIsDone(clock, wall);
    rowIsDone(clock);
}

double Schedule::stop() const
{
    return std::min(nextFrame_, control_.endTime);
}

double Schedule::pause() const
{
    return nextRow_;
}

std::int64_t Schedule::steps(const StepClock& clock) const
{
    std::int64_t steps = stepsUntil(clock, std::min(stop(), pause()));
    if (maxSteps_ >= 0) steps = std::min(steps, maxSteps_ - clock.steps);
    if (control_.writeControl == WriteControl::timeStep)
        steps = std::min(steps, stepsToMultiple(clock.steps, std::int64_t(control_.writeInterval)));
    if (control_.checkpoint.steps > 0)
        steps = std::min(steps, stepsToMultiple(clock.steps, control_.checkpoint.steps));
    return steps;
}

bool Schedule::atEnd(const StepClock& clock) const
{
    return clock.settled || clock.time >= control_.endTime
           || (maxSteps_ >= 0 && clock.steps >= maxSteps_);
}

bool Schedule::rowIsDue(const StepClock& clock) const
{
    return clock.time >= nextRow_ || clock.time >= control_.endTime || clock.settled;
}

bool Schedule::frameIsDue(const StepClock& clock) const
{
    return clock.time >= nextFrame_ || clock.time >= control_.endTime || clock.settled
           || (control_.writeControl == WriteControl::timeStep
               && clock.steps % std::int64_t(control_.writeInterval) == 0);
}

bool Schedule::frameIsDueByWall(double wall) const
{
    return control_.writeControl == WriteControl::clockTime
           && wall >= lastFrame_ + control_.writeInterval;
}

bool Schedule::checkpointIsDue(const StepClock& clock, double wall) const
{
    const CheckpointControl& checkpoint = control_.checkpoint;
    return (checkpoint.steps > 0 && clock.steps % checkpoint.steps == 0)
           || (checkpoint.wallInterval > 0 && wall >= lastCheckpoint_ + checkpoint.wallInterval);
}

/// The last interval before the end is not cut by a sliver.
void Schedule::frameIsDone(const StepClock& clock, double wall)
{
    lastFrame_ = wall;
    nextFrame_ = control_.endTime;
    if (control_.writeControl != WriteControl::runTime) return;
    const double interval = control_.writeInterval,
                 next = multipleAfter(clock.time, interval, 1e-12 * clock.time);
    if (next <= control_.endTime - 1e-6 * interval) nextFrame_ = next;
}

/// A row is taken at the first step at or after its time, so that it never shortens a step. Which
/// one that is does not depend on where the run ends.
double Schedule::rowAfter(const StepClock& clock) const
{
    if (!(control_.historyInterval > 0)) // every step
        return std::nextafter(clock.time, std::numeric_limits<double>::infinity());
    const double tiny = 1e-8 * control_.historyInterval;
    return multipleAfter(clock.time, control_.historyInterval, tiny) - tiny;
}

} // namespace fpm
