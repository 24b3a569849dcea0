#pragma once

#include "fields/Field.h"
#include "fields/NumberField.h"
#include "solver/nodes/NodeSetUp.h"

namespace fpm {

/// Motion of the nodes and what acts on them; see NodeMotion. Vectors are three planes.
struct NodeFields : FieldSet {
    NodeFields(const NodeSetUp& setUp,
               const std::vector<Point>& points,
               const Memory& memory,
               const NumberTypes& numbers);
    /// Nodes that NodeMotion moves and what holds them, after shareNodes().
    void renewListed(const NodeSetUp& setUp);
    std::size_t blocks() const { return blockEnergy.size() / 2; }

    NumberField position{*this, {"position", Location::node, Role::state}, Family::position};
    NumberField velocity{*this, {"velocity", Location::node, Role::state}, Family::motion};
    NumberField inverseMass{*this, {"inverseMass", Location::node, Role::constant}, Family::motion};
    /// Resultant at the end of the step before; of dynamic relaxation.
    NumberField lastForce{*this, {"lastForce", Location::node, Role::state}, Family::motion};
    Field<std::uint8_t> fixed{*this, {"fixed", Location::node, Role::derived}};
    Field<Index> listed{*this, {"listed", Location::table, Role::derived}};
    Field<Index> partialSumsStart{*this, {"partialSumsStart", Location::table, Role::constant}};
    Field<Index> partialSums{*this, {"partialSums", Location::table, Role::constant}};

    Field<Index> conditionStart{*this, {"conditionStart", Location::table, Role::constant}};
    Field<ConditionUse> uses{*this, {"uses", Location::table, Role::constant}};
    Field<Condition> conditions{*this, {"conditions", Location::table, Role::constant}};
    Field<double> amplitudeRows{*this, {"amplitudeRows", Location::table, Role::constant}};
    Field<Index> frameOf{*this, {"frameOf", Location::node, Role::constant}};
    Field<double> frames{*this, {"frames", Location::table, Role::constant}};

    Field<Index> pressureFaceNode{*this, {"pressureFaceNode", Location::table, Role::constant}};
    Field<Index> pressureFaceCondition{*this,
                                       {"pressureFaceCondition", Location::table, Role::derived}};
    Field<Index> pressureStart{*this, {"pressureStart", Location::table, Role::constant}};
    Field<Index> pressureSlots{*this, {"pressureSlots", Location::table, Role::constant}};
    NumberField pressureForce{
        *this, {"pressureForce", Location::table, Role::state}, Family::motion};

    /// Works on the nodes so far, see NodeMotion.
    Field<double> blockWork{*this, {"blockWork", Location::block, Role::state}};
    Field<double> blockEnergy{*this, {"blockEnergy", Location::block, Role::scratch}};
    Field<double> relaxationSum{*this, {"relaxationSum", Location::block, Role::scratch}};
};

/// Blocks of nodes that one team works at a time.
constexpr std::size_t nodeBlocks(std::size_t nodes)
{
    return (nodes + nodeBlock - 1) / nodeBlock;
}

/// Three planes of a vector field.
std::vector<double> planesOf(const std::vector<Point>& points);

} // namespace fpm
