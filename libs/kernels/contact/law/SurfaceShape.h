#pragma once

#include "kernels/particle/Amplitude.h"
#include "parallel/Vec3.h"

namespace fpm {

/// Signed distance of a point to an analytic surface, negative inside the body, and outward normal
/// there.
struct SurfacePoint {
    double gap;
    Vec3<double> normal;
    bool opposite; ///< the point has a unique closest point on the surface
};

/// Plane, cylinder or sphere that translates without rotation.
struct SurfaceShape {
    enum Kind : std::int32_t { plane, cylinder, sphere };
    Kind kind;
    bool inside;  ///< the body lies outside the cylinder or sphere, which is a hole in it
    bool bounded; ///< the cylinder ends at both ends of its axis, without caps
    bool moves;
    Vec3<double> point; ///< of the plane; first end of the axis; centre
    Vec3<double> axis;  ///< outward normal of the plane; unit vector of the cylinder's axis
    double length, radius;
    Condition motion; ///< displacement or velocity, if it moves

    FPM_KERNEL Vec3<double> displacement(const double* amplitudeRows, double time) const
    {
        if (!moves) return {0, 0, 0};
        const double travel = travelAt(motion, amplitudeRows, time);
        return {travel * motion.value[0], travel * motion.value[1], travel * motion.value[2]};
    }

    /// `x`: position less the displacement of the surface.
    FPM_KERNEL SurfacePoint at(const Vec3<double>& x) const
    {
        Vec3<double> r = x - point;
        if (kind == plane) return {dot(r, axis), axis, true};
        bool opposite = true;
        if (kind == cylinder) {
            const double along = dot(r, axis);
            opposite = !bounded || (along >= 0 && along <= length);
            r = r - along * axis;
        }
        const double distance = squareRoot(dot(r, r));
        if (!(distance > 0)) return {0, axis, false}; // on the axis no normal is unique
        const double sign = inside ? -1 : 1;
        return {sign * (distance - radius), (sign / distance) * r, opposite};
    }
};

} // namespace fpm
