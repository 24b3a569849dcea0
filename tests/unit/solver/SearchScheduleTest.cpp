#include "solver/SearchSchedule.h"

#include "kernels/contact/Travel.h"

#include <gtest/gtest.h>

#include <sstream>

namespace fpm {
namespace {

/// All nodes are contact nodes.
void numberNodes(SolverData& data, Index count)
{
    for (Index node = 0; node < count; ++node) data.contactNumber.push_back(node);
}

/// Four surfaces of `blocks` blocks of contact nodes each; 0 on 1, and 2 on 3.
SolverData twoPairs(double reach, Index blocks)
{
    SolverData data;
    data.pairs.resize(2);
    const Index size = blocks * travelBlock;
    for (Index pair = 0; pair < 2; ++pair) {
        PairData& p = data.pairs[std::size_t(pair)];
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

/// Block k of each surface lies at x = k * spacing.
SearchSchedule arranged(double reach, Index blocks, double spacing)
{
    SearchSchedule schedule(twoPairs(reach, blocks));
    const std::size_t count = std::size_t(4 * blocks * travelBlock);
    SearchSchedule::Positions positions(3 * count);
    for (std::size_t i = 0; i < count; ++i)
        positions[i] = spacing * double(Index(i) / travelBlock % blocks);
    for (const std::size_t pass : {0U, 1U}) schedule.arrange(pass, positions);
    return schedule;
}

/// Ways and speeds of the blocks of contact nodes.
SearchSchedule::Travel travelOf(const std::vector<double>& ways, const std::vector<double>& speeds)
{
    SearchSchedule::Travel out;
    for (std::size_t block = 0; block < ways.size(); ++block) {
        out.push_back(ways[block] * ways[block]);
        out.push_back(speeds[block] * speeds[block]);
    }
    return out;
}

/// "0: all", "1: 0 2" for the passes that are due and their blocks.
std::string due(const SearchSchedule::Plan& plan)
{
    std::ostringstream text;
    for (const SearchSchedule::Due& d : plan.due) {
        text << (text.tellp() > 0 ? ", " : "") << d.pass << ":";
        if (d.blocks.empty()) text << " all";
        for (const Index block : d.blocks) text << " " << block;
    }
    return text.str();
}

const std::vector<double> still(4, 0.0);

TEST(SearchSchedule, WaysOfBothSidesAddUpAndOtherPairsDoNotCount)
{
    SearchSchedule schedule = arranged(1, 1, 0);
    EXPECT_EQ(due(schedule.plan(travelOf({0.5, 0.49, 0, 0}, still), 1, 10)), "");
    const SearchSchedule::Plan plan = schedule.plan(travelOf({0.5, 0.51, 0, 0}, still), 1, 10);
    EXPECT_EQ(due(plan), "0: 0");
    EXPECT_EQ(plan.steps, 10);
}

TEST(SearchSchedule, AWayBeforeTheSearchOfAnotherPairIsNotForgotten)
{
    SearchSchedule schedule = arranged(1, 1, 0);
    EXPECT_EQ(due(schedule.plan(travelOf({2, 0, 0.6, 0}, still), 1, 10)), "0: 0");
    // Positions were remembered then: another 0.5 is 1.1 for the second pair, 0.5 for the first.
    EXPECT_EQ(due(schedule.plan(travelOf({0.5, 0, 0.5, 0}, still), 1, 10)), "1: 0");
    EXPECT_EQ(due(schedule.plan(travelOf({0.4, 0, 0.9, 0}, still), 1, 10)), "");
}

TEST(SearchSchedule, TheComingStepsCountHalfAsFastAgain)
{
    SearchSchedule schedule = arranged(1, 1, 0);
    // 1.5 (0.03 + 0.03) a step: ten steps are 0.9, eleven and a bit the reach.
    EXPECT_EQ(due(schedule.plan(travelOf(still, {0.03, 0.03, 0, 0}), 1, 10)), "");
    EXPECT_EQ(due(schedule.plan(travelOf({0.2, 0, 0, 0}, {0.03, 0.03, 0, 0}), 1, 10)), "0: 0");
    // Faster than ten steps can bear even from a fresh search: fewer, but one at least.
    EXPECT_EQ(schedule.plan(travelOf(still, {0.1, 0.1, 0, 0}), 1, 10).steps, 3);
    EXPECT_EQ(schedule.plan(travelOf(still, {100, 0, 0, 0}), 1, 10).steps, 1);
}

TEST(SearchSchedule, WhatIsFarFromTheMotionDoesNotSearch)
{
    // Three blocks a surface, 100 reaches apart; ways in the order of the surfaces.
    SearchSchedule schedule = arranged(1, 3, 100);
    const std::vector<double> slow(12, 0.0);
    std::vector<double> ways(12, 0.0);
    ways[4] = 1.5; // the middle of the first pair's target
    EXPECT_EQ(due(schedule.plan(travelOf(ways, slow), 1, 10)), "0: 1");
    ways[4] = 0;
    ways[0] = 0.9; // of the first contactors; the middle ones were searched meanwhile
    EXPECT_EQ(due(schedule.plan(travelOf(ways, slow), 1, 10)), "");
    ways[0] = 1.1;
    EXPECT_EQ(due(schedule.plan(travelOf(ways, slow), 1, 10)), "0: 0");
}

TEST(SearchSchedule, WhereSomethingCameFromAfarAllSearchAgain)
{
    SearchSchedule schedule = arranged(1, 3, 100);
    const std::vector<double> slow(12, 0.0);
    std::vector<double> ways(12, 0.0);
    ways[4] = 3;
    EXPECT_EQ(due(schedule.plan(travelOf(ways, slow), 1, 10)), "0: 1");
    EXPECT_EQ(due(schedule.plan(travelOf(ways, slow), 1, 10)), "0: 1");
    // 3 + 3 + 3 is more than the 7 reaches for which is known what is near.
    EXPECT_EQ(due(schedule.plan(travelOf(ways, slow), 1, 10)), "0: all");
}

TEST(SearchSchedule, ThreadsShareBlocksOfContactNodesWhereTheirContactorsMeet)
{
    // Four blocks a surface, the second pair like the first; two threads with two blocks each.
    const std::vector<Index> starts{0, 2};
    const auto text = [&](double spacing) {
        std::string out;
        for (const std::uint8_t shared : arranged(1, 4, spacing).sharedBlocks(0, starts))
            out += shared ? 's' : '-';
        return out;
    };
    EXPECT_EQ(text(100), "--------"); // contactors and, below each of them, the target's nodes
    EXPECT_EQ(text(0), "----ssss");   // all in one place
    // Within 24 reaches: those beside the border of the two threads.
    EXPECT_EQ(text(15), "-----ss-");
}

TEST(SearchSchedule, CornersOfALargeFaceAreNearWhateverIsOverIt)
{
    // One face as wide as 100 reaches whose corners lie in two blocks of contact nodes, and a block
    // of contactors over its middle.
    SolverData data;
    data.pairs.resize(1);
    PairData& pair = data.pairs[0];
    pair.reach = 1;
    pair.nodeCount = 2 * travelBlock;
    for (Index i = 0; i < pair.nodeCount; ++i) pair.contactor.push_back(i);
    pair.faceNode = {2 * travelBlock, 2 * travelBlock + 1, 3 * travelBlock, 3 * travelBlock + 1};
    const std::size_t count = std::size_t(4 * travelBlock);
    numberNodes(data, 4 * travelBlock);
    SearchSchedule::Positions positions(3 * count);
    for (std::size_t i = 0; i < std::size_t(2 * travelBlock); ++i) positions[i] = 50;
    positions[std::size_t(3 * travelBlock)] = positions[std::size_t(3 * travelBlock) + 1] = 100;
    SearchSchedule schedule(data);
    schedule.arrange(0, positions);
    EXPECT_EQ(due(schedule.plan(travelOf({0, 0, 0, 1.1}, still), 1, 10)), "0: 0 1");
    const std::vector<std::uint8_t> shared = schedule.sharedBlocks(0, {0, 1});
    EXPECT_EQ(shared, (std::vector<std::uint8_t>{0, 0, 1, 1}));
}

} // namespace
} // namespace fpm
