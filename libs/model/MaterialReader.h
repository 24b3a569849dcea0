#pragma once

#include "model/Lineage.h"
#include "model/Model.h"

namespace fpm {

/// Hardening, rate dependence and heating of a part with `model elastoplastic`, into its hardening
/// rows and flow. Needs the part's Young's modulus.
void readFlow(const Lineage& lineage, Part& part);

/// The same entries in an elastic part's own dictionary: checked, not used.
void checkUnusedFlow(const Lineage& lineage, const Part& part);

/// The numbers of the part's material in its own dictionary, `<word> { ... }`, and heating where
/// the material may be heated; none for elastic and elastoplastic. Such dictionaries of other
/// materials are checked, not used.
void readLaw(const Lineage& lineage, Part& part);

/// `erosion` of a deformable part.
void readErosion(const Lineage& lineage, Part& part);

/// Throws for a key in a rigid part's own dictionary that means flow or deletion.
void refuseFlow(const Dictionary& own);

} // namespace fpm
