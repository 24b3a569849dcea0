#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/distribute/ForceSum.h"
#include "kernels/particle/Amplitude.h"
#include "kernels/particle/InteriorNodes.h"
#include "parallel/LaunchSizes.h"
#include "parallel/Vec3.h"

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

/// Equation of motion of a node, eq. (1) of the paper: sums its forces in one fixed order (element
/// partial sums in patch order, contact, loads, mass damping, constraints) and advances it by one
/// step, eq. (3).
template <class Numbers>
struct NodeMotion {
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;
    using Work = typename Numbers::Work;

    Index nodeCount;
    const Index* list;  ///< the nodes, null: all
    Position* position; ///< three planes, nodeStride apart
    Motion* velocity;
    const Motion* inverseMass;
    std::size_t nodeStride;
    const Work* interiorForce;     ///< of the elements, three planes: nodes of one patch
    std::size_t interiorEnd;       ///< end of those nodes, and distance between the planes
    std::size_t firstBoundaryNode; ///< all nodes before it are such nodes
    const Index* partialSumsStart; ///< partial sums of the other nodes, one per patch: CSR
    const Index* partialSums;
    const Work* partialForce;         ///< x y z each
    const std::uint8_t* fixed;        ///< FixedBit: held components and body nodes
    const Index* contactNode;         ///< number among the contact nodes, -1; null without contact
    const std::int64_t* contactForce; ///< fixed point, [contact node][4]
    ForceScale contactScale;
    const Index* conditionStart; ///< uses of a node: CSR; null without conditions
    const ConditionUse* uses;
    const Condition* conditions;
    const double* amplitudeRows;
    const Index* frameOf;       ///< axes of a node's components, -1: global; null: all global
    const double* frames;       ///< nine values each, rows are directions
    const Index* pressureStart; ///< pressure slots of a node: CSR; null without pressures
    const Index* pressureSlots;
    const Motion* pressureForce;
    std::size_t pressureStride;
    Motion massDamping;
    bool ledger;       ///< sum the works (a scene without loads, prescribed motion and damping
                       ///< needs none)
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
        if constexpr (Team::oneThread)
            for (Index i = 0; i < count; ++i) askForForces(nodeOf(first + i));
        team.forEach(count, [&](Index i) { advance(nodeOf(first + i), values + i); });
        if (!ledger) return;
        team.barrier();
        blockSums(team, nodeWorks, count, values, nodeBlock, partial);
        team.barrier();
        double* sums = blockWork + std::size_t(block) * nodeWorks;
        team.forEach(nodeWorks, [=](Index k) { sums[k] += blockSumResult(partial, k); });
    }

    FPM_KERNEL Index nodeOf(Index entry) const { return list ? list[entry] : entry; }
    /// The forces on a node were written by patches and contact passes, at no constant stride.
    FPM_KERNEL void askForForces(Index number) const
    {
        const std::size_t node = std::size_t(number);
        const Rows sums = partialSumsOf(node);
        for (Index k = sums.first; k < sums.last; ++k)
            prefetch(partialForce + 3 * std::size_t(partialSums[k]));
        if (contactNode && contactNode[node] >= 0)
            prefetch(contactForce + 4 * std::size_t(contactNode[node]));
    }

    /// Damping coefficient xi of this step: that of the case and that of dynamic relaxation.
    FPM_KERNEL Motion dampingRate() const { return massDamping + Motion(clock->damping); }

    /// Internal force of the elements on a node, eq. (2) of the paper (to be subtracted).
    FPM_KERNEL Vec3<Motion> internalForce(std::size_t node) const
    {
        const Rows sums = partialSumsOf(node);
        if (sums.first == sums.last)
            return {Motion(interiorForce[node]), Motion(interiorForce[interiorEnd + node]),
                    Motion(interiorForce[2 * interiorEnd + node])};
        Vec3<Motion> sum{0, 0, 0};
        for (Index k = sums.first; k < sums.last; ++k) {
            const Work* part = partialForce + 3 * std::size_t(partialSums[k]);
            sum += {Motion(part[0]), Motion(part[1]), Motion(part[2])};
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
    /// Stiffness of the contact springs at a node as it enters the stability bound.
    FPM_KERNEL double contactStiffness(std::size_t node) const
    {
        if (!contactNode || contactNode[node] < 0) return 0;
        return contactScale.toStiffness(contactForce[4 * std::size_t(contactNode[node]) + 3]);
    }
    FPM_KERNEL Vec3<double> place(std::size_t node) const
    {
        return {double(position[node]), double(position[nodeStride + node]),
                double(position[2 * nodeStride + node])};
    }
    /// Loads on a node at `time`; pressures are those of the current positions.
    FPM_KERNEL Vec3<Motion> load(std::size_t node, double time) const
    {
        double sum[3] = {0, 0, 0};
        if (conditionStart)
            for (Index k = conditionStart[node]; k < conditionStart[node + 1]; ++k) {
                if (uses[k].axis >= 0) continue;
                const Condition& condition = conditions[uses[k].condition];
                const double factor = uses[k].first * amplitudeAt(condition, amplitudeRows, time);
                for (int c = 0; c < 3; ++c) sum[c] += factor * condition.value[c];
            }
        Vec3<Motion> total{Motion(sum[0]), Motion(sum[1]), Motion(sum[2])};
        if (pressureStart)
            for (Index k = pressureStart[node]; k < pressureStart[node + 1]; ++k) {
                const std::size_t slot = std::size_t(pressureSlots[k]);
                total += {pressureForce[slot], pressureForce[pressureStride + slot],
                          pressureForce[2 * pressureStride + slot]};
            }
        return total;
    }

    /// True when component c of the node's motion, in its axes, is fixed or prescribed.
    FPM_KERNEL bool imposed(std::size_t node, int c) const
    {
        if (fixed[node] & heldComponent(c)) return true;
        if (conditionStart)
            for (Index k = conditionStart[node]; k < conditionStart[node + 1]; ++k)
                if (uses[k].axis == c) return true;
        return false;
    }

    /// Transforms a vector from global to the node's axes, and back. True where the axes differ.
    template <class Real>
    FPM_KERNEL bool toOwnAxes(std::size_t node, Vec3<Real>& a) const
    {
        if (!frameOf || frameOf[node] < 0) return false;
        a = ownAxes<Real>(node) * a;
        return true;
    }
    template <class Real>
    FPM_KERNEL bool fromOwnAxes(std::size_t node, Vec3<Real>& a) const
    {
        if (!frameOf || frameOf[node] < 0) return false;
        a = transpose(ownAxes<Real>(node)) * a;
        return true;
    }
    FPM_KERNEL Vec3<Motion> velocityOf(std::size_t node) const
    {
        return {velocity[node], velocity[nodeStride + node], velocity[2 * nodeStride + node]};
    }
    /// Sets the fixed and prescribed components of a vector in global axes to 0.
    FPM_KERNEL void removeImposed(std::size_t node, double (&a)[3]) const
    {
        Vec3<double> left{a[0], a[1], a[2]};
        toOwnAxes(node, left);
        left = {imposed(node, 0) ? 0 : left.x, imposed(node, 1) ? 0 : left.y,
                imposed(node, 2) ? 0 : left.z};
        fromOwnAxes(node, left);
        a[0] = left.x;
        a[1] = left.y;
        a[2] = left.z;
    }

private:
    struct Rows {
        Index first, last;
    };
    FPM_KERNEL Rows partialSumsOf(std::size_t node) const
    {
        if (node < firstBoundaryNode) return {0, 0};
        const Index* start = partialSumsStart + (node - firstBoundaryNode);
        return {start[0], start[1]};
    }

    template <class Real>
    FPM_KERNEL Mat3<Real> ownAxes(std::size_t node) const
    {
        const double* m = frames + 9 * std::size_t(frameOf[node]);
        return {{Real(m[0]), Real(m[1]), Real(m[2])},
                {Real(m[3]), Real(m[4]), Real(m[5])},
                {Real(m[6]), Real(m[7]), Real(m[8])}};
    }

    /// Velocity prescribed for component c over the next step, if any.
    FPM_KERNEL bool driven(std::size_t node, int c, Motion& v) const
    {
        if (!conditionStart) return false;
        for (Index k = conditionStart[node]; k < conditionStart[node + 1]; ++k) {
            if (uses[k].axis != c) continue;
            v = Motion(drivenVelocity(conditions[uses[k].condition], uses[k], amplitudeRows,
                                      clock->time, clock->step));
            return true;
        }
        return false;
    }

    FPM_KERNEL void advance(Index number, double* work) const
    {
        const std::size_t node = std::size_t(number);
        if (ledger)
            for (int k = 0; k < nodeWorks; ++k) work[k * nodeBlock] = 0;
        if (fixed[node] & bodyNode) return;
        Vec3<Motion> internal = internalForce(node), touch = contact(node),
                     outer = load(node, clock->time - clock->step), old = velocityOf(node);
        if (toOwnAxes(node, old)) {
            toOwnAxes(node, internal);
            toOwnAxes(node, touch);
            toOwnAxes(node, outer);
        }
        Vec3<Motion> next{component(node, 0, internal.x, touch.x, outer.x, old.x, work),
                          component(node, 1, internal.y, touch.y, outer.y, old.y, work),
                          component(node, 2, internal.z, touch.z, outer.z, old.z, work)};
        fromOwnAxes(node, next);
        const Motion dt = Motion(clock->step), v[3] = {next.x, next.y, next.z};
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = c * nodeStride + node;
            velocity[at] = v[c];
            position[at] = advanced(position[at], dt * v[c]);
        }
    }

    /// Next velocity of one component in the node's axes; accounts for its works.
    FPM_KERNEL Motion component(
        std::size_t node, int c, Motion in, Motion ct, Motion ex, Motion old, double* work) const
    {
        const Motion h = Motion(clock->mean), inverse = inverseMass[node], force = ex - in + ct;
        const Motion xi = dampingRate();
        Motion v = leapFrogVelocity(old, force, inverse, h, xi);
        Motion imposed = 0;
        const bool held = fixed[node] & heldComponent(c);
        const bool drives = !held && driven(node, c, imposed);
        if (held || drives) v = imposed;
        if (!ledger) return v;
        const Motion previous = Motion(2 * clock->mean - clock->step); // the step before
        const double before = 0.5 * double(previous) * double(old),
                     after = 0.5 * double(Motion(clock->step)) * double(v);
        work[internalBefore * nodeBlock] -= double(in) * before;
        work[internalAfter * nodeBlock] -= double(in) * after;
        work[contactBefore * nodeBlock] += double(ct) * before;
        work[contactAfter * nodeBlock] += double(ct) * after;
        work[externalBefore * nodeBlock] += double(ex) * before;
        work[externalAfter * nodeBlock] += double(ex) * after;
        const double mean = 0.5 * (double(old) + double(v));
        const double mass = inverse > 0 ? 1 / double(inverse) : 0;
        work[damping * nodeBlock] += double(h) * double(xi) * mass * mean * mean;
        if (!held && !drives) return v;
        // Reaction of the prescribed motion: R of m dv/dt = F - xi m v + R.
        const double reaction =
            (double(v) - double(old)) * mass / double(h) - double(force) + double(xi) * mass * mean;
        work[driveBefore * nodeBlock] += reaction * before;
        work[driveAfter * nodeBlock] += reaction * after;
        return v;
    }
};

} // namespace fpm
