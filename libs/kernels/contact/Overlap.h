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
    if (!(pair.overlap[i] > 0)) return gap;
    const Work whole = Work(pair.overlap[i]), depth = gap < 0 ? -gap : Work(0);
    const double before = pair.clock->time - pair.clock->step;
    const bool fades = pair.injected && before < pair.fadeTime; // not where it is found later
    const Work share =
        fades && pair.clock->time >= pair.fadeTime ? Work(0) : pair.forgivenShare(pair.clock->time);
    if (!(share > 0))
        pair.overlap[i] = 0;
    else if (depth < share * whole)
        pair.overlap[i] = notLess(depth / share);
    const Work relieved = gap + share * Work(pair.overlap[i]);
    if (!fades) return relieved;
    double& last = pair.injected[pair.contactorCount + i];
    const double forgiven = double(pair.forgivenShare(before) * whole);
    if (!(pair.clock->step > 0))
        last = double(gap);
    else if (last == 0) // found since the last step: all of its depth was forgiven then
        last = -forgiven;
    const double was = last + forgiven < 0 ? last + forgiven : 0,
                 is = relieved < 0 ? double(relieved) : 0, way = double(gap) - last;
    pair.injected[i] += 0.5 * double(stiffness) * (is * is - was * was - (is + was) * way);
    last = pair.overlap[i] > 0 ? double(gap) : 0;
    return relieved;
}

} // namespace fpm
