#pragma once

#include "base/Log.h"
#include "model/InitialDepth.h"
#include "model/Model.h"

namespace fpm {

/// How the two sides of a pair lie to one another before the run.
struct ContactFit {
    double contactorArea = 0, targetArea = 0;
    std::size_t facingNodes = 0;         ///< contactor nodes whose faces oppose the target
    double smallestGap = 0, meanGap = 0; ///< of those that do not overlap
    InitialDepths depths;                ///< of those that lie inside
    double targetSize = 0;               ///< mean width of a target face
    std::size_t facesPointingAway = 0;   ///< target faces whose nearest nodes lie deep behind them
};
ContactFit measureContact(const Mesh& mesh, const ContactSurfaces& surfaces);

/// Prints the fit; overlaps and faces that point away are warnings. Where no contactor node faces
/// the target the pair is measured with its sides swapped: a second pass (`passes` 2) may see what
/// the first does not, as a small fine body on a large coarse one.
void reportContact(const Mesh& mesh,
                   const ContactSurfaces& surfaces,
                   const ContactFit& fit,
                   InitialOverlap overlap,
                   int passes,
                   Log& log);

/// Warns of the overlaps alone: how many, how deep, where, and what becomes of them.
void reportOverlaps(const Mesh& mesh,
                    const std::string& pair,
                    const ContactFit& fit,
                    InitialOverlap overlap,
                    Log& log);

/// Warns of target nodes that coincide without being the same: a seam of the mesh, where faces that
/// seem connected are not.
void reportSeams(const Mesh& mesh, const ContactSurfaces& surfaces, Log& log);

/// Warns where two pairs have both the same contactor nodes and the same target sides, so that the
/// penalty acts twice; says where they share only contactor nodes.
void reportSharing(const std::vector<ContactSurfaces>& pairs, Log& log);

} // namespace fpm
