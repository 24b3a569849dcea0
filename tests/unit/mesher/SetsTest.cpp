#include "mesh/Surface.h"
#include "unit/mesher/mesherCase.h"

#include <gtest/gtest.h>

namespace fpm::test {

namespace {

Mesh meshWithSets(const std::string& sets)
{
    return meshOf(
        "bodies { plate { type layers; origin (0 0 0); size (10 10 2); cells (5 5 1); "
        "count 2; } rod { type box; origin (0 0 2); size (1 1 4); cells (1 1 4); } } sets { "
        + sets + " }");
}

} // namespace

TEST(Sets, PlaneTakesOuterSidesOfTheNamedBodies)
{
    const Mesh mesh = meshWithSets(
        "all { type plane; point (0 0 0); normal (2 0 0); } "
        "stack { type plane; point (0 3 3); normal (1 0 0); bodies (plate); } "
        "one { type plane; point (0 0 0); normal (-1 0 0); bodies plate2; tolerance 1e-9; }");

    EXPECT_EQ(mesh.sideSets.at("all").size(), 14u);
    EXPECT_EQ(mesh.sideSets.at("stack").size(), 10u);
    EXPECT_EQ(mesh.sideSets.at("one"), mesh.sideSets.at("plate2.xMin"));
}

TEST(Sets, PlaneBetweenTouchingLayersTakesBothSides)
{
    const Mesh mesh = meshWithSets("gap { type plane; point (0 0 1); normal (0 0 1); }");

    EXPECT_EQ(mesh.sideSets.at("gap").size(), 50u);
}

TEST(Sets, BoxTakesSidesByTheirCentres)
{
    const Mesh mesh =
        meshWithSets("patch { type box; min (0 0 1.9); max (4.5 2.5 2.1); bodies (plate2); }");

    EXPECT_EQ(mesh.sideSets.at("patch").size(), 2u);
    for (const auto& side : mesh.sideSets.at("patch")) EXPECT_EQ(centre(mesh, side)[2], 2);
}

TEST(Sets, UnionMayNameSetsWrittenLater)
{
    const Mesh mesh = meshWithSets("all { type union; sets (later plate1.xMin); } "
                                   "later { type union; sets (plate2.xMin plate2.yMin); }");

    EXPECT_EQ(mesh.sideSets.at("all").size(), 15u);
}

TEST(Sets, UnionWithANodeSetIsANodeSet)
{
    const Mesh mesh = meshWithSets("tip { type point; position (0 0 6); body rod; } "
                                   "both { type union; sets (rod.zMin tip); }");

    EXPECT_EQ(mesh.nodeSets.at("both").size(), 5u);
    EXPECT_EQ(mesh.sideSets.count("both"), 0u);
}

TEST(Sets, PointIsTheNearestNodeOfItsBody)
{
    const Mesh mesh = meshWithSets("rodTip { type point; position (0 0 2); body rod; } "
                                   "under { type point; position (0 0 2); body plate; }");

    const Index tip = mesh.nodeSets.at("rodTip").at(0), under = mesh.nodeSets.at("under").at(0);
    EXPECT_EQ(mesh.points[tip], (Point{0, 0, 2}));
    EXPECT_EQ(mesh.points[under], (Point{0, 0, 2}));
    EXPECT_NE(tip, under);
    const auto nodes = partNodes(mesh, "rod");
    EXPECT_TRUE(std::binary_search(nodes.begin(), nodes.end(), tip));
}

} // namespace fpm::test
