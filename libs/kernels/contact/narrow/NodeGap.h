#pragma once

#include "kernels/contact/ContactPassView.h"
#include "kernels/contact/law/RigidSurface.h"

#include <limits>

namespace fpm {

/// Gap of contactors without a target within reach.
inline constexpr double noGap = std::numeric_limits<double>::quiet_NaN();

/// Gap of each contactor to the face it is tracked on, negative inside; noGap beyond the reach.
/// Reads the results of ContactForce only.
template <class Numbers>
struct FaceGap {
    using Work = typename Numbers::Work;
    ContactPassView<Numbers> pass;
    double* out; ///< [contactor]

    FPM_KERNEL void operator()(Index i) const
    {
        out[i] = noGap;
        const Index face = pass.face[i];
        if (face < 0) return;
        const FaceCorners<Work> corners = pass.corners(face, pass.contactor[i]);
        const Work gap = gapAtClosest(corners, pass.xi[i], pass.eta[i]).gap;
        if (gap < pass.reach) out[i] = double(gap);
    }
};

/// Gap of each contactor to an analytic surface.
template <class Numbers>
struct SurfaceGap {
    SurfaceForce<Numbers> surface;
    double* out; ///< [contactor]

    FPM_KERNEL void operator()(Index i) const
    {
        const SurfaceForce<Numbers>& s = surface;
        const std::size_t node = std::size_t(s.contactor[i]);
        const Vec3<double> x{double(s.position[node]), double(s.position[s.nodeStride + node]),
                             double(s.position[2 * s.nodeStride + node])};
        const SurfacePoint at =
            s.shape.at(x - s.shape.displacement(s.amplitudeRows, s.clock->time));
        out[i] = at.opposite && at.gap < s.reach ? at.gap : noGap;
    }
};

} // namespace fpm
