#pragma once

#include "dictionary/Dictionary.h"
#include "mesh/Mesh.h"

namespace fpm {

/// Throws InputError when both sides of a pair are on rigid parts: then no mass limits the contact
/// force.
/// `rigid` says for each part of the mesh whether it is; `pair` lends its place.
void refuseRigidPair(const Mesh& mesh,
                     const ContactSurfaces& surfaces,
                     const std::vector<bool>& rigid,
                     const Dictionary& pair);

/// The same where the target is an analytic surface.
void refuseRigidContactor(const Mesh& mesh,
                          const ContactSurfaces& surfaces,
                          const std::vector<bool>& rigid,
                          const Dictionary& pair);

} // namespace fpm
