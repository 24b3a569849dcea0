#pragma once

#include "model/Model.h"

namespace fpm {

/// Stable step of an element whose corners lie at the given points (Flanagan and Belytschko's bound
/// with linear bulk viscosity); negative when its volume is not positive.
double elementStep(const Part& part, double mass, const std::array<Point, 8>& corners);

/// The smallest stable step of the deformable elements of the mesh as it is read.
double firstElementStep(const Model& model);

} // namespace fpm
