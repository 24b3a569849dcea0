#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/Overlap.h"

namespace fpm {

/// Tracks the face of one contactor, measures the gap and adds the penalty and friction forces to
/// both sides (eqs. 15-18 of the paper; gap g = (x_c - x_p) . n).
template <class Precision>
struct ContactForce {
    using Work = typename Precision::Work;
    PairView<Precision> pair;
    CellLists cells;

    FPM_KERNEL void operator()(Index i) const
    {
        if (!pair.clock->running) return;
        const Index before = pair.face[i];
        if (before < 0) {
            if (before == noFace) open(i, Work(1));
            return;
        }
        const Origin origin{before, pair.xi[i], pair.eta[i]};
        Tracked<Work> now = FaceTracker<Precision>{pair, cells}.follow(i);
        const Index face = now.face;
        pair.face[i] = face;
        pair.xi[i] = now.xi;
        pair.eta[i] = now.eta;
        Projection<Work>& at = now.at;
        const Work stiffness = stiffnessOf(i, face);
        const Work way = pair.law.damps() ? approach(i, face, at) : Work(0);
        if (now.beyond || !(at.gap < pair.reach)) {
            if (now.beyond && at.gap < 0) {
                if (pair.law.spring[i] > 0) atomicAdd64(pair.counts + countOverEdge, 1);
                pair.face[i] = releasedFace;
            }
            open(i, stiffness, way);
            return;
        }
        if (-at.gap > pair.faceThickness[face]) {
            pair.face[i] = releasedFace;
            atomicAdd64(pair.counts + countReleased, 1);
            open(i, stiffness, way);
            return;
        }
        at.gap = relievedGap(pair, i, at.gap, stiffness);
        Vec3<Work> force{0, 0, 0};
        if (at.gap < 0) {
            const Work pressed =
                pair.law.normalForce(i, stiffness, at.gap, massOf(i, face), way, pair.clock->step);
            Vec3<Work> held{0, 0, 0};
            force = pressed * at.normal;
            if (pair.law.friction.acts())
                force += tangential(i, face, origin, at, stiffness, pressed, held);
            pair.law.spring[i] = pair.law.energy(stiffness, at.gap, held);
            if (pair.heldStiffness) pair.heldStiffness[i] = stiffness;
        } else
            open(i, stiffness, way);
        share(i, face, at, force, stiffness);
    }

private:
    /// Where the contactor was at the last step: face and place on it.
    struct Origin {
        Index face;
        Work xi, eta;
    };

    /// k_n between contactor and face. A closed spring keeps the one it closed with, so that its
    /// force has a potential also where the contactor comes to faces of other stiffness.
    FPM_KERNEL Work stiffnessOf(Index i, Index face) const
    {
        if (pair.heldStiffness && pair.law.spring[i] > 0 && pair.heldStiffness[i] > 0)
            return pair.heldStiffness[i];
        return pair.law.stiffness(i, pair.faceStiffness[face]);
    }
    /// No touch: no force.
    FPM_KERNEL void open(Index i, Work stiffness, Work way = 0) const
    {
        for (int c = 0; c < 3; ++c) pair.force[c * pair.contactorCount + i] = 0;
        pair.law.open(i, stiffness, way);
    }

    /// Movement of the contactor against the face in this step.
    FPM_KERNEL Vec3<Work> relativeWay(Index i, Index face, const Projection<Work>& at) const
    {
        Work n[4];
        shapeFunctions(at.xi, at.eta, n);
        Vec3<Work> relative = pair.velocityOf(pair.contactor[i]);
        for (int k = 0; k < 4; ++k)
            relative = relative - n[k] * pair.velocityOf(pair.faceNode[4 * std::size_t(face) + k]);
        return Work(pair.clock->step) * relative;
    }
    /// Change of the gap in this step.
    FPM_KERNEL Work approach(Index i, Index face, const Projection<Work>& at) const
    {
        return dot(relativeWay(i, face, at), at.normal);
    }
    FPM_KERNEL Work massOf(Index i, Index face) const
    {
        return pair.law.damps() ? pair.law.lesserMass(i, pair.faceMass[face]) : Work(0);
    }

    /// Friction on the contactor. The stored force turns with the face it belongs to; where the
    /// contactor has come from another one, that face as it lies now hands it over. `held`: the
    /// force as it is stored.
    FPM_KERNEL Vec3<Work> tangential(Index i,
                                     Index face,
                                     const Origin& origin,
                                     const Projection<Work>& at,
                                     Work stiffness,
                                     Work pressed,
                                     Vec3<Work>& held) const
    {
        const PairLaw<Work>& law = pair.law;
        held = law.storedVector(i);
        if (law.friction.paper) {
            const Vec3<Work> slip = inPlane(relativeWay(i, face, at), at.normal);
            return held = law.slide(i, held, slip, stiffness, pressed, pair.clock->step);
        }
        const FaceCorners<Work> corners = pair.corners(face, pair.contactor[i]);
        const FaceFrame<Work> frame(corners);
        if (law.storedFace[i] != face) {
            if (dot(held, held) > 0) {
                const FaceFrame<Work> old(pair.corners(law.storedFace[i], pair.contactor[i]));
                held = frame.components(old.vector(held, at.normal), at.normal);
            }
            law.storedFace[i] = face;
        }
        const Vec3<Work> way = origin.face == face
                                   ? slipOnFace(corners, origin.xi, origin.eta, at.xi, at.eta)
                                   : wayAcross(i, face, origin, at);
        const Vec3<Work> slip = frame.components(inPlane(way, at.normal), at.normal);
        held = law.slide(i, held, slip, stiffness, pressed, pair.clock->step);
        return frame.vector(held, at.normal);
    }

    /// Way over the target in a step in which the contactor came to another face: that of the foot,
    /// as on one face. Inside a ridge the foot leaps to the other side where that becomes the
    /// nearer one; nobody went there, and the nodes' own way counts.
    FPM_KERNEL Vec3<Work>
    wayAcross(Index i, Index face, const Origin& origin, const Projection<Work>& at) const
    {
        const Vec3<Work> foot = slipBetweenFaces(pair.corners(origin.face, pair.contactor[i]),
                                                 origin.xi, origin.eta, at.offset),
                         node = relativeWay(i, face, at);
        const bool leapt = dot(foot, foot) > Work(4) * dot(node, node);
        return leapt ? node : foot;
    }

    /// Shares of the four corners, -N_I F, and the contactor's force as minus their exact sum. The
    /// stiffness of every spring within reach enters the bound of the step before it closes.
    FPM_KERNEL void share(Index i,
                          Index face,
                          const Projection<Work>& at,
                          const Vec3<Work>& force,
                          Work stiffness) const
    {
        Work n[4];
        shapeFunctions(at.xi, at.eta, n);
        const bool closed = at.gap < 0;
        const Work bound = Work(2) * pair.law.limitFactor * stiffness;
        std::int64_t own[3] = {0, 0, 0};
        for (int k = 0; k < 4; ++k) {
            std::int64_t* to =
                pair.sum + 4 * std::size_t(pair.faceNumber[4 * std::size_t(face) + k]);
            if (closed) {
                const double part[3] = {double(-n[k] * force.x), double(-n[k] * force.y),
                                        double(-n[k] * force.z)};
                for (int c = 0; c < 3; ++c) {
                    const std::int64_t fixed = pair.scale.force(part[c]);
                    own[c] -= fixed;
                    atomicAdd64(to + c, fixed);
                }
            }
            atomicAdd64(to + 3, pair.scale.spring(double(n[k] * bound)));
        }
        std::int64_t* to = pair.sum + 4 * std::size_t(pair.contactorNumber[i]);
        if (closed)
            for (int c = 0; c < 3; ++c) {
                atomicAdd64(to + c, own[c]);
                pair.force[c * pair.contactorCount + i] = pair.scale.toForce(own[c]);
            }
        atomicAdd64(to + 3, pair.scale.spring(double(bound)));
    }
};

/// Largest stiffness over mass of a block of contact nodes: omega_c^2 of the springs (Gershgorin).
template <class Motion>
struct ContactLimit {
    Index count;
    const std::int64_t* sum;
    const Motion* inverseMass; ///< of each contact node; 0 where its motion is imposed
    ForceScale scale;
    double* blockLimit;
    const StepClock* clock;

    static constexpr Index block = 256;
    static constexpr std::size_t scratch() { return block * sizeof(double) + blockSumScratch(1); }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index number) const
    {
        if (!clock->running) return;
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + block;
        const Index first = number * block, size = count - first < block ? count - first : block;
        team.forEach(size, [&](Index i) {
            const std::size_t node = std::size_t(first + i);
            values[i] = -scale.toStiffness(sum[4 * node + 3]) * double(inverseMass[node]);
        });
        team.barrier();
        blockMinimum(team, size, values, partial);
        team.barrier();
        double* out = blockLimit + number;
        team.forEach(1, [=](Index) { *out = -blockMinimumResult(partial); });
        team.barrier();
    }
};

} // namespace fpm
