#pragma once

#include "dictionary/Dictionary.h"
#include "mesh/Mesh.h"

namespace fpm {

/// All exterior faces of all parts, as both sides of general contact.
ContactSurfaces allSurfaces(const Mesh& mesh, const std::string& name);

/// Parts whose boxes meet, each order, without those that are both rigid and those that meet in
/// `pairs`, which have a law of their own.
std::vector<ContactSurfaces> meetingBodies(const Mesh& mesh,
                                           const std::vector<bool>& rigid,
                                           const std::vector<ContactSurfaces>& pairs);

/// Parts that meet in a pair: contactor, target.
std::vector<std::array<Index, 2>> meetingsOf(const Mesh& mesh, const ContactSurfaces& surfaces);

/// refuseDeepStart of all bodies that general contact has to hold.
void refuseDeepBodies(const Mesh& mesh,
                      const std::vector<bool>& rigid,
                      const std::vector<ContactSurfaces>& pairs,
                      const Dictionary& contactDict);

} // namespace fpm
