#include "solver/bodies/BodyFields.h"

#include "solver/nodes/NodeFields.h"

namespace fpm {

BodyFields::BodyFields(const BodySetUp& setUp, const Memory& memory, const NumberTypes& numbers)
    : FieldSet("bodies", memory, numbers)
{
    bodies.assign(setUp.bodies);
    bodyOf.assign(setUp.bodyOf);
    nodes.assign(setUp.nodes);
    arm.assign(planesOf(setUp.arm));
    useStart.assign(setUp.useStart);
    uses.assign(setUp.uses);
    blocks.assign(setUp.blocks);
    blockStart.assign(setUp.blockStart);
    loaded.assign(setUp.loaded);
    inverseMass.assign(setUp.inverseMass);
    sums.resize(bodySums * setUp.blocks.size());
    contactBound.resize(setUp.bodies.size());
}

} // namespace fpm
