#pragma once

#include "advise/Mirror.h"
#include "model/Model.h"

#include <vector>

namespace fpm {

/// Whether all of a model is its own mirror image, one answer for each of the planes x, y and z
/// through the middle of the mesh: nodes, elements and parts; conditions with their values; initial
/// velocities; contact pairs and analytic surfaces; rigid bodies. Returns the first obstacle.
/// Parts are mirrored onto themselves only. What holds, holds to 1e-9.
std::vector<MirrorMap> findSymmetry(const Model& model);

/// Why conditions, initial velocities or contact are not their own mirror image; empty: they are.
std::string conditionObstacle(const Model& model, const MirrorMap& map);
std::string initialObstacle(const Model& model, const MirrorMap& map);
std::string contactObstacle(const Model& model, const MirrorMap& map);

/// Velocities the initial conditions give, by node.
std::vector<Point> initialVelocities(const Model& model);

} // namespace fpm
