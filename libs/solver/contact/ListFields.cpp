#include "solver/contact/ListFields.h"

namespace fpm {

ListFields::ListFields(const NearBlocks::Pass& pass,
                       const Memory& memory,
                       const NumberTypes& numbers)
    : FieldSet("contact lists", memory, numbers),
      number(pass.number),
      reach(pass.reach)
{
    ownStart.assign(pass.own.starts);
    own.assign(pass.own.blocks);
    allOwn.assign(pass.allOwn);
    allTarget.assign(pass.allTarget);
    nearStart.resize(pass.own.starts.size());
    blocks.resize(pass.own.starts.size() - 1);
    due.resize(pass.own.starts.size() - 1);
}

bool ListFields::rebuild(const NearBlocks::Pass& pass)
{
    nearStart.fromHost(pass.near.starts);
    blocks.fromHost(std::vector<BlockListState>(blocks.size()));
    std::vector<Index> lists = pass.near.blocks;
    const bool grows = lists.size() > near.size();
    if (grows) near.resize(lists.size() + lists.size() / 2);
    lists.resize(near.size());
    near.fromHost(lists);
    return grows;
}

} // namespace fpm
