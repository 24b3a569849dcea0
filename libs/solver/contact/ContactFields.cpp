#include "solver/contact/ContactFields.h"

#include "kernels/contact/lists/ReferenceDisplacement.h"

namespace fpm {

ContactFields::ContactFields(const ContactSetUp& setUp,
                             const Memory& memory,
                             const NumberTypes& numbers)
    : FieldSet("contact", memory, numbers)
{
    renewNodes(setUp);
    for (const ContactPassSetup& pass : setUp.passes)
        passes.push_back(std::make_unique<PassFields>(pass, memory, numbers));
}

void ContactFields::renewNodes(const ContactSetUp& setUp)
{
    const std::size_t count = setUp.nodes.size(),
                      blocks = std::size_t(blocksOf(Index(count), contactBlock));
    nodes.assign(setUp.nodes);
    numberOf.assign(setUp.numberOf);
    sum.resize(4 * count);
    bound.resize(blocks);
    referenceDisplacement.resize(displacementValues * blocks);
    referenceOrigin.resize(3 * blocks);
    referenceOffset.resize(3 * count);
}

void ContactFields::renewLists(const NearBlocks& near)
{
    passLists.clear();
    for (const NearBlocks::Pass& pass : near.passes())
        passLists.push_back(std::make_unique<ListFields>(pass, memory(), numbers()));
    lists.resize(passLists.size());
}

} // namespace fpm
