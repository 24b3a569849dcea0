#pragma once

#include "parallel/Atomic.h"
#include "parallel/Math.h"

namespace fpm {

/// Contact forces are added up as 64-bit integers: the sum does not depend on the order of the
/// contributions, so it is the same on any number of threads and on the GPU, and the force on a
/// contactor is exactly minus the sum of its shares on the target.
struct ForceScale {
    double toFixed = 1, fromFixed = 1;   ///< powers of two
    double toSpring = 1, fromSpring = 1; ///< for the stiffness sum, fourth value

    FPM_KERNEL double toForce(std::int64_t value) const { return double(value) * fromFixed; }
    FPM_KERNEL double toStiffness(std::int64_t value) const { return double(value) * fromSpring; }
    FPM_KERNEL std::int64_t force(double value) const { return std::int64_t(value * toFixed); }
    FPM_KERNEL std::int64_t spring(double value) const { return std::int64_t(value * toSpring); }
};

} // namespace fpm
