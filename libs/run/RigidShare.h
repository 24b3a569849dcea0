#pragma once

#include "base/Types.h"

#include <vector>

namespace fpm {

/// Kinetic energy of a heap of masses and what of it is rigid motion.
struct RigidShare {
    double kinetic = 0, rigid = 0;
};

RigidShare rigidShare(const std::vector<Point>& places,
                      const std::vector<Point>& velocities,
                      const std::vector<double>& masses);

} // namespace fpm
