#pragma once

#include "solver/elements/ElementSetUp.h"

namespace fpm {

/// Corners of an element of the mesh as it is read.
std::array<Point, 8> cornersOf(const Mesh& mesh, Index element);
/// Stable step of an element of a part, without quadratic bulk viscosity; <= 0 when it is inverted.
double stableStep(const Part& part, const std::array<Point, 8>& corners, double mass);
/// The smallest stable step of the deformable elements of the mesh as it is read.
double firstElementStep(const ElementSetUp& elements, const Model& model);

} // namespace fpm
