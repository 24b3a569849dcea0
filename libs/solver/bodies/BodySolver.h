#pragma once

#include "solver/backend/Launches.h"
#include "solver/bodies/BodyFields.h"
#include "solver/clock/ClockFields.h"

namespace fpm {

/// A rigid body at one time, in global axes.
struct BodyMotionValues {
    Point displacement, velocity, spin; ///< of the centre; angular velocity [rad/time]
    Point localSpin;                    ///< in axes that turn with the body, global at the start
    Point force, moment;                ///< of contact and loads, about the centre
    Point momentum;                     ///< angular, about the centre
    double kinetic = 0, halfStepKinetic = 0; ///< the latter at v^(n-1/2)
};

/// Free rigid bodies: their motion moves their nodes.
class BodySolver
{
public:
    BodySolver(const BodySetUp& setUp,
               BodyFields& fields,
               const ClockFields& clock,
               MotionLaunches& launches,
               Backend& backend,
               double massDamping)
        : setUp_(setUp),
          fields_(fields),
          clock_(clock),
          launches_(launches),
          backend_(backend),
          massDamping_(massDamping)
    {
    }

    void move();
    /// Contact and loads on each body, and the bound of the next step from its contact springs.
    void updateForces();

    const BodySetUp& setUp() const { return setUp_; }
    BodyMotionValues motion(std::size_t body) const; ///< number in the set-up
    double seconds() const { return seconds_; }

private:
    const BodySetUp& setUp_;
    BodyFields& fields_;
    const ClockFields& clock_;
    MotionLaunches& launches_;
    Backend& backend_;
    double massDamping_, seconds_ = 0;
};

} // namespace fpm
