#pragma once

#include "fields/Field.h"
#include "kernels/contact/lists/ListCheck.h"
#include "solver/contact/NearBlocks.h"

namespace fpm {

/// How long the contact lists of one pass last; see ListCheck.
struct ListFields : FieldSet {
    ListFields(const NearBlocks::Pass& pass, const Memory& memory, const NumberTypes& numbers);
    /// The pass was searched as a whole. True: arrays have moved, see Backend::forgetSteps.
    bool rebuild(const NearBlocks::Pass& pass);

    std::size_t number; ///< of the pass among all
    double reach;
    Field<Index> ownStart{*this, {"ownStart", Location::table, Role::derived}};
    Field<Index> own{*this, {"own", Location::table, Role::derived}};
    Field<Index> allOwn{*this, {"allOwn", Location::table, Role::derived}};
    Field<Index> allTarget{*this, {"allTarget", Location::table, Role::derived}};
    Field<Index> nearStart{*this, {"nearStart", Location::table, Role::state}};
    Field<Index> near{*this, {"near", Location::list, Role::state}};
    Field<BlockListState> blocks{*this, {"blocks", Location::block, Role::state}};
    Field<Index> due{*this, {"due", Location::block, Role::scratch}}; ///< blocks that search now
};

} // namespace fpm
