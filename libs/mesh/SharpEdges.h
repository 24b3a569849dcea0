#pragma once

#include "mesh/Mesh.h"

#include <span>

namespace fpm {

/// A convex edge between two element sides: its ends in the order of the first, then the two far
/// corners of either side.
struct SharpEdge {
    std::array<Index, 6> nodes;
    std::vector<ElementSide> sides; ///< those of the two that belong to the surface
};

/// Convex edges of a surface whose faces meet at more than 30 degrees, in the order of their
/// nodes. Where the surface ends, the side of the element beyond its border counts as well, if it
/// is an outer one; an edge at which the body goes on is none. `mirrors`: [plane][node], nodes on
/// planes of symmetry; sides and edges that lie in one are no part of the body's surface.
std::vector<SharpEdge> sharpEdges(const Mesh& mesh,
                                  std::span<const ElementSide> surface,
                                  const std::vector<const std::vector<bool>*>& mirrors = {});

} // namespace fpm
