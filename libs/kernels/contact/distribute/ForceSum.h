#pragma once

#include "parallel/Atomic.h"
#include "parallel/LaunchSizes.h"
#include "parallel/Math.h"

namespace fpm {

/// Contact forces are summed as 64-bit integers in fixed point: the sum does not depend on the
/// order of the contributions, hence is the same for any number of threads and on the GPU, and the
/// force on a contactor is exactly minus the sum of the forces on the target.
struct ForceScale {
    double toFixed = 1, fromFixed = 1;   ///< powers of two
    double toSpring = 1, fromSpring = 1; ///< for the sum of stiffness, the fourth value

    FPM_KERNEL double toForce(std::int64_t value) const { return double(value) * fromFixed; }
    FPM_KERNEL double toStiffness(std::int64_t value) const { return double(value) * fromSpring; }
    FPM_KERNEL std::int64_t force(double value) const { return std::int64_t(value * toFixed); }
    FPM_KERNEL std::int64_t spring(double value) const { return std::int64_t(value * toSpring); }
};

/// Sum of the forces on the contactors of one block, in several partial sums, so that threads of
/// one block rarely add to the same one.
struct BlockForce {
    static constexpr Index parts = 8, values = 3 * parts;
    std::int64_t* sums; ///< [parts][3], fixed point
    std::int64_t* each; ///< [contactor][3], of all blocks; null: not required
    bool alone;         ///< one thread works on the block: no atomic operations needed

    FPM_KERNEL void add(Index i, const std::int64_t (&force)[3]) const
    {
        for (int c = 0; c < 3; ++c) add64(sums + 3 * (i % parts) + c, force[c], alone);
        if (!each) return;
        for (int c = 0; c < 3; ++c) each[3 * std::size_t(i) + std::size_t(c)] = force[c];
    }
};

/// Accumulated force and stiffness of each contact node.
struct ContactSums {
    std::int64_t* values; ///< [contact node][4]: force and stiffness, fixed point
    ForceScale scale;
    bool alone;                 ///< no two threads add to one node: no atomic operations needed
    const std::uint8_t* shared; ///< blocks of contact nodes to which two threads may add; null: all
                                ///< of them

    FPM_KERNEL void addForce(Index number, const std::int64_t (&force)[3]) const
    {
        std::int64_t* to = values + 4 * std::size_t(number);
        for (int c = 0; c < 3; ++c) add64(to + c, force[c], isMine(number));
    }
    FPM_KERNEL void addStiffness(Index number, double stiffness) const
    {
        add64(values + 4 * std::size_t(number) + 3, scale.spring(stiffness), isMine(number));
    }

private:
    FPM_KERNEL bool isMine(Index number) const
    {
        return alone || (shared && shared[number / contactBlock] == 0);
    }
};

} // namespace fpm
