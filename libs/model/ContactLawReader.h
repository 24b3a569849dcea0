#pragma once

#include "dictionary/Dictionary.h"
#include "model/ContactLaw.h"
#include "model/RigidSurface.h"

namespace fpm {

/// Friction, penalty and damping of an entry of `pairs`.
ContactLaw readContactLaw(const Dictionary& pair);

/// An entry of `surfaces` that has a `type`.
RigidSurface readRigidSurface(const Dictionary& entry, const std::string& name);

} // namespace fpm
