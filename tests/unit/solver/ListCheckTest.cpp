#include "parallel/CpuExecutor.h"
#include "solver/contact/launchLists.h"

#include <gtest/gtest.h>

#include <sstream>

namespace fpm {
namespace {

/// All nodes are contact nodes.
void numberNodes(SolverSetUp& data, Index count)
{
    for (Index node = 0; node < count; ++node) {
        data.contact.nodes.push_back(node);
        data.contact.numberOf.push_back(node);
    }
}

/// Four surfaces of `blocks` blocks of contact nodes each; 0 on 1, and 2 on 3.
SolverSetUp twoPairs(double reach, Index blocks)
{
    SolverSetUp data;
    data.contact.passes.resize(2);
    const Index size = blocks * contactBlock;
    for (Index pair = 0; pair < 2; ++pair) {
        ContactPassSetup& p = data.contact.passes[std::size_t(pair)];
        p.reach = reach;
        p.nodeCount = size;
        for (Index i = 0; i < size; ++i) {
            p.contactor.push_back(2 * pair * size + i);
            p.faceNode.push_back((2 * pair + 1) * size + i);
        }
    }
    numberNodes(data, 4 * size);
    return data;
}

/// List checks of a solver for given displacements of the contact nodes; lists of waiting passes
/// are rebuilt.
class ListChecks
{
public:
    ListChecks(const SolverSetUp& data, NearBlocks::Positions positions)
        : positions_(std::move(positions)),
          near_(data),
          fields_(std::make_unique<ContactFields>(data.contact, hostMemory(), NumberTypes{}))
    {
        fields_->renewLists(near_);
        clock_.stop = 1e9;
        clock_.step = 1;
        rules.growth = 1;
        for (std::size_t pass = 0; pass < near_.passes().size(); ++pass) rebuild(pass);
    }

    /// "0: all", "1: 0 2" for the passes that are due and their blocks. Displacements and speeds of
    /// the blocks of contact nodes since the last rebuild of any.
    std::string operator()(const std::vector<double>& distances, const std::vector<double>& speeds)
    {
        std::vector<double> displacements;
        for (std::size_t block = 0; block < distances.size(); ++block) {
            displacements.push_back(distances[block] * distances[block]);
            displacements.push_back(speeds[block] * speeds[block]);
            displacements.push_back(rounding * rounding);
        }
        fields_->referenceDisplacement.fromHost(displacements);
        std::vector<ListCheck> checks;
        for (std::size_t pass = 0; pass < near_.passes().size(); ++pass)
            checks.push_back(
                listCheck(*fields_->passLists[pass], *fields_, pass, &late_, rules, 10, &clock_));
        for (const ListCheck& check : checks) checkPass(executor_, check);
        executor_.parallelFor(
            1, ListCheckResult{fields_->lists.data(), Index(near_.passes().size()), &clock_});
        std::ostringstream text;
        for (std::size_t pass = 0; pass < near_.passes().size(); ++pass) {
            const PassListState& found = fields_->lists.data()[pass];
            if (!found.rebuild && found.due == 0) continue;
            text << (text.tellp() > 0 ? ", " : "") << pass << ":";
            for (std::int64_t k = 0; k < found.due; ++k) text << " " << checks[pass].list[k];
            if (!found.rebuild) continue;
            text << " all";
            EXPECT_FALSE(clock_.mayStep());
            rebuild(pass);
        }
        return text.str();
    }
    Index steps() const { return Index(clock_.listsValidUntil - clock_.steps); }
    std::int64_t late() const { return late_; }
    const NearBlocks& near() const { return near_; }
    StepClock& clock() { return clock_; }

    StepRules rules;
    double rounding = 0; ///< of the given displacements

private:
    using Executor = CpuExecutor<64>;

    void rebuild(std::size_t pass)
    {
        near_.rebuild(pass, positions_);
        fields_->passLists[pass]->rebuild(near_.passes()[pass]);
        fields_->lists.data()[pass] = {};
        fields_->lists.data()[pass].rebuilt = 1;
    }

    Executor executor_{1, PassListCheck::scratch()};
    NearBlocks::Positions positions_;
    NearBlocks near_;
    std::unique_ptr<ContactFields> fields_;
    StepClock clock_;
    std::int64_t late_ = 0;
};

/// Block k of each surface lies at x = k * spacing.
ListChecks rebuiltChecks(double reach, Index blocks, double spacing)
{
    const std::size_t count = std::size_t(4 * blocks * contactBlock);
    NearBlocks::Positions positions(3 * count);
    for (std::size_t i = 0; i < count; ++i)
        positions[i] = spacing * double(Index(i) / contactBlock % blocks);
    return {twoPairs(reach, blocks), std::move(positions)};
}

/// One block a surface; the targets lie at x = distance.
ListChecks apart(double reach, double distance)
{
    const std::size_t count = std::size_t(4 * contactBlock);
    NearBlocks::Positions positions(3 * count);
    for (std::size_t i = 0; i < count; ++i)
        positions[i] = distance * double(Index(i) / contactBlock % 2);
    return {twoPairs(reach, 1), std::move(positions)};
}

const std::vector<double> still(4, 0.0);

TEST(ListCheck, DisplacementsOfBothSidesAddUpAndOtherPassesDoNotCount)
{
    ListChecks check = rebuiltChecks(1, 1, 0);
    check(still, still);
    EXPECT_EQ(check({0.5, 0.49, 0, 0}, still), "");
    EXPECT_EQ(check({0.5, 0.51, 0, 0}, still), "0: 0");
    EXPECT_EQ(check.steps(), 10);
}

TEST(ListCheck, ADisplacementBeforeTheRebuildOfAnotherPassCounts)
{
    ListChecks check = rebuiltChecks(1, 1, 0);
    check(still, still);
    EXPECT_EQ(check({2, 0, 0.6, 0}, still), "0: 0");
    // Reference positions were stored then: another 0.5 is 1.1 for the second pass, 0.5 for the
    // first.
    EXPECT_EQ(check({0.5, 0, 0.5, 0}, still), "1: 0");
    EXPECT_EQ(check({0.4, 0, 0.9, 0}, still), "");
}

TEST(ListCheck, TheComingStepsCountHalfAsFastAgain)
{
    ListChecks check = rebuiltChecks(1, 1, 0);
    check(still, still);
    // 1.5 (0.03 + 0.03) a step: ten steps are 0.9, a little more than eleven the skin.
    EXPECT_EQ(check(still, {0.03, 0.03, 0, 0}), "");
    EXPECT_EQ(check({0.2, 0, 0, 0}, {0.03, 0.03, 0, 0}), "0: 0");
    // Too fast for ten steps even after a rebuild: fewer steps, but at least one.
    check(still, {0.1, 0.1, 0, 0});
    EXPECT_EQ(check.steps(), 3);
    check(still, {100, 0, 0, 0});
    check(still, {100, 0, 0, 0});
    EXPECT_EQ(check.steps(), 1);
    EXPECT_EQ(check.late(), 0);
}

TEST(ListCheck, WhatIsFarFromTheMotionDoesNotSearch)
{
    // Three blocks a surface, 100 skins apart; displacements in the order of the surfaces.
    ListChecks check = rebuiltChecks(1, 3, 100);
    const std::vector<double> slow(12, 0.0);
    std::vector<double> distances(12, 0.0);
    check(distances, slow);
    distances[4] = 1.5; // the middle block of the first pass's target
    EXPECT_EQ(check(distances, slow), "0: 1");
    distances[4] = 0;
    distances[0] = 0.9; // of the first contactors; the lists of the middle ones were rebuilt
                        // meanwhile
    EXPECT_EQ(check(distances, slow), "");
    distances[0] = 1.1;
    EXPECT_EQ(check(distances, slow), "0: 0");
}

TEST(ListCheck, WhereSomethingCameFromAfarAllSearchAgain)
{
    ListChecks check = rebuiltChecks(1, 3, 100);
    const std::vector<double> slow(12, 0.0);
    std::vector<double> distances(12, 0.0);
    check(distances, slow);
    distances[4] = 3;
    EXPECT_EQ(check(distances, slow), "0: 1");
    EXPECT_EQ(check(distances, slow), "0: 1");
    // 3 + 3 + 3 is more than the 7 skins for which the neighbourhood is complete.
    EXPECT_EQ(check(distances, slow), "0: all");
    // It was rebuilt at the present positions: at any speed the next check lets it continue.
    EXPECT_EQ(check(slow, distances), "");
    EXPECT_EQ(check.steps(), 1);
}

TEST(ListCheck, AFixedStepIsForeseenAfterOneThatWasCut)
{
    ListChecks check = rebuiltChecks(1, 1, 0);
    check(still, still);
    check.clock().step = 0.01; // to meet a time; the next ones are 1 again
    check.rules.fixedStep = 1;
    EXPECT_EQ(check({0.2, 0, 0, 0}, {0.03, 0.03, 0, 0}), "0: 0");
}

TEST(ListCheck, NeighboursStayCompleteForAsManyStepsAsFollow)
{
    // The target approaches from far, four skins a step with the safety factor; no contactor is
    // near it.
    ListChecks check = apart(1, 200);
    const std::vector<double> speeds{0, 4 / 1.5, 0, 0};
    check(still, still);
    EXPECT_EQ(check({0, 7, 0, 0}, speeds), "0: all");
    EXPECT_EQ(check(still, speeds), "");
    EXPECT_EQ(check.steps(), 1); // of the seven skins
    EXPECT_EQ(check.late(), 0);
}

TEST(ListCheck, BlocksWithNothingNearDoNotSearch)
{
    ListChecks check = apart(1, 200);
    check(still, still);
    EXPECT_EQ(check({3, 0, 0, 0}, still), "");
    EXPECT_EQ(check.steps(), 10);
    EXPECT_EQ(check({8, 0, 0, 0}, still), "0: all"); // it may be near by now
    EXPECT_EQ(check.late(), 0);
}

TEST(ListCheck, ListsThatWereUsedForTooLongAreCounted)
{
    ListChecks check = rebuiltChecks(1, 3, 100);
    const std::vector<double> slow(12, 0.0);
    std::vector<double> distances(12, 0.0);
    check(distances, slow);
    distances[4] = 0.9;
    check(distances, slow);
    EXPECT_EQ(check.late(), 0);
    distances[4] = 1.1; // of block 1 alone
    check(distances, slow);
    EXPECT_EQ(check.late(), 1);
    distances[4] = 9; // and its neighbourhood is no longer complete
    check(distances, slow);
    EXPECT_EQ(check.late(), 3);
}

TEST(ListCheck, WhatMayBeRoundingIsSearchedForButNotCountedAsLate)
{
    ListChecks check = rebuiltChecks(1, 1, 0);
    check(still, still);
    check.rounding = 0.3; // of each side, at both ends of a displacement
    EXPECT_EQ(check({1.1, 0, 0, 0}, still), "0: 0");
    EXPECT_EQ(check.late(), 0);
    EXPECT_EQ(check({2.3, 0, 0, 0}, still), "0: 0");
    EXPECT_EQ(check.late(), 1);
}

TEST(NearBlocks, ThreadsShareBlocksOfContactNodesWhereTheirContactorsMeet)
{
    // Four blocks a surface, the second pair like the first; two threads with two blocks each.
    const std::vector<Index> starts{0, 2};
    const auto text = [&](double spacing) {
        std::string out;
        for (const std::uint8_t shared :
             rebuiltChecks(1, 4, spacing).near().sharedBlocks(0, starts))
            out += shared ? 's' : '-';
        return out;
    };
    EXPECT_EQ(text(100), "--------"); // contactors and, below each of them, the target's nodes
    EXPECT_EQ(text(0), "----ssss");   // all in one place
    // Within 24 skins: those beside the border of the two threads.
    EXPECT_EQ(text(15), "-----ss-");
}

TEST(NearBlocks, CornersOfALargeFaceAreNearWhateverIsOverIt)
{
    // One face as wide as 100 skins whose corners lie in two blocks of contact nodes, and a block
    // of contactors over its middle.
    SolverSetUp data;
    data.contact.passes.resize(1);
    ContactPassSetup& pass = data.contact.passes[0];
    pass.reach = 1;
    pass.nodeCount = 2 * contactBlock;
    for (Index i = 0; i < pass.nodeCount; ++i) pass.contactor.push_back(i);
    pass.faceNode = {2 * contactBlock, 2 * contactBlock + 1, 3 * contactBlock,
                     3 * contactBlock + 1};
    const std::size_t count = std::size_t(4 * contactBlock);
    numberNodes(data, 4 * contactBlock);
    NearBlocks::Positions positions(3 * count);
    for (std::size_t i = 0; i < std::size_t(2 * contactBlock); ++i) positions[i] = 50;
    positions[std::size_t(3 * contactBlock)] = positions[std::size_t(3 * contactBlock) + 1] = 100;
    ListChecks check(data, positions);
    check(still, still);
    EXPECT_EQ(check({0, 0, 0, 1.1}, still), "0: 0 1");
    const std::vector<std::uint8_t> shared = check.near().sharedBlocks(0, {0, 1});
    EXPECT_EQ(shared, (std::vector<std::uint8_t>{0, 0, 1, 1}));
}

} // namespace
} // namespace fpm
