#pragma once

#include "kernels/contact/broad/Search.h"
#include "kernels/contact/narrow/Overlap.h"
#include "kernels/contact/narrow/Slip.h"
#include "kernels/contact/narrow/SteadyContactors.h"

namespace fpm {

/// Contact force of the contactors of a pass: narrow phase (tracking and closest-point projection),
/// gap g = (x_c - x_p) . n, penalty and friction force on both sides; eqs. (15) to (18) of the
/// paper. `friction`: passes without friction have a kernel of their own, which needs fewer
/// registers on a GPU (doc/performance.md).
template <class Numbers, bool friction>
struct ContactForce {
    using Work = typename Numbers::Work;
    using Point = ContactPoint<typename Numbers::Work>;
    ContactPassView<Numbers> pass;
    CellLists cells;

    /// On a GPU the kernel waits for gathers from memory; only rare branches spill registers.
    static constexpr int blocksPerProcessor = sizeof(Work) == 4 ? 2 : 1;

    /// Contactors of one block: those that stay over the face they are tracked on, which are most
    /// of them, in as many lanes at a time as the team has; the others one by one.
    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index number) const
    {
        using T = typename Team::template Number<Work>;
        if (!pass.clock->running) return;
        const Index first = number * contactBlock, left = pass.contactorCount - first;
        const Index size = left < contactBlock ? left : contactBlock;
        const BlockForce total{pass.force + std::size_t(number) * BlockForce::values,
                               pass.contactorForce, Team::oneThread};
        team.forEach(BlockForce::values, [=](Index k) { total.sums[k] = 0; });
        if (total.each)
            team.forEach(3 * size, [=](Index k) { total.each[3 * std::size_t(first) + k] = 0; });
        team.barrier();
        // As a function of its own it would have the arguments by address: every thread of a GPU
        // copies them to local memory, and no pointer read there is known to be a global one.
        const auto each = [&](Index e) __attribute__((always_inline))
        {
            applyForcesOfBatch<T>(first + e, total);
        };
        team.template forEachBatch<Work>(size, each);
    }

private:
    struct Partner {
        Work stiffness;
        Work mass; ///< m*; 0 without damping
        Work thickness;
    };

    /// Contactors first ... first + lanes of T - 1, as far as they exist.
    template <class T>
    FPM_KERNEL void applyForcesOfBatch(Index first, const BlockForce& total) const
    {
        const SteadyContactors<Numbers, T> steady(pass, first);
        for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
            const Index i = first + lane;
            if (i >= pass.contactorCount) continue;
            const Index face = pass.face[i];
            if (steady.holds(lane))
                applyForces(i, steady.at(lane, face), total);
            else if (face >= 0)
                applyForces(i, FaceTracker<Numbers>{pass, cells}.follow(i), total);
            else if (face == noFace)
                open(i, Work(1), Work(0), Work(-1));
        }
    }
    /// Penalty spring, friction and damping at the contact point of this step.
    FPM_KERNEL void applyForces(Index i, Point at, const BlockForce& total) const
    {
        pass.face[i] = at.face[0];
        pass.xi[i] = at.xi[0];
        pass.eta[i] = at.eta[0];
        const Partner partner = partnerOf(i, at);
        const Work stiffness = partner.stiffness;
        const Work gapChange =
            pass.law.asksGapChange(i, at.gap) ? Slip<Numbers>{pass, i}.approach(at) : Work(0);
        if (at.beyond || !(at.gap < pass.reach)) {
            if (at.beyond && at.gap < 0) {
                if (pass.law.springEnergy[i] > 0) atomicAdd64(pass.counts + countOverEdge, 1);
                release(i);
            }
            open(i, stiffness, gapChange, at.beyond ? Work(-1) : at.gap);
            return;
        }
        if (-at.gap > partner.thickness) {
            release(i);
            atomicAdd64(pass.counts + countReleased, 1);
            open(i, stiffness, gapChange, at.gap);
            return;
        }
        const Work gap = relievedGap(pass, i, at.gap, stiffness);
        Work normalForce = 0;
        Vec3<Work> along{0, 0, 0}, held{0, 0, 0};
        if (gap < 0) {
            normalForce =
                pass.law.normalForce(i, stiffness, gap, partner.mass, gapChange, pass.clock->step);
            if constexpr (friction) along = tangential(i, at, stiffness, normalForce, held);
            pass.law.springEnergy[i] = pass.law.energy(stiffness, gap, held);
            if (pass.heldStiffness) pass.heldStiffness[i] = stiffness;
        } else
            open(i, stiffness, gapChange, gap);
        distribute(i, at, gap < 0, normalForce, along, stiffness, total);
    }

    /// Stiffness, mass and thickness of the target at a contactor. Where several faces bear it,
    /// they all count: the mean stiffness by their weights, since each bears its share with a
    /// spring of its own, the least mass, and the largest thickness. A closed spring keeps the
    /// stiffness with which it closed: then its force has a potential also where the contactor
    /// slides onto faces of another stiffness. `at`: receives the faces that share the projection
    /// point, where they matter.
    FPM_KERNEL Partner partnerOf(Index i, Point& at) const
    {
        const PassLaw<Work>& law = pass.law;
        const bool damps = law.damps(), held = pass.heldStiffness && law.springEnergy[i] > 0
                                               && pass.heldStiffness[i] > 0;
        Partner out{0, 0, Work(pass.faceThickness[at.face[0]])};
        if ((friction && at.gap < 0) || damps || (pass.heldStiffness && !held)
            || -at.gap > out.thickness)
            at.addSharers(pass, i);
        for (int k = 0; k < at.count; ++k) {
            const Index face = at.face[k];
            const Work thickness = Work(pass.faceThickness[face]);
            if (thickness > out.thickness) out.thickness = thickness;
            out.stiffness += at.weight[k] * law.stiffness(i, pass.faceStiffness[face]);
            if (!damps) continue;
            const Work mass = law.lesserMass(i, pass.faceMass[face]);
            if (k == 0 || (mass > 0 && !(out.mass > 0 && out.mass < mass))) out.mass = mass;
        }
        if (held) out.stiffness = pass.heldStiffness[i];
        return out;
    }
    FPM_KERNEL void release(Index i) const
    {
        pass.face[i] = releasedFace;
        if (pass.injected) pass.injected[pass.contactorCount + i] = 0; // see relievedGap
    }
    /// Separated: no force. A contactor that was separated before has no stored energy to account
    /// for.
    FPM_KERNEL void open(Index i, Work stiffness, Work gapChange, Work gap) const
    {
        if (!(pass.law.springEnergy[i] > 0)) return;
        pass.law.open(i, stiffness, gapChange, gap);
    }

    /// Tangential force on the contactor. The stored traction is convected with its face; where the
    /// contactor has moved to another face, it is rotated from the old face in its current position
    /// into the new one. `held`: receives the traction as stored.
    FPM_KERNEL Vec3<Work>
    tangential(Index i, const Point& at, Work stiffness, Work normalForce, Vec3<Work>& held) const
    {
        const PassLaw<Work>& law = pass.law;
        const Slip<Numbers> measure{pass, i};
        // Inside a ridge the faces push against each other: what is left of that is the bound.
        Vec3<Work> push = at.push[0];
        for (int k = 1; k < at.count; ++k) push += at.push[k];
        const Work pressing = at.count > 1 ? normalForce * dot(push, at.normal) : normalForce;
        held = law.storedForce(i);
        if (law.friction.paper) {
            const Vec3<Work> slip = inPlane(measure.displacement(at), at.normal);
            return held = law.slide(i, held, slip, stiffness, pressing, pass.clock->step);
        }
        const Index face = at.face[0];
        const FaceFrame<Work> frame(pass.corners(face, pass.contactor[i]));
        Vec3<Work> force{0, 0, 0};
        if (dot(held, held) > 0) {
            const Index last = law.frictionFace[i];
            if (last != face)
                held = componentsIn(
                    frame, vectorIn(FaceFrame<Work>(pass.corners(last, pass.contactor[i])), held));
            force = vectorIn(frame, held);
        }
        law.frictionFace[i] = face;
        const Work stored = dot(force, force);
        Vec3<Work> slip = measure.objective(at, force);
        force = intoPlane(force, at.normal);
        if (pass.mirrorsOf(i) != 0) {
            slip = measure.alongMirrors(slip, at.normal);
            force = measure.alongMirrors(force, at.normal);
        }
        // What the turns of several faces, or of a face and its image, cancel is not given back.
        if (at.count > 1 || pass.mirrorsOf(i) != 0)
            law.lose(i, stored - dot(force, force), stiffness);
        force = law.slide(i, force, slip, stiffness, pressing, pass.clock->step);
        law.store(i, componentsIn(frame, force));
        return held = force;
    }

    /// Adds the forces on the faces, each its share, and the force on the contactor, which is minus
    /// their exact sum. Every spring within reach enters the stability bound before it closes.
    FPM_KERNEL void distribute(Index i,
                               const Point& at,
                               bool closed,
                               Work normalForce,
                               const Vec3<Work>& along,
                               Work stiffness,
                               const BlockForce& total) const
    {
        const ContactSums& sums = pass.sums;
        const Work bound = Work(2) * pass.law.limitFactor * stiffness;
        const Index number = pass.contactNumber[pass.contactor[i]];
        std::int64_t own[3] = {0, 0, 0};
        for (int k = 0; k < at.count; ++k) {
            const Vec3<Work> share = at.weight[k] * along;
            const Work part = at.weight[k] * bound;
            if (closed)
                addToFace(i, at, k, multiplyAdd(normalForce, at.push[k], share), share, part, own);
            else
                addStiffnessToFace(at.face[k], at.xi[k], at.eta[k], part);
        }
        if (closed) {
            sums.addForce(number, own);
            total.add(i, own);
        }
        sums.addStiffness(number, double(bound));
    }
    /// Forces -N_I F on the four corners of a face, and those of the couple of the friction part;
    /// `own` takes the opposite of their sum. A face that is met by the contactor's image takes the
    /// images of the forces.
    FPM_KERNEL void addToFace(Index i,
                              const Point& at,
                              int face,
                              const Vec3<Work>& wholeForce,
                              const Vec3<Work>& wholeAlong,
                              Work bound,
                              std::int64_t (&own)[3]) const
    {
        const Index planes = at.planes[face];
        const Vec3<Work> force = pass.mirrored(planes, wholeForce),
                         along = pass.mirrored(planes, wholeAlong);
        Work n[4];
        shapeFunctions(at.xi[face], at.eta[face], n);
        CornerCouple<Work> couple;
        if (friction && !pass.law.friction.paper)
            couple =
                CornerCouple<Work>(at.corners(pass, i, face), at.xi[face], at.eta[face], along);
        const ContactSums& sums = pass.sums;
        std::int64_t taken[3] = {0, 0, 0};
        for (int k = 0; k < 4; ++k) {
            const Index corner = Index(pass.contactNumberAt(at.face[face], k));
            Vec3<Work> onCorner = -n[k] * force;
            if constexpr (friction) onCorner += couple.at(k);
            const std::int64_t part[3] = {sums.scale.force(double(onCorner.x)),
                                          sums.scale.force(double(onCorner.y)),
                                          sums.scale.force(double(onCorner.z))};
            for (int c = 0; c < 3; ++c) taken[c] -= part[c];
            sums.addForce(corner, part);
            sums.addStiffness(corner, double(n[k] * bound));
        }
        if (planes != 0) {
            taken[0] = sums.scale.force(double(wholeForce.x));
            taken[1] = sums.scale.force(double(wholeForce.y));
            taken[2] = sums.scale.force(double(wholeForce.z));
        }
        for (int c = 0; c < 3; ++c) own[c] += taken[c];
    }
    FPM_KERNEL void addStiffnessToFace(Index face, Work xi, Work eta, Work bound) const
    {
        Work n[4];
        shapeFunctions(xi, eta, n);
        for (int k = 0; k < 4; ++k)
            pass.sums.addStiffness(Index(pass.contactNumberAt(face, k)), double(n[k] * bound));
    }
};

} // namespace fpm
