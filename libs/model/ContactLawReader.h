#pragma once

#include "dictionary/Dictionary.h"
#include "model/ContactLaw.h"
#include "model/RigidSurface.h"

namespace fpm {

/// Enforcement, friction, penalty and damping of an entry of `pairs`; `analytic`: its target is an
/// analytic surface.
ContactLaw readContactLaw(const Dictionary& pair, bool analytic);

/// An entry of `surfaces` that has a `type`.
RigidSurface readRigidSurface(const Dictionary& entry, const std::string& name);

} // namespace fpm
