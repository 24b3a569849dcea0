#pragma once

#include "base/Log.h"
#include "mesh/Mesh.h"

namespace fpm {

/// How the two sides of a pair lie to one another before the run.
struct ContactFit {
    double contactorArea = 0, targetArea = 0;
    std::size_t facingNodes = 0;         ///< contactor nodes that look at the target
    double smallestGap = 0, meanGap = 0; ///< of those that do not overlap
    std::size_t overlaps = 0;            ///< contactor nodes inside the target
    double deepest = 0;                  ///< depth of the deepest of them
    Index deepestNode = -1;
    double targetSize = 0;             ///< mean width of a target face
    std::size_t facesPointingAway = 0; ///< target faces whose nearest nodes lie deep behind them
};
ContactFit measureContact(const Mesh& mesh, const ContactSurfaces& surfaces);

/// Prints the fit; overlaps and faces that point away are warnings.
void reportContact(const Mesh& mesh,
                   const ContactSurfaces& surfaces,
                   const ContactFit& fit,
                   Log& log);

/// Warns where two pairs have both the same contactor nodes and the same target sides, so that the
/// penalty acts twice; says where they share only contactor nodes.
void reportSharing(const std::vector<ContactSurfaces>& pairs, Log& log);

} // namespace fpm
