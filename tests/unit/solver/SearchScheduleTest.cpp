#include "solver/SearchSchedule.h"

#include "kernels/contact/Travel.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

/// Four bodies of one block of contact nodes each, 0 on 1 and 2 on 3.
SolverData twoPairs(double reach)
{
    SolverData data;
    data.pairs.resize(2);
    for (Index pair = 0; pair < 2; ++pair) {
        PairData& p = data.pairs[std::size_t(pair)];
        p.reach = reach;
        p.contactorNumber = {2 * pair * travelBlock, 2 * pair * travelBlock + 7};
        p.faceNumber = {(2 * pair + 1) * travelBlock + 3};
    }
    return data;
}

/// Ways and speeds of the four blocks.
SearchSchedule::Travel travelOf(const std::vector<double>& ways, const std::vector<double>& speeds)
{
    SearchSchedule::Travel out;
    for (std::size_t block = 0; block < ways.size(); ++block) {
        out.push_back(ways[block] * ways[block]);
        out.push_back(speeds[block] * speeds[block]);
    }
    return out;
}

using Due = std::vector<std::size_t>;

TEST(SearchSchedule, WaysOfBothSidesAddUpAndOtherPairsDoNotCount)
{
    SearchSchedule schedule(twoPairs(1));
    EXPECT_EQ(schedule.plan(travelOf({0.5, 0.49, 0, 0}, {0, 0, 0, 0}), 1, 10).due, Due{});
    const SearchSchedule::Plan plan =
        schedule.plan(travelOf({0.5, 0.51, 0, 0}, {0, 0, 0, 0}), 1, 10);
    EXPECT_EQ(plan.due, Due{0});
    EXPECT_EQ(plan.steps, 10);
}

TEST(SearchSchedule, AWayBeforeTheSearchOfAnotherPairIsNotForgotten)
{
    SearchSchedule schedule(twoPairs(1));
    const std::vector<double> still(4, 0.0);
    EXPECT_EQ(schedule.plan(travelOf({2, 0, 0.6, 0}, still), 1, 10).due, Due{0});
    // Positions were remembered then: another 0.5 is 1.1 for the second pair, 0.5 for the first.
    EXPECT_EQ(schedule.plan(travelOf({0.5, 0, 0.5, 0}, still), 1, 10).due, Due{1});
    schedule.restart();
    EXPECT_EQ(schedule.plan(travelOf({0.5, 0, 0.5, 0}, still), 1, 10).due, Due{});
}

TEST(SearchSchedule, TheComingStepsCountHalfAsFastAgain)
{
    SearchSchedule schedule(twoPairs(1));
    const std::vector<double> none(4, 0.0);
    // 1.5 (0.03 + 0.03) a step: ten steps are 0.9, eleven and a bit the reach.
    EXPECT_EQ(schedule.plan(travelOf(none, {0.03, 0.03, 0, 0}), 1, 10).due, Due{});
    EXPECT_EQ(schedule.plan(travelOf({0.2, 0, 0, 0}, {0.03, 0.03, 0, 0}), 1, 10).due, Due{0});
    // Faster than ten steps can bear even from a fresh search: fewer, but one at least.
    EXPECT_EQ(schedule.plan(travelOf(none, {0.1, 0.1, 0, 0}), 1, 10).steps, 3);
    EXPECT_EQ(schedule.plan(travelOf(none, {100, 0, 0, 0}), 1, 10).steps, 1);
}

} // namespace
} // namespace fpm
