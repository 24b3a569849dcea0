#include "solver/contact/ContactFields.h"

#include "kernels/contact/lists/ReferenceDisplacement.h"
#include "solver/contact/Penalties.h"

namespace fpm {

ContactFields::ContactFields(const ContactSetUp& setUp,
                             const Memory& memory,
                             const NumberTypes& numbers)
    : FieldSet("contact", memory, numbers)
{
    renewNodes(setUp);
    for (const ContactPassSetup& pass : setUp.passes)
        passes.push_back(std::make_unique<PassFields>(pass, memory, numbers));
    bindSurfaces(setUp);
}

void ContactFields::bindSurfaces(const ContactSetUp& setUp)
{
    surfaceStart.assign(setUp.surfaceStart);
    surfaceUses.assign(setUp.surfaceUses);
    if (setUp.surfaceStart.empty()) return;
    std::vector<KinematicPass> views(passes.size());
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const ContactPassSetup& pass = setUp.passes[i];
        if (!pass.kinematic) continue;
        PassFields& f = *passes[i];
        views[i] = {.count = Index(f.contactor.size()),
                    .shape = setUp.surfaces[std::size_t(pass.surface)],
                    .friction = frictionLaw<double>(pass.law),
                    .push = pushOut * pass.meanFaceSize,
                    .dissipated = f.dissipated.data(),
                    .impact = f.damped.data(),
                    .work = f.surfaceWork.data(),
                    .reading = f.reading.data()};
    }
    kinematicPasses.assign(views);
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
