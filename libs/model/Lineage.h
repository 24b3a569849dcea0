#pragma once

#include "dictionary/Dictionary.h"

namespace fpm {

/// A part's own entries, then those of the part it is `like`, and so on.
using Lineage = std::vector<Dictionary>;

/// Throws InputError for an unknown part or a circle of `like`.
Lineage lineageOf(const Dictionary& parts, const std::string& name);

/// The first of the lineage that has `key`; the part itself when none has.
const Dictionary& holder(const Lineage& lineage, std::string_view key);

/// A required number of the lineage.
double number(const Lineage& lineage, std::string_view key, const Range& range);

} // namespace fpm
