#pragma once

#include "mesher/Placement.h"
#include "mesher/Shape.h"

namespace fpm {

/// Most cells across a cylinder in one block; keeps products of three counts below 2^63 and lists
/// short.
inline constexpr int mostCellsAcross = 2000;

/// Numbers of the faces of a cylinder in Shape::faces; the symmetry planes follow.
namespace face {
inline constexpr int bottom = 0, top = 1, outer = 2, inner = 3;
}

/// The bit of face `face` in PlacedNode::faces.
unsigned bit(int face);
/// Appends the faces of the sector's cut planes; returns the first one's number.
int addSymmetryFaces(Shape& shape, const Placement& placement);
/// Bits of the cut planes that a node of the unturned section lies on.
unsigned symmetryBits(const std::array<double, 2>& at, int quarters, int firstFace);
/// Radial, circumferential and axial direction at a place of the unit shape.
std::array<Point, 3> polarAxes(const Point& at);

} // namespace fpm
