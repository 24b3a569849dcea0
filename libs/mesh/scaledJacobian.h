#pragma once

#include "mesh/Mesh.h"

/// Shape of one element; shared by quality() and checkMesh().
namespace fpm {

std::array<Point, 8> corners(const Mesh& mesh, Index element);
/// Least of the eight corner Jacobians, each divided by the lengths of its three edges: 1 for a
/// brick, 0 for a flat corner, negative where the corner is turned inside out.
double minScaledJacobian(const std::array<Point, 8>& corners);

} // namespace fpm
