#pragma once

#include "kernels/contact/Tracking.h"

namespace fpm {

/// Depth of each contactor inside its face, 0 outside: what it overlaps before the run.
template <class Precision>
struct MeasureOverlap {
    PairView<Precision> pair;
    CellLists cells;
    typename Precision::Work* depth; ///< [contactorCount]

    FPM_KERNEL void operator()(Index i) const
    {
        using Work = typename Precision::Work;
        depth[i] = 0;
        if (pair.face[i] < 0) return;
        const Tracked<Work> now = FaceTracker<Precision>{pair, cells}.follow(i);
        if (!now.beyond && now.at.gap < 0) depth[i] = -now.at.gap;
    }
};

/// The gap without the depth at which the contactor was found. That shrinks as the contactor comes
/// out, and to nothing over `fadeTime` where there is one; the work it does in fading is booked.
template <class Precision>
FPM_KERNEL typename Precision::Work relievedGap(const PairView<Precision>& pair,
                                                Index i,
                                                typename Precision::Work gap,
                                                typename Precision::Work stiffness)
{
    using Work = typename Precision::Work;
    Work forgiven = pair.overlap[i];
    if (!(forgiven > 0)) return gap;
    const Work depth = gap < 0 ? -gap : Work(0);
    if (depth < forgiven) pair.overlap[i] = forgiven = depth;
    if (!pair.injected) return gap + forgiven;
    const double left = pair.fadeTime - pair.clock->time, before = left + pair.clock->step;
    if (!(before > 0)) return gap + forgiven; // found after the fade
    const Work less = left > 0 ? forgiven * Work(left / before) : Work(0);
    const Work was = gap + forgiven, is = gap + less;
    pair.injected[i] += double(Work(0.5) * stiffness * (is * is - (was < 0 ? was * was : Work(0))));
    pair.overlap[i] = less;
    return is;
}

} // namespace fpm
