#pragma once

#include "mesh/Mesh.h"

#include <span>

namespace fpm {

/// Outer sides of a part: sides that belong to one of its elements only, ascending. `absent`: of
/// every element, whether it counts as not there; empty: all are there.
std::vector<ElementSide> skin(const Mesh& mesh, Index part, const std::vector<bool>& absent = {});
/// Those of the given sides that lie inside the material: another element, of whatever part, has
/// the same four nodes. In the order given.
std::vector<ElementSide> innerSides(const Mesh& mesh, std::span<const ElementSide> sides);
/// Nodes on the given sides, ascending, each once.
std::vector<Index> nodesOf(const Mesh& mesh, std::span<const ElementSide> sides);
Point centre(const Mesh& mesh, const ElementSide& side);
/// Outward unit normal at the centre of the side (zero vector for a degenerate side).
Point normal(const Mesh& mesh, const ElementSide& side);
double area(const Mesh& mesh, const ElementSide& side);

} // namespace fpm
