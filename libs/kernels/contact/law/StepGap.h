#pragma once

#include "kernels/contact/law/SurfaceShape.h"

namespace fpm {

/// Gap of a point to an analytic surface as a function of its displacement u relative to it, free
/// of the cancellation of coordinates: a point that stays on the surface has gap 0, not rounding.
struct StepGap {
    Vec3<double> normal; ///< at the start
    double rounding;     ///< of a gap that follows from coordinates
    bool inside;         ///< the point starts inside

    StepGap() = default;
    /// `x`: position less the displacement of the surface; `push`: a point inside is let out by so
    /// much at most.
    FPM_KERNEL StepGap(const SurfaceShape& surface, const Vec3<double>& x, double push)
        : shape_(&surface)
    {
        const SurfacePoint at = surface.at(x);
        normal = at.normal;
        const Vec3<double> r = x - surface.point;
        along_ = dot(r, surface.axis);
        across_ = surface.kind == SurfaceShape::cylinder ? r - along_ * surface.axis : r;
        distance_ = squareRoot(dot(across_, across_));
        rounding = 2e-15
                   * (squareRoot(dot(x, x)) + squareRoot(dot(surface.point, surface.point))
                      + (surface.kind == SurfaceShape::plane ? 0 : surface.radius));
        gap_ = at.gap > rounding || at.gap < -rounding ? at.gap : 0;
        inside = gap_ < 0;
        target_ = inside ? (gap_ < -push ? gap_ + push : 0) : 0;
    }

    /// How far the gap is below the one that is due: 0, or for a point that starts deep inside, one
    /// that is less deep.
    FPM_KERNEL double depthAfter(const Vec3<double>& u) const
    {
        if (shape_->kind == SurfaceShape::plane) return target_ - (gap_ + dot(normal, u));
        const Vec3<double> w = acrossOf(u), s = across_ + w;
        const double change =
            (2 * dot(across_, w) + dot(w, w)) / (squareRoot(dot(s, s)) + distance_);
        return target_ - (gap_ + (shape_->inside ? -change : change));
    }
    FPM_KERNEL Vec3<double> normalAfter(const Vec3<double>& u) const
    {
        if (shape_->kind == SurfaceShape::plane) return normal;
        const Vec3<double> s = across_ + acrossOf(u);
        return ((shape_->inside ? -1.0 : 1.0) / squareRoot(dot(s, s))) * s;
    }
    /// The displaced point has a unique closest point on the surface.
    FPM_KERNEL bool opposite(const Vec3<double>& u) const
    {
        if (shape_->kind == SurfaceShape::plane) return true;
        const Vec3<double> s = across_ + acrossOf(u);
        if (!(dot(s, s) > 0) || !(distance_ > 0)) return false;
        const double along = along_ + dot(u, shape_->axis);
        return !shape_->bounded || (along >= 0 && along <= shape_->length);
    }

private:
    FPM_KERNEL Vec3<double> acrossOf(const Vec3<double>& u) const
    {
        if (shape_->kind != SurfaceShape::cylinder) return u;
        return u - dot(u, shape_->axis) * shape_->axis;
    }

    const SurfaceShape* shape_;
    Vec3<double> across_; ///< from the axis or the centre
    double along_, distance_, gap_, target_;
};

} // namespace fpm
