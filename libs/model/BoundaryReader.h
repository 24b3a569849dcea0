#pragma once

#include "base/Log.h"
#include "model/Model.h"
#include "model/NodeSelection.h"

namespace fpm {

/// `amplitude constant | table (...) | smooth (...)`; constant when the entry has none.
Amplitude readAmplitude(const Dictionary& entry);

/// Refuses a displacement `key` that is not 0 at the start: it would be an infinite velocity.
void refuseJump(const Dictionary& entry,
                const std::string& what,
                const std::string& key,
                double size);

/// constant/boundaryConditions, in file order. A component that is not listed is neither held nor
/// driven, nor loaded by a force; `value` is 0 there.
std::vector<BoundaryCondition> readBoundaryConditions(const Dictionary& dictionary,
                                                      const Mesh& mesh);

/// 0/initialConditions, in file order. Throws InputError when two velocities give a node different
/// ones; rotations add to them.
std::vector<InitialVelocity> readInitialVelocities(const Dictionary& dictionary, const Mesh& mesh);

} // namespace fpm
