#pragma once

#include "stability/StabilityMap.h"

namespace fpm {

/// The map as an SVG file: a cell a point, coloured by its outcome, the predicted bounds drawn over
/// it; a frame around the points that are predicted to be stable.
std::string mapChart(const StabilityMap& map, const std::string& title);

} // namespace fpm
