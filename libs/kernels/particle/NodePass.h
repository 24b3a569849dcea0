#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/ForceSum.h"
#include "kernels/particle/Amplitude.h"
#include "kernels/particle/LeapFrog.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"
#include "parallel/Vec3.h"

namespace fpm {

inline constexpr Index nodeBlock = 256;

/// Works done on the nodes, trapezoidal in time: half with the increment that led to the positions
/// (known now), half with the next one. Order of the sums in NodePass::blockWork.
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

/// Sums the forces of a node in one fixed order and advances it by one step (the particle solver of
/// the paper): element partial sums in patch order, contact, loads, mass damping, constraints.
template <class Precision>
struct NodePass {
    using Position = typename Precision::Position;
    using Motion = typename Precision::Motion;
    using Work = typename Precision::Work;

    Index nodeCount;
    Position* position; ///< three planes, nodeStride apart
    Motion* velocity;
    const Motion* inverseMass;
    std::size_t nodeStride;
    const Index* slotStart; ///< slots of a node: CSR
    const Index* slots;
    const Work* slotForce;
    std::size_t slotStride;
    const std::uint8_t* fixed;        ///< bits 0..2: component held at zero velocity
    const Index* contactNode;         ///< number among the contact nodes, -1; null without contact
    const std::int64_t* contactForce; ///< fixed point, [contact node][4]
    ForceScale contactScale;
    const Index* conditionStart; ///< conditions of a node: CSR; null without conditions
    const Index* conditionOf;
    const Condition* conditions;
    const double* amplitudeRows;
    Motion massDamping;
    bool ledger;       ///< book the works (a scene without loads, drives, damping needs none)
    double* blockWork; ///< [block][nodeWorks], running sums
    const StepClock* clock;

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index block) const
    {
        if (!clock->running) return;
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + nodeWorks * nodeBlock;
        const Index first = block * nodeBlock;
        const Index count = nodeCount - first < nodeBlock ? nodeCount - first : nodeBlock;
        team.forEach(count, [&](Index i) { advance(first + i, values + i); });
        if (!ledger) return;
        team.barrier();
        blockSums(team, nodeWorks, count, values, nodeBlock, partial);
        team.barrier();
        double* sums = blockWork + std::size_t(block) * nodeWorks;
        team.forEach(nodeWorks, [=](Index k) { sums[k] += blockSumResult(partial, k); });
        team.barrier();
    }

    /// xi of this step: the case's and that of dynamic relaxation.
    FPM_KERNEL Motion dampingRate() const { return massDamping + Motion(clock->damping); }

    /// Internal force of the elements on a node (to be subtracted).
    FPM_KERNEL Vec3<Motion> internalForce(std::size_t node) const
    {
        Vec3<Motion> sum{0, 0, 0};
        for (Index k = slotStart[node]; k < slotStart[node + 1]; ++k) {
            const std::size_t slot = std::size_t(slots[k]);
            sum += {Motion(slotForce[slot]), Motion(slotForce[slotStride + slot]),
                    Motion(slotForce[2 * slotStride + slot])};
        }
        return sum;
    }
    FPM_KERNEL Vec3<Motion> contact(std::size_t node) const
    {
        if (!contactNode || contactNode[node] < 0) return {0, 0, 0};
        const std::int64_t* sum = contactForce + 4 * std::size_t(contactNode[node]);
        return {Motion(contactScale.toForce(sum[0])), Motion(contactScale.toForce(sum[1])),
                Motion(contactScale.toForce(sum[2]))};
    }
    /// Loads on a node at `time`.
    FPM_KERNEL Vec3<Motion> load(std::size_t node, double time) const
    {
        double sum[3] = {0, 0, 0};
        if (conditionStart)
            for (Index k = conditionStart[node]; k < conditionStart[node + 1]; ++k) {
                const Condition& condition = conditions[conditionOf[k]];
                if (condition.kind != 2) continue;
                const double factor = amplitudeAt(condition, amplitudeRows, time);
                for (int c = 0; c < 3; ++c) sum[c] += factor * condition.value[c];
            }
        return {Motion(sum[0]), Motion(sum[1]), Motion(sum[2])};
    }

    /// True when component c of the node's motion is held or driven.
    FPM_KERNEL bool imposed(std::size_t node, int c) const
    {
        if ((fixed[node] >> c) & 1) return true;
        if (conditionStart)
            for (Index k = conditionStart[node]; k < conditionStart[node + 1]; ++k) {
                const Condition& condition = conditions[conditionOf[k]];
                if (condition.kind != 2 && ((condition.components >> c) & 1)) return true;
            }
        return false;
    }

private:
    /// Velocity imposed on component c over the coming step, if any.
    FPM_KERNEL bool driven(std::size_t node, int c, Motion& v) const
    {
        if (!conditionStart) return false;
        for (Index k = conditionStart[node]; k < conditionStart[node + 1]; ++k) {
            const Condition& condition = conditions[conditionOf[k]];
            if (condition.kind == 2 || !((condition.components >> c) & 1)) continue;
            const double end = clock->time, start = end - clock->step;
            if (condition.kind == 0) // exact tracking: (u(end) - u(start)) / dt
                v = Motion(condition.value[c]
                           * (amplitudeAt(condition, amplitudeRows, end)
                              - amplitudeAt(condition, amplitudeRows, start))
                           / clock->step);
            else
                v = Motion(condition.value[c]
                           * amplitudeAt(condition, amplitudeRows, 0.5 * (start + end)));
            return true;
        }
        return false;
    }

    FPM_KERNEL void advance(Index number, double* work) const
    {
        const std::size_t node = std::size_t(number);
        const Vec3<Motion> internal = internalForce(node), touch = contact(node),
                           outer = load(node, clock->time - clock->step);
        const Motion in[3] = {internal.x, internal.y, internal.z},
                     ct[3] = {touch.x, touch.y, touch.z}, ex[3] = {outer.x, outer.y, outer.z};
        const Motion h = Motion(clock->mean), dt = Motion(clock->step), inverse = inverseMass[node];
        const Motion xi = dampingRate();
        const Motion previous = Motion(2 * clock->mean - clock->step); // the step before
        if (ledger)
            for (int k = 0; k < nodeWorks; ++k) work[k * nodeBlock] = 0;
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = c * nodeStride + node;
            const Motion old = velocity[at], force = ex[c] - in[c] + ct[c];
            Motion v = leapFrogVelocity(old, force, inverse, h, xi);
            Motion imposed = 0;
            const bool held = (fixed[node] >> c) & 1;
            const bool drives = !held && driven(node, c, imposed);
            if (held || drives) v = imposed;
            velocity[at] = v;
            position[at] = advanced(position[at], dt * v);
            if (!ledger) continue;
            const double before = 0.5 * double(previous) * double(old),
                         after = 0.5 * double(dt) * double(v);
            work[internalBefore * nodeBlock] -= double(in[c]) * before;
            work[internalAfter * nodeBlock] -= double(in[c]) * after;
            work[contactBefore * nodeBlock] += double(ct[c]) * before;
            work[contactAfter * nodeBlock] += double(ct[c]) * after;
            work[externalBefore * nodeBlock] += double(ex[c]) * before;
            work[externalAfter * nodeBlock] += double(ex[c]) * after;
            const double mean = 0.5 * (double(old) + double(v));
            const double mass = inverse > 0 ? 1 / double(inverse) : 0;
            const double lost = double(h) * double(xi) * mass * mean * mean;
            work[damping * nodeBlock] += lost;
            if (!held && !drives) continue;
            // Reaction of the drive: what is missing in m dv/dt = F - xi m v + R.
            const double reaction = (double(v) - double(old)) * mass / double(h) - double(force)
                                    + double(xi) * mass * mean;
            work[driveBefore * nodeBlock] += reaction * before;
            work[driveAfter * nodeBlock] += reaction * after;
        }
    }
};

} // namespace fpm
