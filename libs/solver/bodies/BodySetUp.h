#pragma once

#include "kernels/particle/BodyNodes.h"

#include <vector>

namespace fpm {

/// Free rigid bodies, one a rigidFree part.
struct BodySetUp {
    std::vector<Index> part;
    std::vector<RigidBody> bodies;
    std::vector<Index> bodyOf; ///< of each node, -1; empty without bodies
    std::vector<Index> nodes;  ///< of all bodies
    std::vector<Point> arm;    ///< of each of them, from the centre
    std::vector<Index> useStart;
    std::vector<ConditionUse> uses; ///< loads on a body as a whole
    std::vector<BodyBlock> blocks;
    std::vector<Index> blockStart, loaded; ///< nodes that may feel a force
    std::vector<double> inverseMass;       ///< of each of them, for contact springs
};

} // namespace fpm
