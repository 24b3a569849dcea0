#pragma once

#include "kernels/BlockSum.h"
#include "parallel/LaunchSizes.h"

namespace fpm {

/// Works done on the nodes, trapezoidal in time: half with the increment that led to the positions
/// (known now), half with the next one. Order of the sums in NodeMotion::blockWork.
enum NodeWork {
    internalBefore,
    internalAfter,
    contactBefore,
    contactAfter,
    externalBefore,
    externalAfter,
    driveBefore,
    driveAfter,
    damping,
    nodeWorks
};

constexpr std::size_t nodeScratch()
{
    return nodeWorks * nodeBlock * sizeof(double) + blockSumScratch(nodeWorks);
}

/// A step of the leapfrog: its end, its length and the mean of it and the one before.
struct LeapFrogStep {
    double end, length, mean;
    FPM_KERNEL double previous() const { return 2 * mean - length; }
};

/// Accounts for the works of a step of one node.
template <class Motion>
struct NodeBooks {
    LeapFrogStep step;
    Motion inverseMass, damping; ///< xi
    double* work;

    /// Of one component in the node's axes: forces of elements, contact and loads, velocities at
    /// the two mid-steps; `imposed`: held or prescribed.
    FPM_KERNEL void add(Motion in, Motion ct, Motion ex, Motion old, Motion v, bool imposed) const
    {
        const Motion h = Motion(step.mean), force = ex - in + ct;
        const double before = 0.5 * double(Motion(step.previous())) * double(old),
                     after = 0.5 * double(Motion(step.length)) * double(v);
        work[internalBefore * nodeBlock] -= double(in) * before;
        work[internalAfter * nodeBlock] -= double(in) * after;
        work[contactBefore * nodeBlock] += double(ct) * before;
        work[contactAfter * nodeBlock] += double(ct) * after;
        work[externalBefore * nodeBlock] += double(ex) * before;
        work[externalAfter * nodeBlock] += double(ex) * after;
        const double mean = 0.5 * (double(old) + double(v));
        const double mass = inverseMass > 0 ? 1 / double(inverseMass) : 0;
        work[NodeWork::damping * nodeBlock] += double(h) * double(damping) * mass * mean * mean;
        if (!imposed) return;
        // Reaction of the prescribed motion: R of m dv/dt = F - xi m v + R.
        const double reaction = (double(v) - double(old)) * mass / double(h) - double(force)
                                + double(damping) * mass * mean;
        work[driveBefore * nodeBlock] += reaction * before;
        work[driveAfter * nodeBlock] += reaction * after;
    }
};

} // namespace fpm
