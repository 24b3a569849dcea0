#include "dictionary/Dictionary.h"
#include "io/RunMark.h"
#include "run/BodyOverlap.h"
#include "run/EnergyHealth.h"
#include "run/HealthLimits.h"
#include "run/HealthTable.h"
#include "run/RigidShare.h"
#include "run/Sliding.h"
#include "support/TemporaryFolder.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// A part a kind of hourglass control, in a ledger whose largest energy is 100.
class EnergyHealthTest : public testing::Test
{
protected:
    EnergyHealthTest()
    {
        for (const HourglassForm form : {HourglassForm::stiffness, HourglassForm::physical})
            model_.parts.push_back(aluminium(PartKind::elastic, form, "part"));
        row_.scale = 100;
        row_.parts.resize(2);
        row_.internal = 100;
    }
    std::vector<std::string> found(std::initializer_list<Energies> rows)
    {
        EnergyHealth health(model_);
        for (const Energies& row : rows) health.sample(row, true);
        HealthRows all;
        health.addRows(all);
        std::vector<std::string> names;
        for (const HealthRow& row : all)
            if (row.finding) names.push_back(row.figure);
        return names;
    }
    using Names = std::vector<std::string>;

    Model model_;
    Energies row_;
};

TEST_F(EnergyHealthTest, HourglassEnergyIsJudgedPartByPart)
{
    row_.parts[0] = {.internal = 50, .plastic = 0, .hourglass = 4.9};
    row_.parts[1] = {.internal = 50, .plastic = 30, .hourglass = 0};
    EXPECT_EQ(found({row_}), Names{});
    row_.parts[0].hourglass = 5.1;
    EXPECT_EQ(found({row_}), Names{"hourglass / internal energy"});
    // Of a part that holds hardly anything of the run's energy nobody wants to know.
    row_.parts[0] = {.internal = 1, .plastic = 0, .hourglass = 0.9};
    EXPECT_EQ(found({row_}), Names{});
}

TEST_F(EnergyHealthTest, TheLargestInternalEnergyOfTheRunIsTheMeasure)
{
    // Before a wave has come to it a part holds rounding, of which any share may be hourglass.
    Energies early = row_, late = row_;
    early.parts[0] = {.internal = 1, .plastic = 0, .hourglass = 2};
    late.parts[0] = {.internal = 50, .plastic = 0, .hourglass = 2};
    EXPECT_EQ(found({early, late}), Names{});
}

TEST_F(EnergyHealthTest, BalanceAndContactSprings)
{
    model_.contactPairs.emplace_back();
    row_.balance = -0.009;
    row_.contact = 19;
    EXPECT_EQ(found({row_}), Names{});
    row_.balance = -0.02;
    row_.contact = 21;
    EXPECT_EQ(found({row_}),
              (Names{"energy balance error", "energy in contact springs / internal energy"}));
}

ContactPair rough()
{
    ContactPair pair;
    pair.friction = 0.3;
    return pair;
}

/// 1000 rows of a pair pressed by 10, friction as a function of the row.
template <class Force, class Slip>
Sliding slid(const Force& force, const Slip& slip)
{
    Sliding sliding;
    for (int row = 0; row < 1000; ++row) {
        PairStatus status;
        status.active = 4;
        status.normal = 10;
        status.meanDepth = 1e-4;
        status.friction = {force(row), 0, 0};
        status.slip = {slip(row), 0, 0};
        status.speed = std::abs(slip(row));
        sliding.sample(1e-3 * row, status, rough());
    }
    return sliding;
}

TEST(Sliding, DeliversWhatItsForcesDo)
{
    const auto steady = [](int) { return 1.0; };
    const Sliding smooth = slid([](int) { return -3.0; }, steady);
    ASSERT_TRUE(smooth.isJudged());
    EXPECT_NEAR(smooth.ratio(), 1, 1e-12);
    const Sliding chatters = slid([](int row) { return row % 2 ? -3.0 : -2.0; }, steady);
    EXPECT_NEAR(chatters.ratio(), 2.5 / 3, 0.01);
}

TEST(Sliding, WhatSticksOrRocksIsNotJudged)
{
    const auto rocks = [](int row) { return row % 4 < 2 ? 1e-3 : -1e-3; };
    EXPECT_FALSE(slid([](int) { return -1.0; }, rocks).isJudged());
    EXPECT_FALSE(slid([](int) { return -1.0; }, [](int) { return 0.0; }).isJudged());
}

TEST(RigidShare, OfRigidMotionIsAllAndOfStretchingNothing)
{
    std::vector<Point> places, rigid, stretches;
    for (int i = 0; i < 8; ++i) {
        const Point x{i & 1 ? 1.0 : -1.0, i & 2 ? 2.0 : -2.0, i & 4 ? 3.0 : -3.0};
        places.push_back({x[0] + 7, x[1], x[2]});
        rigid.push_back({5 - 0.3 * x[1], 0.3 * x[0] - 0.2 * x[2], 1 + 0.2 * x[1]});
        stretches.push_back({x[0], -x[1], 0});
    }
    const std::vector<double> masses(8, 2.0);
    const RigidShare all = rigidShare(places, rigid, masses);
    EXPECT_NEAR(all.rigid, all.kinetic, 1e-12 * all.kinetic);
    const RigidShare none = rigidShare(places, stretches, masses);
    EXPECT_NEAR(none.rigid, 0, 1e-12 * none.kinetic);
}

TEST(BodyOverlap, CountsNodesInsideAndNotThoseThatTouch)
{
    Mesh mesh;
    addBox(mesh, "a", {3, 3, 3}, {0, 0, 0}, {3, 3, 3});
    addBox(mesh, "b", {2, 2, 2}, {3, 0, 0}, {5, 2, 2});
    const std::vector<Index> nodes = nodesOfPart(mesh, "b");
    EXPECT_EQ(overlapOf(mesh, mesh.points, nodes, {0}).count, 0u);
    std::vector<Point> moved = mesh.points;
    for (const Index node : nodes) moved[std::size_t(node)][0] -= 0.5;
    for (const Index node : nodes)
        for (std::size_t c = 1; c < 3; ++c) moved[std::size_t(node)][c] += 0.5;
    EXPECT_EQ(overlapOf(mesh, moved, nodes, {0}).count, 9u); // the face x = 2.5
}

TEST(HealthTable, IsParseableAndSaysTheVerdict)
{
    const HealthRows rows{{"figure a", 0.25, 0.1, "part a, (1 2 3)", 2e-3, true, "do this"},
                          {"figure b", 3, 0, "", -1, false, ""}};
    EXPECT_EQ(healthVerdict(rows), "finished, 1 finding");
    EXPECT_EQ(healthVerdict({rows[1]}), "finished, healthy");
    EXPECT_EQ(healthStatus(rows), "findings 1;\nhealth (\"figure a, part a, (1 2 3)\");\n");
    EXPECT_EQ(healthStatus({rows[1]}), "findings 0;\nhealth ();\n");
    const std::vector<std::string> lines = healthLines(rows);
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_NE(lines[1].find("FINDING part a, (1 2 3), time 0.002"), std::string::npos);
    EXPECT_EQ(lines[2], "    = do this");
    const TemporaryFolder folder;
    writeHealth(OutputFolder(folder.path()), "run1", rows);
    const auto file = folder / "postProcessing/health/0/health";
    EXPECT_EQ(markOf(file)->runId, "run1");
    const Dictionary record = Dictionary::read(file, folder.path());
    EXPECT_EQ(record.word("runId"), "run1");
    EXPECT_EQ(record.integer("findings", 0, 9), 1);
    const std::vector<Dictionary> figures = record.subList("figures");
    ASSERT_EQ(figures.size(), 2u);
    EXPECT_EQ(figures[0].word("figure"), "figure a");
    EXPECT_EQ(figures[0].number("value"), 0.25);
    EXPECT_EQ(figures[0].number("limit"), 0.1);
    EXPECT_EQ(figures[0].number("time"), 2e-3);
    EXPECT_EQ(figures[0].word("verdict"), "finding");
    EXPECT_EQ(figures[0].word("where"), "part a, (1 2 3)");
    EXPECT_EQ(figures[0].word("advice"), "do this");
    EXPECT_EQ(figures[1].word("verdict"), "ok");
    EXPECT_EQ(figures[1].keys(), (std::vector<std::string>{"figure", "value", "verdict"}));
}

} // namespace
} // namespace fpm::test
