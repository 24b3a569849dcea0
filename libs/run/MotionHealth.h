#pragma once

#include "run/Bodies.h"
#include "run/HealthRow.h"
#include "solver/Solver.h"

namespace fpm {

/// Judges mass and motion: added mass, bodies that fly off as a whole, dynamic relaxation that does
/// not come to rest, parts that nothing moves, bodies inside one another with no contact between.
class MotionHealth
{
public:
    explicit MotionHealth(const Model& model);
    void addRows(Solver& solver, HealthRows& rows) const;

private:
    void addMass(const Solver& solver, HealthRows& rows) const;
    bool addDrift(Solver& solver, const NodeValues& nodes, HealthRows& rows) const;
    void addRest(const StepClock& clock, bool drifts, HealthRows& rows) const;
    void addIdle(HealthRows& rows) const;
    void addOverlaps(const NodeValues& nodes, double time, HealthRows& rows) const;

    const Model& model_;
    Bodies bodies_;
};

} // namespace fpm
