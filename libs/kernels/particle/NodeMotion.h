#pragma once

#include "kernels/contact/distribute/ForceSum.h"
#include "kernels/contact/law/KinematicContact.h"
#include "kernels/particle/Amplitude.h"
#include "kernels/particle/InteriorNodes.h"
#include "kernels/particle/NodeBooks.h"
#include "parallel/Vec3.h"

namespace fpm {

/// Equation of motion of a node, eq. (1) of the paper: sums its forces in one fixed order (element
/// partial sums in patch order, contact, loads, mass damping, constraints) and advances it by one
/// step, eq. (3); a NodeMotionOnSurfaces corrects the step where analytic surfaces are in the way.
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
    KinematicContact surfaces;
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
        advanceBlock<false>(team, block);
    }

    template <bool onSurfaces, class Team>
    FPM_KERNEL void advanceBlock(const Team& team, Index block) const
    {
        if (!clock->running) return;
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + nodeWorks * nodeBlock;
        const Index first = block * nodeBlock;
        const Index count = nodeCount - first < nodeBlock ? nodeCount - first : nodeBlock;
        if constexpr (Team::oneThread)
            for (Index i = 0; i < count; ++i) askForForces(nodeOf(first + i));
        team.forEach(count, [&](Index i) { advance<onSurfaces>(nodeOf(first + i), values + i); });
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
    /// Force of the contact springs.
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

    /// Force of the analytic surfaces that are met exactly, at the time of the positions: that of
    /// the step that follows, should it be as long as the last one.
    FPM_KERNEL Vec3<Motion> reaction(std::size_t node,
                                     SurfaceBooks books = SurfaceBooks::none) const
    {
        if (!surfaces.acts(node) || !(clock->step > 0)) return {0, 0, 0};
        const LeapFrogStep next{clock->time + clock->step, clock->step, clock->step};
        const Forces forces = forcesOn(node, clock->time);
        const Vec3<Motion> old = velocityOf(node);
        Vec3<Motion> speed = predicted(node, forces, old, next).velocity;
        return corrected(node, old, next, books, speed);
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

    struct Forces {
        Vec3<Motion> internal, contact, load;
    };
    FPM_KERNEL Forces forcesOn(std::size_t node, double time) const
    {
        return {internalForce(node), contact(node), load(node, time)};
    }

    /// Velocity prescribed for component c over a step, if any.
    FPM_KERNEL bool driven(std::size_t node, int c, const LeapFrogStep& step, Motion& v) const
    {
        if (!conditionStart) return false;
        for (Index k = conditionStart[node]; k < conditionStart[node + 1]; ++k) {
            if (uses[k].axis != c) continue;
            v = Motion(drivenVelocity(conditions[uses[k].condition], uses[k], amplitudeRows,
                                      step.end, step.length));
            return true;
        }
        return false;
    }

    struct Prediction {
        Vec3<Motion> velocity; ///< at mid-step
        Vec3<Motion> own;      ///< the same in the node's axes
        bool imposed[3];       ///< components there: held or prescribed
    };
    /// The step without surfaces.
    FPM_KERNEL Prediction predicted(std::size_t node,
                                    Forces forces,
                                    Vec3<Motion> old,
                                    const LeapFrogStep& step) const
    {
        if (toOwnAxes(node, old)) {
            toOwnAxes(node, forces.internal);
            toOwnAxes(node, forces.contact);
            toOwnAxes(node, forces.load);
        }
        const Motion in[3] = {forces.internal.x, forces.internal.y, forces.internal.z},
                     ct[3] = {forces.contact.x, forces.contact.y, forces.contact.z},
                     ex[3] = {forces.load.x, forces.load.y, forces.load.z},
                     v[3] = {old.x, old.y, old.z};
        Motion next[3];
        Prediction out;
        for (int c = 0; c < 3; ++c) {
            next[c] = leapFrogVelocity(v[c], ex[c] - in[c] + ct[c], inverseMass[node],
                                       Motion(step.mean), dampingRate());
            Motion prescribed = 0;
            const bool held = fixed[node] & heldComponent(c);
            out.imposed[c] = held || driven(node, c, step, prescribed);
            if (out.imposed[c]) next[c] = prescribed;
        }
        out.velocity = out.own = {next[0], next[1], next[2]};
        fromOwnAxes(node, out.velocity);
        return out;
    }

    FPM_KERNEL FreeDirections freeDirections(std::size_t node) const
    {
        const double one[3] = {imposed(node, 0) ? 0.0 : 1.0, imposed(node, 1) ? 0.0 : 1.0,
                               imposed(node, 2) ? 0.0 : 1.0};
        FreeDirections out{one[0] * one[1] * one[2] > 0,
                           {{one[0], 0, 0}, {0, one[1], 0}, {0, 0, one[2]}}};
        if (!out.all && frameOf && frameOf[node] >= 0) {
            const Mat3<double> axes = ownAxes<double>(node);
            out.projection = transpose(axes) * (out.projection * axes);
        }
        return out;
    }

    /// Corrects a predicted velocity where surfaces are in the way; returns their force.
    FPM_KERNEL Vec3<Motion> corrected(std::size_t node,
                                      const Vec3<Motion>& old,
                                      const LeapFrogStep& step,
                                      SurfaceBooks books,
                                      Vec3<Motion>& speed) const
    {
        const double inverse = double(inverseMass[node]), xi = double(dampingRate());
        if (!(inverse > 0)) return {0, 0, 0};
        const Vec3<double> without = step.length * inDoubles(speed);
        SurfaceStep of{.place = place(node),
                       .velocity = inDoubles(old),
                       .increment = without,
                       .start = step.end - step.length,
                       .previous = step.previous(),
                       .length = step.length,
                       .mean = step.mean,
                       .stiffness =
                           (1 + 0.5 * xi * step.mean) / (inverse * step.mean * step.length),
                       .free = freeDirections(node)};
        const Vec3<double> force = surfaces.correct(node, of, books),
                           change = (1 / step.length) * (of.increment - without);
        speed += {Motion(change.x), Motion(change.y), Motion(change.z)};
        return {Motion(force.x), Motion(force.y), Motion(force.z)};
    }
    FPM_KERNEL static Vec3<double> inDoubles(const Vec3<Motion>& v)
    {
        return {double(v.x), double(v.y), double(v.z)};
    }

    template <bool onSurfaces>
    FPM_KERNEL void advance(Index number, double* work) const
    {
        const std::size_t node = std::size_t(number);
        if (ledger)
            for (int k = 0; k < nodeWorks; ++k) work[k * nodeBlock] = 0;
        if (fixed[node] & bodyNode) return;
        const LeapFrogStep step{clock->time, clock->step, clock->mean};
        Forces forces = forcesOn(node, clock->time - clock->step);
        const Vec3<Motion> old = velocityOf(node);
        Prediction next = predicted(node, forces, old, step);
        if constexpr (onSurfaces)
            if (surfaces.acts(node)) {
                forces.contact += corrected(node, old, step, SurfaceBooks::running, next.velocity);
                next.own = next.velocity;
                toOwnAxes(node, next.own);
            }
        if (ledger) book(node, forces, old, next, step, work);
        const Motion dt = Motion(clock->step),
                     v[3] = {next.velocity.x, next.velocity.y, next.velocity.z};
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = c * nodeStride + node;
            velocity[at] = v[c];
            position[at] = advanced(position[at], dt * v[c]);
        }
    }

    /// Accounts for the works of a step in the node's axes.
    FPM_KERNEL void book(std::size_t node,
                         Forces forces,
                         Vec3<Motion> old,
                         const Prediction& next,
                         const LeapFrogStep& step,
                         double* work) const
    {
        if (toOwnAxes(node, old)) {
            toOwnAxes(node, forces.internal);
            toOwnAxes(node, forces.contact);
            toOwnAxes(node, forces.load);
        }
        const NodeBooks<Motion> books{step, inverseMass[node], dampingRate(), work};
        books.add(forces.internal.x, forces.contact.x, forces.load.x, old.x, next.own.x,
                  next.imposed[0]);
        books.add(forces.internal.y, forces.contact.y, forces.load.y, old.y, next.own.y,
                  next.imposed[1]);
        books.add(forces.internal.z, forces.contact.z, forces.load.z, old.z, next.own.z,
                  next.imposed[2]);
    }
};

} // namespace fpm
