#pragma once

#include "mesh/Mesh.h"

#include <string>
#include <vector>

namespace fpm {

/// The plane `axis` = `place`.
struct MirrorPlane {
    std::size_t axis = 0; ///< 0 x, 1 y, 2 z
    double place = 0;     ///< [length]

    std::string text() const; ///< "x = 0"
    Point image(Point position) const
    {
        position[axis] = 2 * place - position[axis];
        return position;
    }
    /// Of a displacement, velocity, force, direction.
    Point imageOfVector(Point vector) const
    {
        vector[axis] = -vector[axis];
        return vector;
    }
};

/// What of an element's shape must be its own mirror image, beside the nodes: directions that its
/// formulation prefers.
enum class ElementAxes { none, zeta, all };

/// A mesh as its own mirror image: the image of every node and element. `obstacle` says why there
/// is none.
struct MirrorMap {
    MirrorPlane plane;
    std::string obstacle;
    std::vector<Index> node, element;
    std::vector<bool> onPlane; ///< nodes

    bool holds() const { return obstacle.empty(); }
    ElementSide image(const Mesh& mesh, const ElementSide& side) const;
};

/// Largest distance between a node and its image that counts as zero: 1e-9 of the mesh's diagonal,
/// so that an intended imperfection is not symmetric.
double mirrorTolerance(const Mesh& mesh);

/// Matches nodes and elements part by part, each part with itself. Refuses planes that pass through
/// elements. `axes`: by part.
MirrorMap
mirrorMesh(const Mesh& mesh, const MirrorPlane& plane, const std::vector<ElementAxes>& axes);

} // namespace fpm
