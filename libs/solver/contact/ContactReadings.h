#pragma once

#include "base/Types.h"

#include <cstdint>

namespace fpm {

/// All passes of a pair together; of a surface in contact with itself, and of general contact, the
/// forces on all nodes as contactors.
struct PairForce {
    Point force{0, 0, 0}; ///< on the contactor
    Index active = 0;     ///< contactors in contact, of both sides where both are
    /// Since the start: contactors released because they went too deep, and that left over a free
    /// edge; searches that found a contactor inside, a face nearer than the tracked one, and more
    /// bodies within reach of a node than it has slots; lists used beyond their validity.
    std::int64_t released = 0, overEdge = 0, inside = 0, mistaken = 0, crowded = 0, late = 0;
    double springEnergy = 0;          ///< recoverable energy of its springs
    double friction = 0, damping = 0; ///< dissipated since the start
};

/// Contact status of a pair: of its contactors in contact, over all its passes.
struct PairStatus {
    Index active = 0;
    /// Of those in contact, forgiven overlaps included; of means a contactor on a plane of symmetry
    /// counts half.
    double maxDepth = 0, meanDepth = 0;
    Index deepest = -1;      ///< node
    double thickness = 0;    ///< of the target at that node; 0: it has none
    double normal = 0;       ///< sum of the forces of the normal springs
    Point friction{0, 0, 0}; ///< on the contactor, as slip with pairs of two surfaces
    Point slip{0, 0, 0};     ///< mean velocity of contactors against the target, along it
    double speed = 0;        ///< mean length of that velocity
};

/// The node, or the part that is a free rigid body, whose contact springs are the stiffest for its
/// mass; -1: none.
struct ContactBound {
    Index node = -1, part = -1;
    double frequency = 0; ///< omega_c
};

/// Contactors of a pair that lie inside the target before the run.
struct PairOverlap {
    Index count = 0;
    double deepest = 0;
    Index node = -1; ///< the deepest
};

} // namespace fpm
