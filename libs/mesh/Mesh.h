#pragma once

#include "base/ElementShape.h"
#include "base/Types.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace fpm {

using Hexahedron = std::array<Index, HexahedronShape::nodes>; ///< node numbers, VTK/Abaqus order
using Quad = std::array<Index, 4>; ///< node numbers, counter-clockwise seen from outside

/// Side of an element: 0..5 in VTK order, corners in sideCorners[side], outward normal.
struct ElementSide {
    Index element;
    Index side;
    auto operator<=>(const ElementSide&) const = default;
};

/// Corners of the sides of a hexahedron, as in HexahedronShape.
inline constexpr std::array<std::array<int, 4>, HexahedronShape::faces> sideCorners = [] {
    std::array<std::array<int, 4>, HexahedronShape::faces> corners{};
    for (std::size_t side = 0; side < corners.size(); ++side)
        for (std::size_t k = 0; k < 4; ++k) corners[side][k] = HexahedronShape::face[side].node[k];
    return corners;
}();

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
