#pragma once

#include "kernels/contact/law/Friction.h"
#include "kernels/contact/narrow/ContactPoint.h"

namespace fpm {

/// Slip increment of a contactor along the target in one step, for friction.
template <class Numbers>
struct Slip {
    using Work = typename Numbers::Work;
    const ContactPassView<Numbers>& pass;
    Index i;

    /// Displacement increment of the contactor relative to the material of a face, Delta u.
    FPM_KERNEL Vec3<Work> relativeDisplacement(Index face, Work xi, Work eta) const
    {
        Work n[4];
        shapeFunctions(xi, eta, n);
        Vec3<Work> relative = pass.velocityOf(pass.contactor[i]);
        for (int k = 0; k < 4; ++k)
            relative = relative - n[k] * pass.velocityOf(pass.faceNode[4 * std::size_t(face) + k]);
        return Work(pass.clock->step) * relative;
    }
    /// As printed in the paper, relative to the tracked face and in fixed axes.
    FPM_KERNEL Vec3<Work> displacement(const ContactPoint<Work>& at) const
    {
        return relativeDisplacement(at.face[0], at.xi[0], at.eta[0]);
    }
    /// Change of the gap in this step, Delta g_N.
    FPM_KERNEL Work approach(const ContactPoint<Work>& at) const
    {
        Work change = 0;
        for (int k = 0; k < at.count; ++k)
            change += dot(relativeDisplacement(at.face[k], at.xi[k], at.eta[k]), at.push[k]);
        return change;
    }
    /// Objective slip increment: motion of the contactor in the frame that turns with the material
    /// of the target at its projection point, Delta u less the turn of the offset, as mean over the
    /// faces. It is as small as the motion, whichever faces the projection point lies on before and
    /// after, and zero for a common rigid motion.
    FPM_KERNEL Vec3<Work> objective(const ContactPoint<Work>& at) const
    {
        Vec3<Work> sum{0, 0, 0};
        for (int k = 0; k < at.count; ++k)
            sum = multiplyAdd(at.weight[k], onFace(at.face[k], at.xi[k], at.eta[k]), sum);
        return inPlane(sum, at.normal);
    }

    /// Part of a force that remains on the symmetry planes of the model on which the contactor
    /// lies; that normal to them cancels with its mirror image.
    FPM_KERNEL Vec3<Work> alongMirrors(Vec3<Work> force, const Vec3<Work>& normal) const
    {
        Vec3<Work> first{0, 0, 0};
        bool any = false;
        for (Index k = 0, mirrors = pass.mirrorsOf(i); mirrors >> k; ++k) {
            if (!(mirrors >> k & 1)) continue;
            const Vec3<Work> plane = pass.mirror(k);
            Vec3<Work> direction = inPlane(plane, normal);
            if (any) direction = direction - dot(direction, first) * first;
            const Work square = dot(direction, direction);
            if (!(square > ContactTolerances<Work>::noDirection * dot(plane, plane))) continue;
            direction = (Work(1) / squareRoot(square)) * direction;
            force = force - dot(force, direction) * direction;
            first = direction;
            any = true;
        }
        return force;
    }

private:
    FPM_KERNEL Vec3<Work> onFace(Index face, Work xi, Work eta) const
    {
        const FaceCorners<Work> now = pass.corners(face, pass.contactor[i]);
        FaceCorners<Work> before = now;
        const Vec3<Work> own = pass.velocityOf(pass.contactor[i]);
        for (int k = 0; k < 4; ++k) {
            const Index node = pass.faceNode[4 * std::size_t(face) + std::size_t(k)];
            before.corner[k] =
                before.corner[k] - Work(pass.clock->step) * (pass.velocityOf(node) - own);
        }
        // The turn acts on the short offset alone: in floats the difference of two offsets would be
        // rounding.
        const Vec3<Work> moved = relativeDisplacement(face, xi, eta),
                         last = offsetOn(now, xi, eta) - moved;
        const Vec3<Work> turned = PointFrame<Work>(now, xi, eta)
                                      .vector(PointFrame<Work>(before, xi, eta).components(last));
        return moved + (last - turned);
    }
};

} // namespace fpm
