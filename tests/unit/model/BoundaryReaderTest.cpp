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
