#pragma once

#include "kernels/particle/RigidBody.h"

namespace fpm {

/// Consecutive nodes of one body on which forces may act, at most nodeBlock.
struct BodyBlock {
    Index body, first, count; ///< in the list of loaded body nodes
};

/// Contact force and moment, load force and moment about the centre, then the stiffness of the
/// contact springs over the effective mass of the body at the node.
inline constexpr int bodySums = 13;

constexpr std::size_t bodyScratch()
{
    return bodySums * nodeBlock * sizeof(double) + blockSumScratch(bodySums);
}

/// Sums the forces on the nodes of a block about the centre of their body.
template <class Numbers>
struct BodyForces {
    NodeMotion<Numbers> nodes;
    const BodyBlock* blocks;
    const Index* loaded;       ///< nodes
    const double* inverseMass; ///< of each loaded node, see bodyInverseMass
    const RigidBody* bodies;
    double* sums; ///< [block][bodySums]

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index number) const
    {
        if (!nodes.clock->running) return;
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + bodySums * nodeBlock;
        const BodyBlock block = blocks[number];
        const Vec3<double> centre = bodies[block.body].centre;
        team.forEach(block.count, [&](Index i) { book(block.first + i, centre, values + i); });
        team.barrier();
        blockSums(team, bodySums, block.count, values, nodeBlock, partial);
        team.barrier();
        double* out = sums + std::size_t(number) * bodySums;
        team.forEach(bodySums, [=](Index k) { out[k] = blockSumResult(partial, k); });
    }

private:
    FPM_KERNEL void book(Index entry, const Vec3<double>& centre, double* out) const
    {
        const std::size_t node = std::size_t(loaded[entry]);
        const auto touch = nodes.contact(node), load = nodes.load(node, nodes.clock->time);
        const Vec3<double> arm = nodes.place(node) - centre;
        const Vec3<double> ct{double(touch.x), double(touch.y), double(touch.z)},
            ex{double(load.x), double(load.y), double(load.z)}, ctMoment = cross(arm, ct),
                                                                exMoment = cross(arm, ex);
        const Vec3<double> all[4] = {ct, ctMoment, ex, exMoment};
        for (int k = 0; k < 4; ++k) {
            out[(3 * k) * nodeBlock] = all[k].x;
            out[(3 * k + 1) * nodeBlock] = all[k].y;
            out[(3 * k + 2) * nodeBlock] = all[k].z;
        }
        out[12 * nodeBlock] = nodes.contactStiffness(node) * inverseMass[entry];
    }
};

/// Sums the blocks of a body and the loads that act on the whole body (gravity): its forces at the
/// clock's time, and the bound of its contact springs, 2 sum k / m, since all springs share one
/// mass.
struct BodySum {
    RigidBody* bodies;
    const Index* blockStart; ///< blocks of a body: consecutive
    const double* sums;
    const Index* useStart; ///< loads of a body: CSR
    const ConditionUse* uses;
    const Condition* conditions;
    const double* amplitudeRows;
    double* contactBound; ///< of each body
    const StepClock* clock;

    static constexpr std::size_t scratch() { return blockSumScratch(bodySums); }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index number) const
    {
        if (!clock->running) return;
        double* partial = reinterpret_cast<double*>(team.scratch());
        const Index first = blockStart[number], count = blockStart[number + 1] - first;
        const double* mine = sums + std::size_t(first) * bodySums;
        team.forEach(bodySums * blockSumLanes, [=](Index lane) {
            double sum = 0;
            for (Index i = lane % blockSumLanes; i < count; i += blockSumLanes)
                sum += mine[std::size_t(i) * bodySums + std::size_t(lane / blockSumLanes)];
            partial[lane] = sum;
        });
        team.barrier();
        team.forEach(1, [&](Index) { close(number, partial); });
    }

private:
    FPM_KERNEL void close(Index number, const double* partial) const
    {
        double s[bodySums];
        for (int k = 0; k < bodySums; ++k) s[k] = blockSumResult(partial, k);
        RigidBody& body = bodies[number];
        body.contact = {{s[0], s[1], s[2]}, {s[3], s[4], s[5]}};
        body.outer = {{s[6], s[7], s[8]}, {s[9], s[10], s[11]}};
        for (Index k = useStart[number]; k < useStart[number + 1]; ++k) {
            const Condition& condition = conditions[uses[k].condition];
            const double factor =
                uses[k].first * amplitudeAt(condition, amplitudeRows, clock->time);
            body.outer.force +=
                factor * Vec3<double>{condition.value[0], condition.value[1], condition.value[2]};
        }
        contactBound[number] = s[12];
    }
};

/// Moves the nodes of the bodies with their body; velocities are displacement increment over step.
template <class Numbers>
struct BodyMotion {
    const Index* list; ///< nodes of all bodies
    const Index* bodyOf;
    const double* arm; ///< three planes of `count`, from the centre at the start
    Index count;
    const RigidBody* bodies;
    typename Numbers::Position* position;
    typename Numbers::Motion* velocity;
    std::size_t nodeStride;
    const StepClock* clock;

    FPM_KERNEL void operator()(Index i) const
    {
        if (!clock->running) return;
        const std::size_t node = std::size_t(list[i]), planes = std::size_t(count);
        const RigidBody& body = bodies[bodyOf[node]];
        const Vec3<double> turned =
            rotationOf(body.q) * Vec3<double>{arm[i], arm[planes + i], arm[2 * planes + i]};
        const double now[3] = {body.centre.x + turned.x, body.centre.y + turned.y,
                               body.centre.z + turned.z};
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = c * nodeStride + node;
            const double before = double(position[at]);
            position[at] = typename Numbers::Position(now[c]);
            velocity[at] = typename Numbers::Motion((now[c] - before) / clock->step);
        }
    }
};

} // namespace fpm
