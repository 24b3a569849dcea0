#pragma once

#include "kernels/contact/edges/EdgeTracking.h"
#include "kernels/contact/narrow/Overlap.h"

namespace fpm {

/// Last kernel of a step of edge contact: the penalty force k |g| along the normal, friction and
/// damping on the four nodes of each pair that bears. One team = one block of contactors.
template <class Numbers>
struct EdgeForce {
    using Work = typename Numbers::Work;
    EdgePassView<Numbers> edges;

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index number) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        if (!pass.clock->running) return;
        const Index first = number * contactBlock, left = pass.contactorCount - first,
                    size = left < contactBlock ? left : contactBlock;
        const BlockForce total{pass.force + std::size_t(number) * BlockForce::values,
                               pass.contactorForce, Team::oneThread};
        team.forEach(BlockForce::values, [=](Index k) { total.sums[k] = 0; });
        if (total.each)
            team.forEach(3 * size, [=](Index k) { total.each[3 * std::size_t(first) + k] = 0; });
        team.barrier();
        team.forEach(
            size, [&](Index k) __attribute__((always_inline)) { apply(first + k, total); });
    }

private:
    FPM_KERNEL void apply(Index i, const BlockForce& total) const
    {
        switch (edges.phase[i]) {
        case phaseApart:
            edges.state[i] = edgesApart;
            return;
        case phaseReleased:
            return;
        case phaseOpposite:
            oppose(i, total);
            return;
        case phaseOpens:
        case phaseLost:
            separate(i);
            return;
        case phaseEnters:
            if (edges.passedOn[i] == heldByNodes)
                edges.state[i] = edgesApart;
            else
                bear(i, total);
            return;
        case phaseLeaves:
            if (edges.passedOn[i] >= 0 && edges.passedOn[edges.passedOn[i]] == i)
                forget(i);
            else
                bear(i, total);
            return;
        default:
            bear(i, total);
        }
    }

    /// Open: every spring within reach enters the stability bound before it closes.
    FPM_KERNEL void oppose(Index i, const BlockForce& total) const
    {
        const EdgePair<Numbers> pair(edges, i);
        edges.state[i] = edgesOpen;
        edges.pass.xi[i] = pair.at.s;
        edges.pass.eta[i] = pair.at.t;
        if (edges.passedOn[i] == heldByNodes) return;
        distribute(i, pair, stiffnessOf(i, pair), Work(0), {Work(0), Work(0), Work(0)}, total);
    }
    FPM_KERNEL void separate(Index i) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        const EdgePair<Numbers> pair(edges, i);
        const bool lost = edges.phase[i] != phaseOpens;
        open(i, stiffnessOf(i, pair), pass.law.damps() ? gapChange(pair) : Work(0),
             lost ? Work(-1) : pair.at.gap);
        pass.overlap[i] = 0;
        if (pass.injected) pass.injected[pass.contactorCount + i] = 0; // see relievedGap
        edges.state[i] = pair.at.isInner() ? edgesOpen : edgesApart;
        if (!lost) return;
        const bool deep = !pair.isBeyond();
        edges.state[i] = deep ? edgesReleased : edgesApart;
        atomicAdd64(pass.counts + (deep ? countReleased : countOverEdge), 1);
    }
    /// Another slot has taken over what this one held.
    FPM_KERNEL void forget(Index i) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        pass.law.springEnergy[i] = 0;
        pass.overlap[i] = 0;
        if (pass.injected) pass.injected[pass.contactorCount + i] = 0;
        if (pass.law.damps()) pass.law.dampingForce[i] = 0;
        if (pass.law.friction.acts()) pass.law.store(i, {Work(0), Work(0), Work(0)});
        edges.state[i] = edgesApart;
    }
    /// `gap`: as in PassLaw::open.
    FPM_KERNEL void open(Index i, Work stiffness, Work change, Work gap) const
    {
        if (edges.pass.law.springEnergy[i] > 0) edges.pass.law.open(i, stiffness, change, gap);
    }

    /// A closed spring keeps the stiffness with which it closed, also beyond a joint.
    FPM_KERNEL Work stiffnessOf(Index i, const EdgePair<Numbers>& pair) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        if (pass.heldStiffness && pass.law.springEnergy[i] > 0 && pass.heldStiffness[i] > 0)
            return pass.heldStiffness[i];
        return pass.law.stiffness(i, pass.faceStiffness[pair.second]);
    }
    /// Change of the gap in this step.
    FPM_KERNEL Work gapChange(const EdgePair<Numbers>& pair) const
    {
        const Vec3<Work> apart =
            edges.velocityAt(pair.second, pair.at.t) - edges.velocityAt(pair.first, pair.at.s);
        return Work(edges.pass.clock->step) * dot(apart, pair.at.normal);
    }

    FPM_KERNEL void bear(Index i, const BlockForce& total) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        const EdgePair<Numbers> pair(edges, i);
        const bool closes = edges.phase[i] == phaseEnters && edges.passedOn[i] < 0;
        const bool known = !closes || edges.state[i] == edgesOpen;
        if (!known) forgive(i, pair.at.gap);
        const Work stiffness = stiffnessOf(i, pair);
        const Work change = pass.law.asksGapChange(i, pair.at.gap) ? gapChange(pair) : Work(0);
        const Work gap = relievedGap(pass, i, pair.at.gap, stiffness);
        const Work ds = known ? pair.at.s - pass.xi[i] : Work(0),
                   dt = known ? pair.at.t - pass.eta[i] : Work(0);
        edges.state[i] = edgesClosed;
        pass.xi[i] = pair.at.s;
        pass.eta[i] = pair.at.t;
        Vec3<Work> friction{0, 0, 0}, held{0, 0, 0};
        Work normalForce = 0;
        if (gap < 0) {
            const Work mass =
                pass.law.damps() ? pass.law.lesserMass(i, pass.faceMass[pair.second]) : Work(0);
            normalForce = pass.law.normalForce(i, stiffness, gap, mass, change, pass.clock->step);
            if (pass.law.friction.acts()) {
                const EdgeFrame<Work> frame = pair.frame();
                const Vec3<Work> slip = dt * pair.b.along - ds * pair.a.along;
                held = pass.law.slide(i, pass.law.storedForce(i), frame.components(slip), stiffness,
                                      normalForce, pass.clock->step);
                friction = frame.vector(held);
            }
            pass.law.springEnergy[i] = pass.law.energy(stiffness, gap, held);
            if (pass.heldStiffness) pass.heldStiffness[i] = stiffness;
        } else
            open(i, stiffness, change, gap);
        distribute(i, pair, stiffness, normalForce, friction, total);
    }
    /// First seen inside: its depth is forgiven, as that of contactors is (SlotChoice).
    FPM_KERNEL void forgive(Index i, Work gap) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        pass.overlap[i] =
            notLess(pass.fadeTime > 0 ? -gap / pass.forgivenShare(pass.clock->time) : -gap);
        if (pass.injected) pass.injected[pass.contactorCount + i] = 0; // see relievedGap
        if (-gap > Work(0.1) * pass.reach) atomicAdd64(pass.counts + countInside, 1);
    }

    /// The force on the second node is minus the exact sum of the other three.
    FPM_KERNEL void distribute(Index i,
                               const EdgePair<Numbers>& pair,
                               Work stiffness,
                               Work normalForce,
                               const Vec3<Work>& friction,
                               const BlockForce& total) const
    {
        const ContactSums& sums = edges.pass.sums;
        const Work bound = Work(2) * edges.pass.law.limitFactor * stiffness,
                   weight[4] = {1 - pair.at.s, pair.at.s, 1 - pair.at.t, pair.at.t};
        Index number[4];
        for (int k = 0; k < 4; ++k) {
            const Index segment = k < 2 ? pair.first : pair.second;
            number[k] = edges.pass.contactNumber[edges.nodeOf(segment, k & 1)];
            sums.addStiffness(number[k], double(magnitude(weight[k]) * bound));
        }
        if (!(normalForce > 0)) return;
        const EdgeForces<Work> forces(pair.a, pair.b, pair.at, normalForce, friction);
        std::int64_t own[3] = {0, 0, 0};
        for (int k = 3; k > 1; --k) addForce(number[k], forces.node[k], own);
        total.add(i, own);
        addForce(number[0], forces.node[0], own);
        sums.addForce(number[1], own);
    }
    /// Adds the force on a node and takes it from the rest.
    FPM_KERNEL void addForce(Index number, const Vec3<Work>& force, std::int64_t (&rest)[3]) const
    {
        const ContactSums& sums = edges.pass.sums;
        const std::int64_t part[3] = {sums.scale.force(double(force.x)),
                                      sums.scale.force(double(force.y)),
                                      sums.scale.force(double(force.z))};
        for (int c = 0; c < 3; ++c) rest[c] -= part[c];
        sums.addForce(number, part);
    }
};

} // namespace fpm
