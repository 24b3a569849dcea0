#pragma once

#include "base/Types.h"

#include <memory>

namespace fpm {

/// Kernels of the clock, the nodes and the rigid bodies.
class MotionLaunches
{
public:
    virtual ~MotionLaunches() = default;
    /// Chooses the next step from the bounds and moves the clock by it; where no step follows, only
    /// judges the state that was reached.
    virtual void updateClock() = 0;
    /// Damping of dynamic relaxation for the next step.
    virtual void relax() = 0;
    /// Nodes that no patch and no body moves.
    virtual void moveNodes() = 0;
    virtual void moveBodies() = 0;
    /// Pressures at the present positions.
    virtual void pressures() = 0;
    /// Contact and loads on each body.
    virtual void bodyForces() = 0;
    /// Kinetic energies and closing works of blocks of nodes, into NodeFields::blockEnergy, with
    /// the forces of surfaces that are met exactly or without.
    virtual void kineticEnergy(bool reactions) = 0;
    /// State of chosen nodes, all where `list` is null, into out[sampleValues][count].
    virtual void sample(const Index* list, Index count, double* out) = 0;
};

template <class Executor>
struct LaunchContext;
/// Instantiated in a unit of its own for each executor and precision.
template <class Numbers, class Executor>
std::unique_ptr<MotionLaunches> makeMotionLaunches(const LaunchContext<Executor>& context);

} // namespace fpm
