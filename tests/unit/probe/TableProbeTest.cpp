#include "probe/TableProbe.h"

#include "base/Error.h"
#include "support/boxMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace fpm;
using Kind = TableSpec::Kind;

namespace {

/// Two elements in a row along x, nodes of the end x = 2 in a side set.
Mesh bar()
{
    Mesh mesh;
    test::addBox(mesh, "bar", {2, 1, 1}, {0, 0, 0}, {2, 1, 1});
    mesh.sideSets["end"] = {{1, 1}};
    mesh.nodeSets["corner"] = {0};
    return mesh;
}

/// U = (x, 0, time), PEEQ = element number + time.
Frame frameAt(const Mesh& mesh, double time)
{
    Frame frame;
    frame.time = time;
    ResultField displacement{"U", 3, {}};
    for (const Point& point : mesh.points)
        displacement.values.insert(displacement.values.end(), {point[0], 0, time});
    frame.nodeFields = {displacement};
    frame.elementFields = {{"PEEQ", 1, {0 + time, 1 + time}}};
    return frame;
}

Table tableOf(const TableSpec& spec)
{
    const Mesh mesh = bar();
    TableProbe probe(spec, mesh);
    probe.sample(frameAt(mesh, 0));
    probe.sample(frameAt(mesh, 10));
    return probe.table();
}

} // namespace

TEST(TableProbe, FollowsTheNodeNearestToAPoint)
{
    TableSpec spec{"tip", Kind::point, {"U", ""}, "bar", "", {5, 0, 0}, {}};

    const Table table = tableOf(spec);

    EXPECT_EQ(table.columns, (std::vector<std::string>{"time", "U_x", "U_y", "U_z"}));
    EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0, 2, 0, 0}, {10, 2, 0, 10}}));
}

TEST(TableProbe, AProfileIsTheLastFrameInTheOrderOfItsAxis)
{
    TableSpec spec{"profile", Kind::profile, {"U", ""}, "", "end", {}, {}};
    spec.axis = 1;

    const Table table = tableOf(spec);

    EXPECT_EQ(table.columns, (std::vector<std::string>{"x", "y", "z", "U_x", "U_y", "U_z"}));
    ASSERT_EQ(table.rows.size(), 4);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(table.rows[i][0], 2);
        EXPECT_EQ(table.rows[i][1], i < 2 ? 0 : 1);
        EXPECT_EQ(table.rows[i][3], 2);
        EXPECT_EQ(table.rows[i][5], 10);
    }
}

TEST(TableProbe, FollowsTheElementNearestToAPointForElementFields)
{
    const Table table = tableOf({"tip", Kind::point, {"PEEQ", ""}, "", "", {5, 0, 0}, {}});

    EXPECT_EQ(table.columns, (std::vector<std::string>{"time", "PEEQ"}));
    EXPECT_EQ(table.rows[1], (std::vector<double>{10, 11}));
}

TEST(TableProbe, TakesMeanSumAndLimitsOverASet)
{
    TableSpec spec{"s", Kind::section, {"U", ""}, "", "end", {}, TableSpec::Operation::mean};
    EXPECT_EQ(tableOf(spec).rows[1], (std::vector<double>{10, 2, 0, 10}));
    spec.operation = TableSpec::Operation::sum;
    EXPECT_EQ(tableOf(spec).rows[1], (std::vector<double>{10, 8, 0, 40}));
    spec.field.field = "PEEQ";
    spec.operation = TableSpec::Operation::max;
    EXPECT_EQ(tableOf(spec).rows[1], (std::vector<double>{10, 11}));
}

TEST(TableProbe, SumsOverAPart)
{
    EXPECT_EQ(tableOf({"s", Kind::sum, {"U", ""}, "bar", "", {}, {}}).rows[1],
              (std::vector<double>{10, 12, 0, 120}));
}

TEST(TableProbe, TellsWhereTheExtremesAre)
{
    const Table table = tableOf({"e", Kind::extrema, {"PEEQ", ""}, "", "", {}, {}});

    EXPECT_EQ(table.columns.size(), 9u);
    EXPECT_EQ(table.rows[0], (std::vector<double>{0, 0, 0.5, 0.5, 0.5, 1, 1.5, 0.5, 0.5}));
}

/// NaN: a node without a target within reach has no gap.
TEST(TableProbe, LeavesOutWhereAFieldHasNoValue)
{
    const Mesh mesh = bar();
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto rowOf = [&](const TableSpec& spec, const std::vector<double>& values) {
        Frame frame;
        frame.elementFields = {{"GAP", 1, values}};
        TableProbe probe(spec, mesh);
        probe.sample(frame);
        return probe.table().rows[0];
    };
    TableSpec section{"s", Kind::section, {"GAP", ""}, "", "end", {}, {}};
    const TableSpec extrema{"e", Kind::extrema, {"GAP", ""}, "", "", {}, {}},
        sum{"s", Kind::sum, {"GAP", ""}, "", "", {}, {}};
    EXPECT_EQ(rowOf(extrema, {none, -2}),
              (std::vector<double>{0, -2, 1.5, 0.5, 0.5, -2, 1.5, 0.5, 0.5}));
    EXPECT_EQ(rowOf(sum, {none, -2})[1], -2);
    for (const auto operation :
         {TableSpec::Operation::min, TableSpec::Operation::max, TableSpec::Operation::mean}) {
        section.operation = operation;
        EXPECT_TRUE(std::isnan(rowOf(section, {-2, none})[1])); // the set has element 1 alone
    }
    EXPECT_TRUE(std::isnan(rowOf(extrema, {none, none})[1]));
}

TEST(TableProbe, RefusesUnknownNamesWithThoseThereAre)
{
    const Mesh mesh = bar();
    try {
        TableProbe probe({"s", Kind::section, {"U", ""}, "", "ends", {}, {}}, mesh);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "the mesh has no set 'ends'");
        EXPECT_EQ(error.advice(), "there are: end corner");
    }
    EXPECT_THROW(TableProbe({"s", Kind::sum, {"U", ""}, "rod", "", {}, {}}, mesh), Error);
}

TEST(TableProbe, RefusesAnElementFieldOnANodeSet)
{
    EXPECT_THROW(tableOf({"s", Kind::section, {"PEEQ", ""}, "", "corner", {}, {}}), Error);
}
