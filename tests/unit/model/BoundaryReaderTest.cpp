#include "model/BoundaryReader.h"

#include "unit/model/BoxMesh.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

Mesh oneBlock()
{
    Mesh mesh = test::boxMesh({{"block", {0, 0, 0}, {1, 1, 1}}});
    mesh.nodeSets["tip"] = {7}; // corner (1 1 1)
    return mesh;
}

BoundaryCondition readOne(const std::string& entries)
{
    return readBoundaryConditions(Dictionary::parse("one { " + entries + " }"), oneBlock()).front();
}

std::string refusalOf(const std::string& entries)
{
    return refusal([&] { readOne(entries); });
}

} // namespace

TEST(BoundaryReader, FindsNodesBySideSetNodeSetAndPart)
{
    EXPECT_EQ(readOne("type fixed; set block.xMax;").nodes, (std::vector<Index>{1, 3, 5, 7}));
    EXPECT_EQ(readOne("type fixed; set tip;").nodes, (std::vector<Index>{7}));
    EXPECT_EQ(readOne("type fixed; part block;").nodes.size(), 8u);
}

TEST(BoundaryReader, HoldsAllComponentsUnlessSomeAreListed)
{
    EXPECT_EQ(readOne("type fixed; set tip;").constrains, (std::array{true, true, true}));
    EXPECT_EQ(readOne("type fixed; set tip; components (x z);").constrains,
              (std::array{true, false, true}));
}

TEST(BoundaryReader, ReadsSymmetryAsItsNormalHeld)
{
    const BoundaryCondition condition = readOne("type symmetry; set block.yMin; normal y;");

    EXPECT_EQ(condition.kind, BoundaryCondition::Kind::fixed);
    EXPECT_EQ(condition.constrains, (std::array{false, true, false}));
}

TEST(BoundaryReader, RefusesAValueOutsideItsComponents)
{
    EXPECT_TRUE(contains(refusalOf("type velocity; set tip; value (1 0 5); components (z);"),
                         "component x has the value 1 but is not in 'components'"));
}

TEST(BoundaryReader, RefusesASetTheMeshDoesNotHave)
{
    const std::string text = refusalOf("type fixed; set block.xMaxx;");

    EXPECT_TRUE(contains(text, "the mesh has no set 'block.xMaxx'"));
    EXPECT_TRUE(contains(text, "did you mean 'block.xMax'?"));
}

TEST(BoundaryReader, RefusesAnEntryThatNamesNoNodesOrNamesThemTwice)
{
    EXPECT_TRUE(contains(refusalOf("type fixed;"), "no nodes are named"));
    EXPECT_TRUE(contains(refusalOf("type fixed; set tip; part block;"), "both 'set' and 'part'"));
}

TEST(BoundaryReader, RefusesADisplacementThatJumps)
{
    EXPECT_TRUE(contains(refusalOf("type displacement; set tip; value (0 0 2);"),
                         "would jump by 2 at time 0"));
}

TEST(BoundaryReader, RefusesTwoInitialVelocitiesOfANode)
{
    const auto dictionary = Dictionary::parse("a { type velocity; part block; value (0 0 1); }"
                                              "b { type velocity; set tip; value (0 0 2); }");

    EXPECT_TRUE(contains(refusal([&] { readInitialVelocities(dictionary, oneBlock()); }),
                         "node 7 already has another velocity from 'a'"));
}

TEST(BoundaryReader, ReadsANormalOrAxesOfAnyDirection)
{
    const BoundaryCondition plane = readOne("type symmetry; set block.xMin; normal (3 0 4);");
    EXPECT_EQ(plane.constrains, (std::array{true, false, false}));
    EXPECT_NEAR(plane.axes[0][0], 0.6, 1e-15);
    EXPECT_NEAR(plane.axes[0][2], 0.8, 1e-15);
    EXPECT_TRUE(readOne("type symmetry; set block.xMin; normal (0 -2 0);").isGlobal());

    const BoundaryCondition pull = readOne("type velocity; set tip; value (5 0 0); components (x);"
                                           "axes ((0 0 2) (0 -1 0));");
    EXPECT_EQ(pull.globalValue(), (Point{0, 0, 5}));
    EXPECT_EQ(pull.axes[2], (Point{1, 0, 0}));
}

TEST(BoundaryReader, RefusesAxesThatAreNone)
{
    EXPECT_TRUE(contains(refusalOf("type fixed; set tip; axes ((1 0 0) (1 1 0));"),
                         "the two directions are not perpendicular"));
    EXPECT_TRUE(contains(refusalOf("type fixed; set tip; axes ((1 0 0));"),
                         "'axes' has 1 directions, not 2"));
    EXPECT_TRUE(contains(refusalOf("type symmetry; set tip; normal (0 0 0);"),
                         "a direction of 'normal' has no length"));
}

TEST(BoundaryReader, ReadsLoadsOnSidesAndParts)
{
    const BoundaryCondition blast = readOne("type pressure; set block.zMax; value 3;");
    EXPECT_EQ(blast.sides.size(), 1u);
    EXPECT_EQ(blast.value[0], 3);
    EXPECT_EQ(readOne("type traction; set block.zMax; value (1 2 3);").nodes.size(), 4u);
    EXPECT_EQ(readOne("type force; set block.zMax; value (1 2 3); distribution area;").sides.size(),
              1u);
    EXPECT_EQ(readOne("type gravity; value (0 0 -9.81);").parts, (std::vector<Index>{0}));

    EXPECT_TRUE(contains(refusalOf("type pressure; set tip; value 3;"),
                         "'tip' is a set of nodes: it has no area"));
    EXPECT_TRUE(contains(refusalOf("type gravity; parts (blok); value (0 0 -9.81);"),
                         "the mesh has no part 'blok'"));
}

TEST(BoundaryReader, RefusesARotationThatJumpsOrHasNoAxis)
{
    const std::string turn = "type rotation; part block; centre (0 0 0); angle 30; ";
    EXPECT_TRUE(
        contains(refusalOf(turn + "axis (0 0 1);"), "the rotation would jump by 30 at time 0"));
    EXPECT_TRUE(contains(refusalOf(turn + "axis (0 0 0);"), "a direction of 'axis' has no length"));
    const BoundaryCondition read = readOne(turn + "axis (0 0 5); amplitude smooth ((0 0) (1 1));");
    EXPECT_EQ(read.line[1], (Point{0, 0, 1}));
}

TEST(BoundaryReader, AddsAnInitialRotationToAVelocity)
{
    const auto read = readInitialVelocities(
        Dictionary::parse("a { type velocity; part block; value (0 0 1); }"
                          "b { type rotation; part block; axis (0 0 2); centre (1 0 0);"
                          "angularVelocity 10; }"),
        oneBlock());
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[1].at({1, 2, 5}), (Point{-20, 0, 0}));
}

namespace {

/// Two elements of two parts, one on the other, that share the nodes between them.
Mesh glued()
{
    Mesh mesh = test::boxMesh({{"lower", {0, 0, 0}, {1, 1, 2}, {1, 1, 2}}});
    mesh.parts = {{"lower", 0, 1}, {"upper", 1, 1}};
    mesh.sideSets["interface"] = {{0, 5}};
    return mesh;
}

} // namespace

TEST(BoundaryReader, RefusesPressureAndTractionInsideTheMaterial)
{
    const auto refused = [](const std::string& entries) {
        return refusal([&] {
            readBoundaryConditions(Dictionary::parse("p { " + entries + " }", "boundary"), glued());
        });
    };
    EXPECT_EQ(
        refused("type pressure; set interface; value 100;"),
        "1 of 1 sides lie inside the material, such as that at (0.5 0.5 1): elements on both "
        "sides of it share its nodes, so it is no surface for a pressure\n"
        "  --> boundary:1:24, in p\n"
        "   |\n"
        " 1 | p { type pressure; set interface; value 100; }\n"
        "   |                        ^^^^^^^^^\n"
        "   = name a set on the outside; or, if two bodies shall meet there, give each nodes of "
        "its own when the mesh is made (in gmsh: no fragments, no merging of the interface)\n");
    EXPECT_TRUE(contains(refused("type traction; set interface; value (1 0 0);"), "a traction"));
    // A total force does not ask for a side of it.
    EXPECT_NO_THROW(readBoundaryConditions(
        Dictionary::parse("p { type force; set interface; value (1 0 0); distribution area; }"
                          "q { type pressure; set lower.zMin; value 1; }"),
        glued()));
}
