#include "solver/nodes/NodeFields.h"

namespace fpm {

std::vector<double> planesOf(const std::vector<Point>& points)
{
    std::vector<double> out(3 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) out[c * points.size() + i] = points[i][c];
    return out;
}

NodeFields::NodeFields(const NodeSetUp& setUp,
                       const std::vector<Point>& points,
                       const Memory& memory,
                       const NumberTypes& numbers)
    : FieldSet("nodes", memory, numbers)
{
    const std::size_t count = std::size_t(setUp.count), blocks = nodeBlocks(count);
    const bool relaxes = setUp.relaxation.tolerance > 0;
    position.assign(planesOf(points));
    velocity.assign(planesOf(setUp.velocity));
    std::vector<double> inverse;
    // A rigid part may have no density: its nodes are driven, whatever pulls at them.
    for (const double mass : setUp.mass) inverse.push_back(mass > 0 ? 1 / mass : 0);
    inverseMass.assign(inverse);
    lastForce.resize(relaxes ? 3 * count : 0);
    renewListed(setUp);
    partialSumsStart.assign(setUp.partialSumsStart);
    partialSums.assign(setUp.partialSums);
    conditionStart.assign(setUp.conditionStart);
    uses.assign(setUp.uses);
    conditions.assign(setUp.conditions);
    amplitudeRows.assign(setUp.amplitudeRows);
    frameOf.assign(setUp.frameOf);
    frames.assign(setUp.frames);
    pressureFaceNode.assign(setUp.pressureFaceNode);
    pressureFaceCondition.assign(setUp.pressureFaceCondition);
    pressureStart.assign(setUp.pressureStart);
    pressureSlots.assign(setUp.pressureSlots);
    pressureForce.resize(3 * setUp.pressureFaceNode.size());
    blockWork.resize(blocks * nodeWorks);
    blockEnergy.resize(2 * blocks);
    relaxationSum.resize(relaxes ? relaxationSums * blocks : 0);
}

void NodeFields::renewListed(const NodeSetUp& setUp)
{
    fixed.assign(setUp.fixed);
    listed.assign(setUp.listed);
}

} // namespace fpm
