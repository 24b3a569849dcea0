#pragma once

#include "kernels/contact/lists/ListCheck.h"
#include "solver/contact/EdgeView.h"
#include "solver/contact/ListLaunches.h"
#include "solver/contact/PassView.h"
#include "solver/contact/searchPass.h"

namespace fpm {

/// One pass as the list check sees it. `late`: count of lists that were used too long;
/// `checkInterval`: steps until the next check.
[[gnu::always_inline]] inline ListCheck listCheck(ListFields& f,
                                                  ContactFields& contact,
                                                  std::size_t place,
                                                  std::int64_t* late,
                                                  const StepRules& rules,
                                                  Index checkInterval,
                                                  StepClock* clock)
{
    return {f.reach,
            Index(f.blocks.size()),
            f.ownStart.data(),
            f.own.data(),
            f.nearStart.data(),
            f.near.data(),
            Index(f.allOwn.size()),
            Index(f.allTarget.size()),
            f.allOwn.data(),
            f.allTarget.data(),
            contact.referenceDisplacement.data(),
            f.blocks.data(),
            contact.lists.data() + place,
            f.due.data(),
            late,
            rules.growth,
            rules.fixedStep,
            checkInterval,
            clock};
}

/// Checks the lists of one pass.
template <class Executor>
void checkPass(Executor& executor, const ListCheck& list)
{
    executor.parallelFor(list.blockCount, BlockListCheck{list});
    executor.parallelBlocks(1, PassListCheck::scratch(), PassListCheck{list});
}

template <class Numbers, class Executor>
class ListLaunchesOf final : public ListLaunches
{
    using Position = typename Numbers::Position;

public:
    explicit ListLaunchesOf(const LaunchContext<Executor>& context) : on_(context) {}

    void check(Index steps) override
    {
        ContactFields& c = on_.fields.contact;
        NodeFields& n = on_.fields.nodes;
        on_.executor.parallelBlocks(
            Index(c.blocks()), ReferenceDisplacement<Numbers>::scratch(),
            ReferenceDisplacement<Numbers>{
                Index(c.nodes.size()), c.nodes.data(), n.position.data<Position>(),
                n.velocity.data<typename Numbers::Motion>(), std::size_t(on_.setUp.nodes.count),
                c.referenceOrigin.data(), c.referenceOffset.data(),
                c.referenceDisplacement.data()});
        for (std::size_t place = 0; place < c.passLists.size(); ++place)
            checkPass(on_.executor, checkOf(place, steps));
        on_.executor.parallelFor(
            1, ListCheckResult{c.lists.data(), Index(c.passLists.size()), clock()});
        storePositions(clock());
        for (std::size_t place = 0; place < c.passLists.size(); ++place)
            searchIn(c.passLists[place]->number,
                     {c.passLists[place]->due.data(), &c.lists.data()[place].due, nullptr});
    }

    void search(std::size_t pass, bool atSteps) override
    {
        searchIn(pass, {nullptr, nullptr, atSteps ? clock() : nullptr});
    }

    void storeReferencePositions() override { storePositions(nullptr); }

private:
    ListCheck checkOf(std::size_t place, Index steps)
    {
        ContactFields& c = on_.fields.contact;
        ListFields& list = *c.passLists[place];
        return listCheck(list, c, place, c.passes[list.number]->counts.data() + countLate,
                         on_.settings.rules, steps, clock());
    }
    void searchIn(std::size_t pass, const NodeBlocks& blocks)
    {
        const ContactPassSetup& setUp = on_.setUp.contact.passes[pass];
        if (setUp.ofEdges) {
            searchEdges(on_.executor, edgeView<Numbers>(on_, pass),
                        cellsOf(setUp, *on_.fields.contact.passes[pass]), blocks);
            return;
        }
        searchPass(on_.executor, passView<Numbers>(on_, pass),
                   cellsOf(setUp, *on_.fields.contact.passes[pass]),
                   setUp.search == ContactSearch::faces, blocks);
    }
    /// `clock` not null: where the last check found a search due.
    void storePositions(const StepClock* clock)
    {
        ContactFields& c = on_.fields.contact;
        Index count = Index(c.nodes.size());
        if constexpr (Executor::sharesMemory)
            if (clock && !clock->searched) return;
        on_.executor.parallelFor(
            count, StoreReferencePositions<Numbers>{
                       count, c.nodes.data(), on_.fields.nodes.position.template data<Position>(),
                       std::size_t(on_.setUp.nodes.count), c.referenceOrigin.data(),
                       c.referenceOffset.data(), clock});
    }
    StepClock* clock() { return on_.fields.clock.clock.data(); }

    LaunchContext<Executor> on_;
};

template <class Numbers, class Executor>
std::unique_ptr<ListLaunches> makeListLaunches(const LaunchContext<Executor>& context)
{
    return std::make_unique<ListLaunchesOf<Numbers, Executor>>(context);
}

} // namespace fpm
