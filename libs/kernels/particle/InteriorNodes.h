#pragma once

#include "kernels/particle/LeapFrog.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"

#include <cstddef>

namespace fpm {

/// Bits of a node in the array `fixed`.
enum FixedBit : std::uint8_t {
    heldX = 1, ///< component 0, in the node's axes, is held at zero velocity
    heldY = 2,
    heldZ = 4,
    heldComponents = heldX | heldY | heldZ,
    bodyNode = 8,     ///< a rigid body moves the node
    listedNode = 16,  ///< NodeMotion moves it, not the one patch that has it
    imposedNode = 32, ///< every component is held or prescribed: no contact spring can move it
};
/// The bit of component c.
FPM_KERNEL constexpr FixedBit heldComponent(int c)
{
    return FixedBit(heldX << c);
}

/// Advances nodes of a single patch on which only element forces act: the same as NodeMotion, to
/// the last bit, but within the patch's kernel, which has the nodes in fast memory.
template <class Numbers>
struct InteriorNodes {
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;
    using Work = typename Numbers::Work;

    Position* position; ///< three planes, nodeStride apart
    Motion* velocity;
    const Motion* inverseMass;
    const std::uint8_t* fixed; ///< nodes with any FixedBit stay unchanged
    std::size_t nodeStride;
    Work* force; ///< internal force in planes of its own: only of nodes of one patch
    std::size_t forceStride;

    /// Advances nodes first ... first + count - 1.
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
