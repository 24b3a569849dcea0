#pragma once

#include "case/Case.h"

#include <string>

namespace fpm {

/// Throws InputError at `overlay` of the entry where `folder` is none of the case, or cannot be
/// laid over copies of it.
void requireOverlay(const Dictionary& entry, const std::string& folder, const Case& theCase);

} // namespace fpm
