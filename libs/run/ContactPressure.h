#pragma once

#include "model/Model.h"

#include <vector>

namespace fpm {

/// Contact pressure at each node: force of contact into the body over the node's area of contact
/// surfaces as they lie now, 0 off them. `points` and `force` of all nodes; sides of `deleted`
/// elements do not count (empty: none is). A node on an edge has the area of both its sides, of
/// which one may be free.
std::vector<double> contactPressure(const Model& model,
                                    const std::vector<Point>& points,
                                    const std::vector<Point>& force,
                                    const std::vector<bool>& deleted);

} // namespace fpm
