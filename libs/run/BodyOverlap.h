#pragma once

#include "mesh/Mesh.h"

namespace fpm {

/// Nodes of one body that lie inside elements of another.
struct BodyOverlap {
    std::size_t count = 0;
    Index node = -1; ///< the first
};

/// `points`: present positions; `nodes` of the one body against the elements of `parts`, numbers in
/// the mesh. Inside means by more than a hundredth of the element's size.
BodyOverlap overlapOf(const Mesh& mesh,
                      const std::vector<Point>& points,
                      const std::vector<Index>& nodes,
                      const std::vector<std::size_t>& parts);

} // namespace fpm
