#pragma once

#include "kernels/contact/Tracking.h"

namespace fpm {

/// Depth of each contactor inside its face, 0 outside: what it overlaps before the run.
template <class Precision>
struct MeasureOverlap {
    PairView<Precision> pair;
    CellLists cells;
    float* depth; ///< [contactorCount]

    FPM_KERNEL void operator()(Index i) const
    {
        using Work = typename Precision::Work;
        depth[i] = 0;
        if (pair.face[i] < 0) return;
        const Tracked<Work> now = FaceTracker<Precision>{pair, cells}.follow(i);
        if (!now.beyond && now.at.gap < 0) depth[i] = notLess(-now.at.gap);
    }
};

/// The gap without the depth at which the contactor was found. That shrinks as the contactor comes
/// out, and to nothing over `fadeTime` where there is one; then what it puts into the spring and
/// into the motion, trapezoidal as the nodes' work, is booked.
template <class Precision>
FPM_KERNEL typename Precision::Work relievedGap(const PairView<Precision>& pair,
                                                Index i,
                                                typename Precision::Work gap,
                                                typename Precision::Work stiffness)
{
    using Work = typename Precision::Work;
    Work forgiven = Work(pair.overlap[i]);
    if (!(forgiven > 0)) return gap;
    const Work before = forgiven, depth = gap < 0 ? -gap : Work(0);
    if (depth < forgiven) forgiven = depth;
    const double left = pair.fadeTime - pair.clock->time, since = left + pair.clock->step;
    const bool fades = pair.injected && since > 0; // not where it is found after the fade
    if (fades) forgiven = left > 0 ? forgiven * Work(left / since) : Work(0);
    pair.overlap[i] = notLess(forgiven);
    forgiven = Work(pair.overlap[i]); // as the next step will know it
    if (!fades) return gap + forgiven;
    double& last = pair.injected[pair.contactorCount + i];
    if (!(pair.clock->step > 0)) last = double(gap);
    const double was = last + double(before) < 0 ? last + double(before) : 0,
                 is = double(gap + forgiven), way = double(gap) - last;
    pair.injected[i] += 0.5 * double(stiffness) * (is * is - was * was - (is + was) * way);
    last = double(gap);
    return gap + forgiven;
}

} // namespace fpm
