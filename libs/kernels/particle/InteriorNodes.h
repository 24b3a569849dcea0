#pragma once

#include "kernels/particle/LeapFrog.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"

#include <cstddef>

namespace fpm {

/// Bits of the array `fixed` beside 0..2 (component held at zero velocity): a rigid body moves the
/// node; NodeMotion moves it, not the one patch that it belongs to; every component of its motion
/// is held or driven, so that no spring can disturb it.
inline constexpr std::uint8_t bodyNode = 8, listedNode = 16, imposedNode = 32;

/// Advances nodes of one patch alone, on which nothing acts but its elements: what NodeMotion does
/// for them, to the last bit, but in the patch's kernel, which has them at hand.
template <class Numbers>
struct InteriorNodes {
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;
    using Work = typename Numbers::Work;

    Position* position; ///< three planes, nodeStride apart
    Motion* velocity;
    const Motion* inverseMass;
    const std::uint8_t* fixed; ///< nodes with any bit stay as they are
    std::size_t nodeStride;
    Work* force; ///< internal, in planes of their own: only of nodes of one patch
    std::size_t forceStride;

    /// Nodes first ... first + count - 1.
    template <class Team>
    FPM_KERNEL void
    advance(const Team& team, std::size_t first, Index count, const StepClock& clock) const
    {
        const Motion h = Motion(clock.mean), dt = Motion(clock.step);
        const Motion* inverse = inverseMass + first;
        const std::uint8_t* others = fixed + first;
        for (int c = 0; c < 3; ++c) {
            Position* x = position + c * nodeStride + first;
            Motion* v = velocity + c * nodeStride + first;
            const Work* f = force + c * forceStride + first;
            team.forEach(count, [=](Index i) {
                const bool moves = others[i] == 0;
                const Motion next =
                    leapFrogVelocity(v[i], Motion(0) - Motion(f[i]), inverse[i], h, Motion(0));
                const Position place = advanced(x[i], dt * next);
                v[i] = moves ? next : v[i];
                x[i] = moves ? place : x[i];
            });
        }
    }
};

} // namespace fpm
