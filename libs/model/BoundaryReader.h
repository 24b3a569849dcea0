#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "model/Model.h"

namespace fpm {

/// Nodes of a part, ascending.
std::vector<Index> nodesOfPart(const Mesh& mesh, Index part);

/// Nodes of the part an entry names by `part`, ascending. Throws InputError for an unknown one.
std::vector<Index> nodesOfNamedPart(const Dictionary& entry, const Mesh& mesh);

/// Nodes an entry means by `set` (a node set, or the nodes of a side set) or by `part`, ascending.
std::vector<Index> selectNodes(const Dictionary& entry, const Mesh& mesh);

/// `amplitude constant | table (...) | smooth (...)`; constant when the entry has none.
Amplitude readAmplitude(const Dictionary& entry);

/// Refuses a displacement `key` that is not 0 at the start: it would be an infinite velocity.
void refuseJump(const Dictionary& entry, const std::string& key, double start);

/// constant/boundaryConditions, in file order. A component that is not listed is neither held nor
/// driven, nor loaded by a force; `value` is 0 there.
std::vector<BoundaryCondition> readBoundaryConditions(const Dictionary& dictionary,
                                                      const Mesh& mesh);

/// 0/initialConditions, in file order. Throws InputError when two give a node different velocities.
std::vector<InitialVelocity> readInitialVelocities(const Dictionary& dictionary, const Mesh& mesh);

} // namespace fpm
