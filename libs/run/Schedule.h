#pragma once

#include "model/Model.h"
#include "solver/Solver.h"

namespace fpm {

/// When frames, history rows and checkpoints of a run are due. What is due by simulated time or
/// steps depends on these alone, so that a run that goes on from a checkpoint does the same at the
/// same steps; what is due by the clock on the wall never changes a step.
class Schedule
{
public:
    /// `control` may change between two steps; see startAt(). `maxSteps` >= 0: no more steps in
    /// all.
    Schedule(const Control& control, std::int64_t maxSteps);

    /// Frame and row of this moment are done. At the start, and when control has changed.
    void startAt(const StepClock& clock, double wall);

    /// The time that the next steps meet exactly, and the first step they come back after.
    double stop() const;
    double pause() const;
    /// How many they may be.
    std::int64_t steps(const StepClock& clock) const;

    bool atEnd(const StepClock& clock) const;
    bool rowIsDue(const StepClock& clock) const;
    bool frameIsDue(const StepClock& clock) const;
    /// By the clock on the wall: `wall`, seconds since the run began.
    bool frameIsDueByWall(double wall) const;
    bool checkpointIsDue(const StepClock& clock, double wall) const;

    void rowIsDone(const StepClock& clock) { nextRow_ = rowAfter(clock); }
    void frameIsDone(const StepClock& clock, double wall);
    void checkpointIsDone(double wall) { lastCheckpoint_ = wall; }

private:
    double rowAfter(const StepClock& clock) const;

    const Control& control_;
    const std::int64_t maxSteps_;
    double nextFrame_ = 0, nextRow_ = 0;        ///< time
    double lastFrame_ = 0, lastCheckpoint_ = 0; ///< on the wall
};

} // namespace fpm
