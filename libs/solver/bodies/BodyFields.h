#pragma once

#include "fields/Field.h"
#include "solver/bodies/BodySetUp.h"

namespace fpm {

/// Free rigid bodies; empty without.
struct BodyFields : FieldSet {
    BodyFields(const BodySetUp& setUp, const Memory& memory, const NumberTypes& numbers);

    Field<RigidBody> bodies{*this, {"bodies", Location::body, Role::state}};
    Field<Index> bodyOf{*this, {"bodyOf", Location::node, Role::constant}};
    Field<Index> nodes{*this, {"nodes", Location::table, Role::constant}};
    Field<double> arm{*this, {"arm", Location::table, Role::constant}};
    Field<Index> useStart{*this, {"useStart", Location::table, Role::constant}};
    Field<ConditionUse> uses{*this, {"uses", Location::table, Role::constant}};
    Field<BodyBlock> blocks{*this, {"blocks", Location::table, Role::constant}};
    Field<Index> blockStart{*this, {"blockStart", Location::table, Role::constant}};
    Field<Index> loaded{*this, {"loaded", Location::table, Role::constant}};
    Field<double> inverseMass{*this, {"inverseMass", Location::table, Role::constant}};
    Field<double> sums{*this, {"sums", Location::block, Role::scratch}};
    /// Square of the frequency of its contact springs, for the next step.
    Field<double> contactBound{*this, {"contactBound", Location::body, Role::state}};
};

} // namespace fpm
