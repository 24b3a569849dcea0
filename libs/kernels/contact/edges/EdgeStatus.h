#pragma once

#include "kernels/contact/distribute/ContactStatus.h"
#include "kernels/contact/edges/EdgePassView.h"

namespace fpm {

/// Contact state of a pair of segments. Reads the results of EdgeForce only.
template <class Numbers>
struct EdgeStatus {
    using Work = typename Numbers::Work;
    EdgePassView<Numbers> edges;

    FPM_KERNEL bool operator()(Index i, ContactStatus& out) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        const PassLaw<Work>& law = pass.law;
        if (edges.state[i] != edgesClosed || !(law.springEnergy[i] > 0)) return false;
        const EdgePair<Numbers> pair(edges, i);
        out.depth = pair.at.gap < 0 ? double(-pair.at.gap) : 0;
        out.thickness = 2 * double(edges.deepest(pair.first, pair.second));
        Work stiffness = law.stiffness(i, pass.faceStiffness[pair.second]);
        if (pass.heldStiffness && pass.heldStiffness[i] > 0) stiffness = pass.heldStiffness[i];
        if (law.friction.acts()) {
            out.friction = inDoubles(pair.frame().vector(law.storedForce(i)));
            const Vec3<Work> velocity =
                edges.velocityAt(pair.first, pair.at.s) - edges.velocityAt(pair.second, pair.at.t);
            out.slip = inDoubles(inPlane(velocity, pair.at.normal));
        }
        out.normal = normalForceOf(law, i, double(stiffness), out.friction);
        return true;
    }
};

} // namespace fpm
