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

    /// As printed in the paper: displacement increment of the contactor relative to the material of
    /// the tracked face, Delta u, in fixed axes.
    FPM_KERNEL Vec3<Work> displacement(const ContactPoint<Work>& at) const
    {
        return relativeDisplacement(at, 0);
    }
    /// Change of the gap in this step, Delta g_N.
    FPM_KERNEL Work approach(const ContactPoint<Work>& at) const
    {
        Work change = 0;
        for (int k = 0; k < at.count; ++k)
            change += dot(pass.mirroredBack(at.planes[k], relativeDisplacement(at, k)), at.push[k]);
        return change;
    }
    /// Objective slip increment: motion of the contactor in the frame that turns with the material
    /// of the target at its projection point, Delta u less the turn of the offset, as mean over the
    /// faces. It is as small as the motion, whichever faces the projection point lies on before and
    /// after, and zero for a common rigid motion. `traction`: as convected with the tracked face;
    /// receives the mean of it as convected with the points of several faces, or of a face and its
    /// image.
    FPM_KERNEL Vec3<Work> objective(const ContactPoint<Work>& at, Vec3<Work>& traction) const
    {
        Vec3<Work> sum{0, 0, 0}, before{0, 0, 0}, turned{0, 0, 0};
        const bool several = at.count > 1 || pass.mirrorsOf(i) != 0;
        for (int k = 0; k < at.count; ++k) {
            const FaceCorners<Work> corners = at.corners(pass, i, k),
                                    earlier = cornersBefore(at, k, corners);
            const PointFrame<Work> now(corners, at.xi[k], at.eta[k]),
                last(earlier, at.xi[k], at.eta[k]);
            // The turn acts on the short offset alone: in floats the difference of two offsets
            // would be rounding.
            const Vec3<Work> moved = relativeDisplacement(at, k),
                             offset = offsetOn(corners, at.xi[k], at.eta[k]) - moved,
                             slip = moved + (offset - vectorIn(now, componentsIn(last, offset)));
            sum = multiplyAdd(at.weight[k], pass.mirroredBack(at.planes[k], slip), sum);
            if (!several) continue;
            if (k == 0)
                before = vectorIn(FaceFrame<Work>(earlier),
                                  componentsIn(FaceFrame<Work>(corners), traction));
            const Vec3<Work> force =
                vectorIn(now, componentsIn(last, pass.mirrored(at.planes[k], before)));
            turned = multiplyAdd(at.weight[k], pass.mirroredBack(at.planes[k], force), turned);
        }
        if (several) traction = turned;
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
    /// Velocity of the contactor, or of its image that a face meets.
    FPM_KERNEL Vec3<Work> velocity(const ContactPoint<Work>& at, int k) const
    {
        return pass.mirrored(at.planes[k], pass.velocityOf(pass.contactor[i]));
    }
    FPM_KERNEL Vec3<Work> relativeDisplacement(const ContactPoint<Work>& at, int k) const
    {
        Work n[4];
        shapeFunctions(at.xi[k], at.eta[k], n);
        Vec3<Work> relative = velocity(at, k);
        for (int c = 0; c < 4; ++c)
            relative =
                relative - n[c] * pass.velocityOf(pass.faceNode[4 * std::size_t(at.face[k]) + c]);
        return Work(pass.clock->step) * relative;
    }
    /// Corners at the last time, relative to the contactor there.
    FPM_KERNEL FaceCorners<Work>
    cornersBefore(const ContactPoint<Work>& at, int k, FaceCorners<Work> corners) const
    {
        const Vec3<Work> own = velocity(at, k);
        for (int c = 0; c < 4; ++c) {
            const Index node = pass.faceNode[4 * std::size_t(at.face[k]) + std::size_t(c)];
            corners.corner[c] =
                corners.corner[c] - Work(pass.clock->step) * (pass.velocityOf(node) - own);
        }
        return corners;
    }
};

} // namespace fpm
