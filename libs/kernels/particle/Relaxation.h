#pragma once

#include "kernels/particle/RigidBody.h"

namespace fpm {

/// Sums of dynamic relaxation over the nodes, in the order of RelaxationSums::blockSum.
enum RelaxationSum {
    relaxationWork,    ///< du . K du of the step before, K du the change of the resultant force
    relaxationInertia, ///< du . M du
    relaxationResidual,
    relaxationForce, ///< squares of the resultants that are free, of all internal forces
    relaxationKinetic,
    relaxationSums
};

constexpr std::size_t relaxationScratch()
{
    return relaxationSums * nodeBlock * sizeof(double) + blockSumScratch(relaxationSums);
}

/// Dynamic relaxation (Underwood 1983), before the clock of a step: estimates the stiffness in the
/// direction of the last step, and the distance from equilibrium. Contact counts like all other
/// resistance. Fixed and prescribed components take no part.
template <class Numbers>
struct RelaxationNodes {
    using Motion = typename Numbers::Motion;

    NodeMotion<Numbers> nodeMotion;
    Motion*
        lastForce;    ///< resultant at the end of the step before, in the node's axes, three planes
    double* blockSum; ///< [block][relaxationSums]

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index block) const
    {
        if (!nodeMotion.clock->mayStep()) return;
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + relaxationSums * nodeBlock;
        const Index first = block * nodeBlock;
        const Index count =
            nodeMotion.nodeCount - first < nodeBlock ? nodeMotion.nodeCount - first : nodeBlock;
        team.forEach(count, [&](Index i) { measure(std::size_t(first + i), values + i); });
        team.barrier();
        blockSums(team, relaxationSums, count, values, nodeBlock, partial);
        team.barrier();
        double* out = blockSum + std::size_t(block) * relaxationSums;
        team.forEach(relaxationSums, [=](Index k) { out[k] = blockSumResult(partial, k); });
    }

private:
    FPM_KERNEL void measure(std::size_t node, double* out) const
    {
        const auto internal = nodeMotion.internalForce(node),
                   contact = nodeMotion.contact(node) + nodeMotion.reaction(node),
                   load = nodeMotion.load(node, nodeMotion.clock->time),
                   motion = nodeMotion.velocityOf(node);
        const Vec3<double> in{double(internal.x), double(internal.y), double(internal.z)};
        Vec3<double> free{double(load.x) + double(contact.x) - in.x,
                          double(load.y) + double(contact.y) - in.y,
                          double(load.z) + double(contact.z) - in.z},
            speed{double(motion.x), double(motion.y), double(motion.z)};
        nodeMotion.toOwnAxes(node, free);
        nodeMotion.toOwnAxes(node, speed);
        const double resultants[3] = {free.x, free.y, free.z},
                     velocity[3] = {speed.x, speed.y, speed.z};
        const double inverse = double(nodeMotion.inverseMass[node]), step = nodeMotion.clock->step;
        const double mass = inverse > 0 ? 1 / inverse : 0;
        double sums[relaxationSums] = {};
        sums[relaxationForce] = dot(in, in);
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = c * nodeMotion.nodeStride + node;
            if (nodeMotion.imposed(node, c)) continue;
            const double resultant = resultants[c], before = double(lastForce[at]);
            lastForce[at] = Motion(resultant);
            const double v = velocity[c], increment = step * v;
            sums[relaxationWork] += (before - resultant) * increment;
            sums[relaxationInertia] += mass * increment * increment;
            sums[relaxationResidual] += resultant * resultant;
            sums[relaxationKinetic] += 0.5 * mass * v * v;
        }
        for (int k = 0; k < relaxationSums; ++k) out[k * nodeBlock] = sums[k];
    }
};

/// The same sums for a free rigid body: its nodes are none of those above. Moments are paired with
/// angular velocities, and divided by the radius of gyration to count as forces.
FPM_KERNEL void addBody(RigidBody& body, double step, double* sums)
{
    const Wrench now{withoutHeldTranslation(body, body.contact.force + body.outer.force),
                     withoutHeldTurns(body, body.contact.moment + body.outer.moment)};
    const Vec3<double> spin = spinOf(body, body.momentum);
    const double inertia = body.mass * dot(body.velocity, body.velocity) + dot(body.momentum, spin);
    sums[relaxationWork] += step
                            * (dot(body.last.force - now.force, body.velocity)
                               + dot(body.last.moment - now.moment, spin));
    sums[relaxationInertia] += step * step * inertia;
    sums[relaxationResidual] +=
        dot(now.force, now.force) + body.mass * dot(now.moment, spinOf(body, now.moment));
    sums[relaxationKinetic] += 0.5 * inertia;
    body.last = now;
}

/// Conditions for a body at rest under constant loads.
struct RelaxationRules {
    double tolerance = 0; ///< of the residual force, and of the square root of the kinetic share
    double heldFrom = 0;  ///< time from which no load, prescribed motion, surface or forgiven depth
                          ///< changes
};

/// Damping of the next step, twice the frequency that follows from the Rayleigh quotient of the
/// last step, so that the slowest remaining mode is damped critically. The run ends when residual
/// and kinetic energy have been small for two radians of that mode: then no turning point is
/// mistaken for rest. One team.
struct RelaxationClock {
    const double* blockSum;
    Index blockCount;
    const double* patchEnergy; ///< [patch][energies], internal first, hourglass third
    Index patchCount, energies;
    RigidBody* bodies;
    Index bodyCount;
    RelaxationRules rules;
    StepClock* clock;

    static constexpr std::size_t scratch() { return blockSumScratch(relaxationSums + 1); }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        double* partial = reinterpret_cast<double*>(team.scratch());
        const double *sums = blockSum, *energy = patchEnergy;
        const Index blocks = blockCount, patches = patchCount, width = energies;
        team.forEach((relaxationSums + 1) * blockSumLanes, [=](Index place) {
            const Index quantity = place / blockSumLanes, lane = place % blockSumLanes;
            double sum = 0;
            if (quantity < relaxationSums)
                for (Index i = lane; i < blocks; i += blockSumLanes)
                    sum += sums[i * relaxationSums + quantity];
            else
                for (Index i = lane; i < patches; i += blockSumLanes)
                    sum += energy[i * width] + energy[i * width + 2];
            partial[place] = sum;
        });
        team.barrier();
        StepClock* out = clock;
        const RelaxationRules how = rules;
        RigidBody* body = bodies;
        const Index count = bodyCount;
        team.forEach(1, [=](Index) {
            if (!out->mayStep()) return;
            double total[relaxationSums + 1];
            for (int k = 0; k <= relaxationSums; ++k) total[k] = blockSumResult(partial, k);
            for (Index i = 0; i < count; ++i) addBody(body[i], out->step, total);
            relax(*out, how, total);
        });
    }

    /// `total`: the sums in their order, then the energy stored.
    FPM_KERNEL static void
    relax(StepClock& clock, const RelaxationRules& rules, const double* total)
    {
        if (total[relaxationWork] > 0 && total[relaxationInertia] > 0)
            clock.damping = 2 * ::sqrt(total[relaxationWork] / total[relaxationInertia]);
        const double stored = total[relaxationSums];
        clock.residual = total[relaxationForce] > 0
                             ? ::sqrt(total[relaxationResidual] / total[relaxationForce])
                             : 1;
        clock.unrest = stored > 0 ? ::sqrt(total[relaxationKinetic] / stored) : 1;
        const bool quiet = clock.time >= rules.heldFrom && clock.residual < rules.tolerance
                           && clock.unrest < rules.tolerance;
        clock.quiet = quiet ? clock.quiet + clock.step : 0;
        if (!quiet || clock.quiet * clock.damping < 4) return;
        clock.settled = 1;
        clock.running = 0;
    }
};

} // namespace fpm
