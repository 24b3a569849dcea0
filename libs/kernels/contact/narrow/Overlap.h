#pragma once

#include "kernels/contact/narrow/Tracking.h"

namespace fpm {

/// Depth of each contactor inside its face, 0 outside: the initial overlap before the run.
template <class Numbers>
struct MeasureOverlap {
    ContactPassView<Numbers> pass;
    CellLists cells;
    float* depth; ///< [contactorCount]

    FPM_KERNEL void operator()(Index i) const
    {
        using Work = typename Numbers::Work;
        depth[i] = 0;
        if (pass.face[i] < 0) return;
        const ContactPoint<Work> at = FaceTracker<Numbers>{pass, cells}.follow(i);
        if (!at.beyond && at.gap < 0) depth[i] = notLess(-at.gap);
    }
};

/// Gap less the forgiven initial depth. That depth shrinks as the contactor moves out, and to
/// nothing over `fadeTime` where that is set; then the work it does on the spring and on the
/// motion, trapezoidal like the work on the nodes, is accounted for.
template <class Numbers>
FPM_KERNEL typename Numbers::Work relievedGap(const ContactPassView<Numbers>& pass,
                                              Index i,
                                              typename Numbers::Work gap,
                                              typename Numbers::Work stiffness)
{
    using Work = typename Numbers::Work;
    if (!(pass.overlap[i] > 0)) return gap;
    const Work whole = Work(pass.overlap[i]), depth = gap < 0 ? -gap : Work(0);
    const double before = pass.clock->time - pass.clock->step;
    const bool fades = pass.injected && before < pass.fadeTime; // depths found later do not fade
    const Work share =
        fades && pass.clock->time >= pass.fadeTime ? Work(0) : pass.forgivenShare(pass.clock->time);
    if (!(share > 0))
        pass.overlap[i] = 0;
    else if (depth < share * whole)
        pass.overlap[i] = notLess(depth / share);
    const Work relieved = gap + share * Work(pass.overlap[i]);
    if (!fades) return relieved;
    double& last = pass.injected[pass.contactorCount + i];
    const double forgiven = double(pass.forgivenShare(before) * whole);
    if (!(pass.clock->step > 0))
        last = double(gap);
    else if (last == 0) // found since the last step: its whole depth was forgiven then
        last = -forgiven;
    const double was = last + forgiven < 0 ? last + forgiven : 0,
                 is = relieved < 0 ? double(relieved) : 0, gapChange = double(gap) - last;
    pass.injected[i] += 0.5 * double(stiffness) * (is * is - was * was - (is + was) * gapChange);
    last = pass.overlap[i] > 0 ? double(gap) : 0;
    return relieved;
}

} // namespace fpm
