#pragma once

#include "kernels/contact/broad/Search.h"
#include "kernels/contact/narrow/Overlap.h"
#include "kernels/contact/narrow/Slip.h"

namespace fpm {

/// Contact force of the contactors of a pass: narrow phase (tracking and closest-point projection),
/// gap g = (x_c - x_p) . n, penalty and friction force on both sides; eqs. (15) to (18) of the
/// paper. `friction`: passes without friction have a kernel of their own, which needs fewer
/// registers on a GPU (doc/performance.md).
template <class Numbers, bool friction>
struct ContactForce {
    using Work = typename Numbers::Work;
    using Faces = ProjectionFaces<Numbers>;
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
                applyForces(i, steady.tracked(lane, face), total);
            else if (face >= 0)
                applyForces(i, FaceTracker<Numbers>{pass, cells}.follow(i), total);
            else if (face == noFace)
                open(i, Work(1), Work(0), Work(-1));
        }
    }
    /// Penalty spring, friction and damping against the face found in this step.
    FPM_KERNEL void applyForces(Index i, const Tracked<Work>& now, const BlockForce& total) const
    {
        const Place<Work> origin{pass.face[i], pass.xi[i], pass.eta[i]};
        const Index face = now.face;
        pass.face[i] = face;
        pass.xi[i] = now.xi;
        pass.eta[i] = now.eta;
        const Projection<Work>& at = now.at;
        const Partner partner = partnerOf(i, now);
        const Work stiffness = partner.stiffness;
        const Work gapChange = pass.law.asksGapChange(i, at.gap) ? approach(i, face, at) : Work(0);
        if (now.beyond || !(at.gap < pass.reach)) {
            if (now.beyond && at.gap < 0) {
                if (pass.law.springEnergy[i] > 0) atomicAdd64(pass.counts + countOverEdge, 1);
                release(i);
            }
            open(i, stiffness, gapChange, now.beyond ? Work(-1) : at.gap);
            return;
        }
        if (-at.gap > partner.thickness) {
            release(i);
            atomicAdd64(pass.counts + countReleased, 1);
            open(i, stiffness, gapChange, at.gap);
            return;
        }
        const Work gap = relievedGap(pass, i, at.gap, stiffness);
        Vec3<Work> force{0, 0, 0};
        Vec3<Work> frictionPart{0, 0, 0};
        const bool hasFriction = friction && gap < 0;
        const Faces here = hasFriction ? Faces(pass, i, face, at) : Faces();
        if (gap < 0) {
            const Work normalForce =
                pass.law.normalForce(i, stiffness, gap, partner.mass, gapChange, pass.clock->step);
            Vec3<Work> held{0, 0, 0};
            force = normalForce * at.normal;
            if constexpr (friction) {
                const Vec3<Work> along =
                    tangential(i, now, here, origin, stiffness, normalForce, held);
                force += along;
                if (!pass.law.friction.paper) frictionPart = along;
            }
            pass.law.springEnergy[i] = pass.law.energy(stiffness, gap, held);
            if (pass.heldStiffness) pass.heldStiffness[i] = stiffness;
        } else
            open(i, stiffness, gapChange, gap);
        distribute(i, now, gap < 0, here, force, frictionPart, stiffness, total);
    }

    /// Stiffness, mass and thickness of the target at a contactor. Where several faces share its
    /// projection point, they all count: the mean stiffness, since each bears an equal share with a
    /// spring of its own, the least mass, and the largest thickness. A closed spring keeps the
    /// stiffness with which it closed: then its force has a potential also where the contactor
    /// slides onto faces of another stiffness.
    FPM_KERNEL Partner partnerOf(Index i, const Tracked<Work>& now) const
    {
        const PassLaw<Work>& law = pass.law;
        const Index face = now.face;
        const bool damps = law.damps(), held = pass.heldStiffness && law.springEnergy[i] > 0
                                               && pass.heldStiffness[i] > 0;
        Partner out{law.stiffness(i, pass.faceStiffness[face]),
                    damps ? law.lesserMass(i, pass.faceMass[face]) : Work(0),
                    Work(pass.faceThickness[face])};
        const bool asked = damps || (pass.heldStiffness && !held) || -now.at.gap > out.thickness;
        if (asked && isOnBorder(now.at.xi, now.at.eta)) addOthers(i, now, out);
        if (held) out.stiffness = pass.heldStiffness[i];
        return out;
    }
    FPM_KERNEL void addOthers(Index i, const Tracked<Work>& now, Partner& out) const
    {
        Work count = 1;
        FacesAroundProjection<Numbers>{pass, i}.forEach(
            {now.face, now.at.xi, now.at.eta}, [&](const Place<Work>& other, const Vec3<Work>&) {
                const std::size_t face = std::size_t(other.face);
                const Work thickness = Work(pass.faceThickness[face]);
                if (thickness > out.thickness) out.thickness = thickness;
                out.stiffness += pass.law.stiffness(i, pass.faceStiffness[face]);
                count += 1;
                if (!pass.law.damps()) return true;
                const Work mass = pass.law.lesserMass(i, pass.faceMass[face]);
                if (mass > 0 && !(out.mass > 0 && out.mass < mass)) out.mass = mass;
                return true;
            });
        out.stiffness = out.stiffness / count;
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

    /// Change of the gap in this step, Delta g_N.
    FPM_KERNEL Work approach(Index i, Index face, const Projection<Work>& at) const
    {
        return dot(Slip<Numbers>{pass, i}.relativeDisplacement(face, at), at.normal);
    }
    /// Tangential force on the contactor. The stored traction is convected with its face; where the
    /// contactor has moved to another face, it is rotated from the old face in its current position
    /// into the new one. `here`: the faces at the projection point; `held`: receives the traction
    /// as stored.
    FPM_KERNEL Vec3<Work> tangential(Index i,
                                     const Tracked<Work>& now,
                                     const Faces& here,
                                     const Place<Work>& origin,
                                     Work stiffness,
                                     Work normalForce,
                                     Vec3<Work>& held) const
    {
        const PassLaw<Work>& law = pass.law;
        const Slip<Numbers> measure{pass, i};
        const Index face = now.face;
        const Projection<Work>& at = now.at;
        held = law.storedForce(i);
        if (law.friction.paper) {
            const Vec3<Work> slip = inPlane(measure.relativeDisplacement(face, at), at.normal);
            return held = law.slide(i, held, slip, stiffness, normalForce, pass.clock->step);
        }
        const FaceCorners<Work> corners = pass.corners(face, pass.contactor[i]);
        const FaceFrame<Work> frame(corners);
        if (law.frictionFace[i] != face) {
            if (dot(held, held) > 0) {
                const FaceFrame<Work> old(pass.corners(law.frictionFace[i], pass.contactor[i]));
                held = frame.components(old.vector(held, at.normal), at.normal);
            }
            law.frictionFace[i] = face;
        }
        Vec3<Work> displacement =
            inPlane(measure.displacement(now, here, corners, origin), at.normal);
        const Directions<Work> across = measure.acrossMirrors(now, here);
        if (across.count > 0) {
            displacement = across.without(displacement);
            const Vec3<Work> force = frame.vector(held, at.normal), left = across.without(force);
            law.lose(i, dot(force, force) - dot(left, left), stiffness);
            held = frame.components(left, at.normal);
        }
        const Vec3<Work> slip = frame.components(displacement, at.normal);
        held = law.slide(i, held, slip, stiffness, normalForce, pass.clock->step);
        return frame.vector(held, at.normal);
    }

    /// Adds the forces on the target and the force on the contactor, which is minus their exact
    /// sum. `here`: the faces at the projection point, none without friction. `frictionPart`: the
    /// part of the force that acts with a couple. Every spring within reach enters the stability
    /// bound before it closes.
    FPM_KERNEL void distribute(Index i,
                               const Tracked<Work>& now,
                               bool closed,
                               const Faces& here,
                               const Vec3<Work>& force,
                               const Vec3<Work>& frictionPart,
                               Work stiffness,
                               const BlockForce& total) const
    {
        const ContactSums& sums = pass.sums;
        const Work bound = Work(2) * pass.law.limitFactor * stiffness;
        const Index number = pass.contactNumber[pass.contactor[i]];
        std::int64_t own[3] = {0, 0, 0};
        if (!closed)
            addStiffnessToFace(now.face, now.at.xi, now.at.eta, bound);
        else if (now.ridge)
            distributeToFaces(i, RidgeFaces<Numbers>(pass, i, now.face, now.at), force,
                              frictionPart, bound, own);
        else if (friction && here.count > 1)
            distributeToFaces(i, here, force, frictionPart, bound, own);
        else
            addToFace(i, now.face, now.at.xi, now.at.eta, force, frictionPart, bound, own);
        if (closed) {
            sums.addForce(number, own);
            total.add(i, own);
        }
        sums.addStiffness(number, double(bound));
    }
    /// Several faces take equal shares of the force and, on a border, of the couple.
    template <class AnyFaces>
    FPM_KERNEL void distributeToFaces(Index i,
                                      const AnyFaces& faces,
                                      const Vec3<Work>& force,
                                      const Vec3<Work>& frictionPart,
                                      Work bound,
                                      std::int64_t (&own)[3]) const
    {
        const Work part = Work(1) / Work(faces.count);
        for (int k = 0; k < faces.count; ++k)
            addToFace(i, faces.face[k], faces.xi[k], faces.eta[k], part * faces.image(k, force),
                      part * faces.image(k, frictionPart), part * bound, own);
    }
    /// Forces -N_I F on the four corners, and those of the couple; `own` takes the opposite of
    /// their sum.
    FPM_KERNEL void addToFace(Index i,
                              Index face,
                              Work xi,
                              Work eta,
                              const Vec3<Work>& force,
                              const Vec3<Work>& frictionPart,
                              Work bound,
                              std::int64_t (&own)[3]) const
    {
        Work n[4];
        shapeFunctions(xi, eta, n);
        CornerCouple<Work> couple;
        if constexpr (friction)
            couple =
                CornerCouple<Work>(pass.corners(face, pass.contactor[i]), xi, eta, frictionPart);
        const ContactSums& sums = pass.sums;
        for (int k = 0; k < 4; ++k) {
            const Index corner = Index(pass.contactNumberAt(face, k));
            Vec3<Work> onCorner = -n[k] * force;
            if constexpr (friction) onCorner += couple.at(k);
            const std::int64_t part[3] = {sums.scale.force(double(onCorner.x)),
                                          sums.scale.force(double(onCorner.y)),
                                          sums.scale.force(double(onCorner.z))};
            for (int c = 0; c < 3; ++c) own[c] -= part[c];
            sums.addForce(corner, part);
            sums.addStiffness(corner, double(n[k] * bound));
        }
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
