#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "mesh/Mesh.h"
#include "model/RigidSurface.h"

namespace fpm {

/// How the contactor lies to an analytic surface before the run.
struct SurfaceFit {
    std::size_t facingNodes = 0; ///< nodes of sides that oppose the surface, outside it
    double smallestGap = 0, meanGap = 0;
    std::size_t overlaps = 0; ///< nodes inside the surface
    double deepest = 0;
    Index deepestNode = -1;
};
SurfaceFit measureSurfaceContact(const Mesh& mesh,
                                 const ContactSurfaces& surfaces,
                                 const RigidSurface& surface);

/// Prints the fit; overlaps, and a contactor that does not face the surface, are warnings.
void reportSurfaceContact(const Mesh& mesh,
                          const ContactSurfaces& surfaces,
                          const RigidSurface& surface,
                          Log& log);

/// Throws InputError at `place`, the pair, where a contactor begins deeper inside the surface than
/// a hundredth of a face's width, unless its `initialOverlap report` asks for the push.
void refuseSurfaceOverlap(const Mesh& mesh,
                          const ContactSurfaces& surfaces,
                          const RigidSurface& surface,
                          const Dictionary& place);

} // namespace fpm
