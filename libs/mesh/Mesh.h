#pragma once

#include "base/Types.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace fpm {

using Hexahedron = std::array<Index, 8>; ///< node numbers, VTK/Abaqus order: bottom ring, top ring
using Quad = std::array<Index, 4>;       ///< node numbers, counter-clockwise seen from outside

/// Side of an element: 0..5 in VTK order, corners in sideCorners[side], outward normal.
struct ElementSide {
    Index element;
    Index side;
    auto operator<=>(const ElementSide&) const = default;
};

/// VTK hexahedron sides with outward normals: -xi, +xi, -eta, +eta, -zeta, +zeta.
inline constexpr std::array<std::array<int, 4>, 6> sideCorners{
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};

/// A body made of one material: a run of elements. Parts never share elements.
struct MeshPart {
    std::string name;
    Index firstElement = 0, elementCount = 0;
};

/// The two sides of a contact pair, as fpmSetContact stores them in the mesh file.
struct ContactSurfaces {
    std::string pair;
    std::vector<Index> contactorNodes; ///< ascending
    std::vector<ElementSide> contactorSides;
    std::vector<ElementSide> targetSides;
};

/// Hexahedra in parts, with named sets. Elements of a part are consecutive; within a part, patches
/// are consecutive runs of at most 256 elements (patchStarts), numbered along a space-filling
/// curve.
struct Mesh {
    std::vector<Point> points;
    std::vector<Hexahedron> hexahedra;
    std::vector<MeshPart> parts;
    std::vector<Index> patchStarts; ///< first element of each patch, then the element count
    std::map<std::string, std::vector<Index>> nodeSets;       ///< ascending
    std::map<std::string, std::vector<ElementSide>> sideSets; ///< ascending
    std::vector<ContactSurfaces> contact;                     ///< empty until fpmSetContact
    std::string contactKey; ///< checksum of contactDict + mesh the surfaces were made from

    Index partOf(Index element) const;
    Index findPart(const std::string& name) const; ///< -1 when absent
    Quad sideNodes(const ElementSide& side) const;
};

} // namespace fpm
