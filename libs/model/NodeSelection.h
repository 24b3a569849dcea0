#pragma once

#include "dictionary/Dictionary.h"
#include "mesh/Mesh.h"

namespace fpm {

/// Nodes of a part, ascending.
std::vector<Index> nodesOfPart(const Mesh& mesh, Index part);

/// Nodes of the part an entry names by `part`, ascending. Throws InputError for an unknown one.
std::vector<Index> nodesOfNamedPart(const Dictionary& entry, const Mesh& mesh);

/// Nodes an entry means by `set` (a node set, or the nodes of a side set) or by `part`, ascending.
std::vector<Index> selectNodes(const Dictionary& entry, const Mesh& mesh);

/// Sides of the side set an entry names by `set`. Throws InputError for anything else.
std::vector<ElementSide> selectSides(const Dictionary& entry, const Mesh& mesh);

/// Refuses, at `key` of `entry`, sides of a set that lie inside the material; `use`: what they are
/// wanted for, "a pressure".
void refuseInnerSides(const Dictionary& entry,
                      const std::string& key,
                      const Mesh& mesh,
                      const std::vector<ElementSide>& sides,
                      const std::string& use);

/// Parts an entry names by `parts`; all where it has none.
std::vector<Index> selectParts(const Dictionary& entry, const Mesh& mesh);

} // namespace fpm
