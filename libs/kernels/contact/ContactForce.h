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
        Tracked<Work> now = FaceTracker<Precision>{pair, cells}.follow(i);
        const Index face = now.face;
        pair.face[i] = face;
        pair.xi[i] = now.xi;
        pair.eta[i] = now.eta;
        Projection<Work>& at = now.at;
        const Work stiffness = pair.faceStiffness[face];
        if (now.beyond || !(at.gap < pair.reach)) {
            if (now.beyond && at.gap < 0) {
                if (pair.spring[i] > 0) atomicAdd64(pair.counts + countOverEdge, 1);
                pair.face[i] = releasedFace;
            }
            open(i, stiffness);
            return;
        }
        if (-at.gap > pair.faceThickness[face]) {
            pair.face[i] = releasedFace;
            atomicAdd64(pair.counts + countReleased, 1);
            open(i, stiffness);
            return;
        }
        at.gap = relievedGap(pair, i, at.gap, stiffness);
        Vec3<Work> force{0, 0, 0};
        if (at.gap < 0) {
            force = (-stiffness * at.gap) * at.normal;
            Work energy = Work(0.5) * stiffness * at.gap * at.gap;
            if (pair.frictionCoefficient > 0) {
                const Vec3<Work> slip = tangential(i, face, at, stiffness);
                energy += dot(slip, slip) / (Work(2) * pair.tangentialRatio * stiffness);
                force += slip;
            }
            pair.spring[i] = double(energy);
        } else
            open(i, stiffness);
        share(i, face, at, force, stiffness);
    }

private:
    /// No touch: no force. What the tangential spring still held is lost to friction.
    FPM_KERNEL void open(Index i, Work stiffness) const
    {
        const Index count = pair.contactorCount;
        for (int c = 0; c < 3; ++c) pair.force[c * count + i] = 0;
        pair.spring[i] = 0;
        if (!(pair.frictionCoefficient > 0)) return;
        Work* stored = pair.friction;
        const Vec3<Work> held{stored[i], stored[count + i], stored[2 * count + i]};
        pair.dissipated[i] +=
            double(Work(0.5) * dot(held, held) / (pair.tangentialRatio * stiffness));
        for (int c = 0; c < 3; ++c) stored[c * count + i] = 0;
    }

    /// Elastic-slip Coulomb force (eqs. 17-18): the stored force, turned into the tangent plane
    /// with its length kept, minus k_t times the slip of this step, capped at mu times the normal
    /// force.
    FPM_KERNEL Vec3<Work>
    tangential(Index i, Index face, const Projection<Work>& at, Work stiffness) const
    {
        const Index count = pair.contactorCount;
        Work* stored = pair.friction;
        Vec3<Work> trial{stored[i], stored[count + i], stored[2 * count + i]};
        const Work length = squareRoot(dot(trial, trial));
        trial = trial - dot(trial, at.normal) * at.normal;
        const Work flat = squareRoot(dot(trial, trial));
        if (flat > 0) trial = (length / flat) * trial;
        const Vec3<Work> old = trial;

        Work n[4];
        shapeFunctions(at.xi, at.eta, n);
        Vec3<Work> relative = pair.velocityOf(pair.contactor[i]);
        for (int k = 0; k < 4; ++k)
            relative = relative - n[k] * pair.velocityOf(pair.faceNode[4 * std::size_t(face) + k]);
        relative = relative - dot(relative, at.normal) * at.normal;
        const Work tangentialStiffness = pair.tangentialRatio * stiffness;
        trial = trial - (tangentialStiffness * Work(pair.clock->step)) * relative;

        const Work most = pair.frictionCoefficient * (-stiffness * at.gap);
        const Work size = squareRoot(dot(trial, trial));
        if (size > most) {
            const Vec3<Work> capped = (most / size) * trial;
            // Mean force over the step times the slip the spring does not take: with it the nodes'
            // work, trapezoidal as theirs, is stored plus dissipated.
            pair.dissipated[i] +=
                double(Work(0.5) * dot(old + capped, trial - capped) / tangentialStiffness);
            trial = capped;
        }
        stored[i] = trial.x;
        stored[count + i] = trial.y;
        stored[2 * count + i] = trial.z;
        return trial;
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
            atomicAdd64(to + 3, pair.scale.spring(double(Work(2) * n[k] * stiffness)));
        }
        std::int64_t* to = pair.sum + 4 * std::size_t(pair.contactorNumber[i]);
        if (closed)
            for (int c = 0; c < 3; ++c) {
                atomicAdd64(to + c, own[c]);
                pair.force[c * pair.contactorCount + i] = pair.scale.toForce(own[c]);
            }
        atomicAdd64(to + 3, pair.scale.spring(double(Work(2) * stiffness)));
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
