#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/ContactPassView.h"
#include "kernels/contact/law/KinematicContact.h"
#include "kernels/contact/law/RigidSurface.h"

namespace fpm {

/// Contact state of one contactor in contact. Reads the results of ContactForce only.
struct ContactStatus {
    double weight = 1;    ///< 1 for a whole contactor, halved for each symmetry plane on which it
                          ///< lies
    double depth = 0;     ///< of the contactor inside the target, forgiven initial depths included
    double thickness = 0; ///< of the target there; 0: unlimited
    double normal = 0;    ///< force of the normal penalty spring
    Vec3<double> friction{0, 0, 0}; ///< force on the contactor
    Vec3<double> slip{0, 0, 0};     ///< relative velocity in the tangential plane
};

/// Normal force from the stored energy of a contact spring and its tangential force.
template <class Work>
FPM_KERNEL double
normalForceOf(const PassLaw<Work>& law, Index i, double stiffness, const Vec3<double>& tangential)
{
    if (!(stiffness > 0)) return 0;
    double energy = law.springEnergy[i];
    if (law.friction.acts())
        energy -=
            dot(tangential, tangential) / (2 * double(law.friction.stiffnessRatio) * stiffness);
    return energy > 0 ? squareRoot(2 * stiffness * energy) : 0;
}

/// Weight of a contactor: half for each symmetry plane, one bit each.
FPM_KERNEL double weightOn(unsigned planes)
{
    double weight = 1;
    for (; planes > 0; planes &= planes - 1) weight *= 0.5;
    return weight;
}

template <class Work>
FPM_KERNEL Vec3<double> inDoubles(const Vec3<Work>& v)
{
    return {double(v.x), double(v.y), double(v.z)};
}

/// Contact state of a contactor against faces.
template <class Numbers>
struct FaceStatus {
    using Work = typename Numbers::Work;
    ContactPassView<Numbers> pass;

    FPM_KERNEL bool operator()(Index i, ContactStatus& out) const
    {
        const PassLaw<Work>& law = pass.law;
        const Index face = pass.face[i];
        if (face < 0 || !(law.springEnergy[i] > 0)) return false;
        const FaceCorners<Work> corners = pass.corners(face, pass.contactor[i]);
        const Projection<Work> at = gapAtClosest(corners, pass.xi[i], pass.eta[i]);
        out.weight = weightOn(unsigned(pass.mirrorsOf(i)));
        out.depth = at.gap < 0 ? double(-at.gap) : 0;
        out.thickness = double(pass.faceThickness[face]);
        Work stiffness = law.stiffness(i, pass.faceStiffness[face]);
        if (pass.heldStiffness && pass.heldStiffness[i] > 0) stiffness = pass.heldStiffness[i];
        if (law.friction.acts()) {
            const Vec3<Work> held = law.storedForce(i);
            out.friction =
                inDoubles(law.frictionFace ? vectorIn(FaceFrame<Work>(corners), held) : held);
            Work n[4];
            shapeFunctions(at.xi, at.eta, n);
            Vec3<Work> velocity = pass.velocityOf(pass.contactor[i]);
            for (int k = 0; k < 4; ++k)
                velocity =
                    velocity - n[k] * pass.velocityOf(pass.faceNode[4 * std::size_t(face) + k]);
            out.slip = inDoubles(inPlane(velocity, at.normal));
        }
        out.normal = normalForceOf(law, i, double(stiffness), out.friction);
        return true;
    }
};

/// Contact state of a contactor against an analytic surface.
template <class Numbers>
struct SurfaceStatus {
    using Work = typename Numbers::Work;
    SurfaceForce<Numbers> surface;
    const double* reading; ///< where it is met exactly, see SurfaceReading; null: springs

    FPM_KERNEL bool operator()(Index i, ContactStatus& out) const
    {
        const SurfaceForce<Numbers>& s = surface;
        const Vec3<double> force = reading ? read(i) : Vec3<double>{0, 0, 0};
        if (reading ? !(dot(force, force) > 0) : !(s.law.springEnergy[i] > 0)) return false;
        const std::size_t node = std::size_t(s.contactor[i]);
        const double now = s.clock->time, step = s.clock->step;
        const Vec3<double> moved = s.shape.displacement(s.amplitudeRows, now);
        const Vec3<double> x{double(s.position[node]), double(s.position[s.nodeStride + node]),
                             double(s.position[2 * s.nodeStride + node])};
        const SurfacePoint at = s.shape.at(x - moved);
        out.weight = weightOn(s.law.mirrors ? s.law.mirrors[i] : 0u);
        out.depth = at.gap < 0 ? -at.gap : 0;
        if (s.law.friction.acts()) {
            out.friction = reading ? inPlane(force, at.normal) : inDoubles(s.law.storedForce(i));
            Vec3<double> velocity{double(s.velocity[node]), double(s.velocity[s.nodeStride + node]),
                                  double(s.velocity[2 * s.nodeStride + node])};
            if (s.shape.moves && step > 0)
                velocity =
                    velocity
                    - (1 / step) * (moved - s.shape.displacement(s.amplitudeRows, now - step));
            out.slip = inPlane(velocity, at.normal);
        }
        out.normal =
            reading ? dot(force, at.normal)
                    : normalForceOf(s.law, i, double(s.law.stiffness(i, Work(0))), out.friction);
        return true;
    }

private:
    FPM_KERNEL Vec3<double> read(Index i) const
    {
        const std::size_t plane = std::size_t(surface.contactorCount);
        const double* of = reading + std::size_t(readForce) * plane + std::size_t(i);
        return {of[0], of[plane], of[2 * plane]};
    }
};

/// Order of the values a block of StatusSums writes.
enum StatusValue {
    statusCount,  ///< contactors in contact
    statusWeight, ///< sums over them, up to statusSums
    statusDepth,  ///< times weight
    statusNormal,
    statusFriction,
    statusSlip = statusFriction + 3, ///< times weight
    statusSpeed = statusSlip + 3,    ///< slip rate times weight
    statusSums,
    statusDeepest = statusSums, ///< largest depth, its contactor, thickness of the target there
    statusContactor,
    statusThickness,
    statusValues
};

/// Sums the contact status over the contactors of a pass and finds the deepest; one block =
/// contactBlock of them.
template <class Source>
struct StatusSums {
    Index count;
    Source source;
    double* blockValues; ///< [block][statusValues]

    static constexpr std::size_t scratch()
    {
        return (statusSums + 2) * contactBlock * sizeof(double) + blockSumScratch(statusSums);
    }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index number) const
    {
        double* values = reinterpret_cast<double*>(team.scratch());
        double* deepest = values + statusSums * contactBlock; // depth and thickness of each
        double* partial = deepest + 2 * contactBlock;
        const Index first = number * contactBlock,
                    size = count - first < contactBlock ? count - first : contactBlock;
        team.forEach(size, [&](Index i) {
            ContactStatus status;
            const bool closed = source(first + i, status);
            const double w = closed ? status.weight : 0;
            const double all[statusSums] = {closed ? 1.0 : 0.0,
                                            w,
                                            w * status.depth,
                                            status.normal,
                                            status.friction.x,
                                            status.friction.y,
                                            status.friction.z,
                                            w * status.slip.x,
                                            w * status.slip.y,
                                            w * status.slip.z,
                                            w * squareRoot(dot(status.slip, status.slip))};
            for (int k = 0; k < statusSums; ++k) values[k * contactBlock + i] = all[k];
            deepest[i] = status.depth;
            deepest[contactBlock + i] = status.thickness;
        });
        team.barrier();
        blockSums(team, statusSums, size, values, contactBlock, partial);
        team.barrier();
        double* out = blockValues + std::size_t(number) * statusValues;
        team.forEach(statusSums, [=](Index k) { out[k] = blockSumResult(partial, int(k)); });
        team.forEach(1, [=](Index) {
            Index at = 0;
            for (Index i = 1; i < size; ++i)
                if (deepest[i] > deepest[at]) at = i;
            out[statusDeepest] = deepest[at];
            out[statusContactor] = double(first + at);
            out[statusThickness] = deepest[contactBlock + at];
        });
    }
};

} // namespace fpm
