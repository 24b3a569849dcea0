#pragma once

#include "mesh/Mesh.h"

namespace fpm {

/// Edges of one surface that pass through faces of the other between their nodes, so that no node
/// is inside and node-to-face contact does not see it.
struct EdgeCrossings {
    std::size_t count = 0;
    double depth = 0; ///< of the deepest, over the width of a face or its path through a thin body
    Point place{0, 0, 0}; ///< of the deepest
};

/// A plane of symmetry, on which a surface goes on as its own mirror image.
struct SurfaceMirror {
    Point normal;                   ///< unit
    const std::vector<bool>* holds; ///< [node of the mesh]
};

/// Counts the sharp edges (more than 30 degrees between their faces, or one face only) of each
/// surface whose ends both lie outside the other and whose middle is inside by more than a
/// hundredth of that width. `points` are the present positions of the mesh's nodes.
EdgeCrossings edgeCrossings(const Mesh& mesh,
                            const std::vector<Point>& points,
                            const std::vector<ElementSide>& contactor,
                            const std::vector<ElementSide>& target,
                            const std::vector<SurfaceMirror>& mirrors = {});

} // namespace fpm
