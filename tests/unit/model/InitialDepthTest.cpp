#include "model/InitialDepth.h"

#include "mesh/Surface.h"
#include "model/ContactSetup.h"
#include "model/readModel.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

/// A block of side 4 that starts `depth` deep in the middle of a plate of 10 x 10 x 1.
Mesh blockInPlate(double depth, Index layers = 1, Index fineness = 3)
{
    return test::boxMesh(
        {{"plate", {0, 0, 0}, {10, 10, 1}, {5, 5, layers}},
         {"block", {2.5, 2.5, 1 - depth}, {4, 4, 4}, {fineness, fineness, fineness}}});
}

ContactSurfaces surfacesOf(const Mesh& mesh, Index contactor, Index target)
{
    ContactSurfaces surfaces{"press", {}, skin(mesh, contactor), skin(mesh, target)};
    surfaces.contactorNodes = nodesOf(mesh, surfaces.contactorSides);
    return surfaces;
}

InitialDepths depthsOf(const Mesh& mesh)
{
    return initialDepths(mesh, surfacesOf(mesh, 1, 0));
}

const char* const press = "pairs { press { contactor block; target plate; } }";

struct Workshop {
    test::CaseFolder folder;
    Log log = Log::quiet();

    explicit Workshop(const std::string& contactDict)
    {
        folder.write("system/contactDict", contactDict);
        folder.write("constant/partProperties",
                     "parts { plate { model elastic; density 7.85e-9; youngsModulus 210000; "
                     "poissonsRatio 0.3; } block { like plate; } }");
    }
    void setUp(Mesh mesh)
    {
        setContact(mesh, folder.open().dictionary("system/contactDict"), folder.open(), log);
        folder.write(mesh);
    }
    void run() { readModel(folder.open(), log); }
};

} // namespace

TEST(InitialDepth, NodesDownToHalfTheThicknessOfTheirElementAreHeld)
{
    for (const double depth : {0.01, 0.3, 0.49}) {
        const InitialDepths depths = depthsOf(blockInPlate(depth));
        ASSERT_EQ(depths.held.size(), 16u) << depth;
        for (const InitialDepths::Node& node : depths.held) {
            EXPECT_NEAR(node.depth, depth, 1e-12);
            EXPECT_NEAR(node.limit, 0.5, 1e-12);
            EXPECT_NEAR(node.surface[2], 1, 1e-12);
        }
        EXPECT_TRUE(depths.tooDeep.empty() && depths.astray.empty());
    }
}

TEST(InitialDepth, DeeperNodesAreTooDeepAlsoWhereTheOtherSideIsNearer)
{
    for (const double depth : {0.5, 0.6, 0.95}) {
        const InitialDepths depths = depthsOf(blockInPlate(depth));
        EXPECT_TRUE(depths.held.empty());
        ASSERT_EQ(depths.tooDeep.size(), 16u) << depth;
        for (const InitialDepths::Node& node : depths.tooDeep)
            EXPECT_NEAR(node.depth, depth, 1e-12);
    }
}

TEST(InitialDepth, TheElementUnderTheFaceCountsNotThePlate)
{
    // Layers of 0.25: held down to 0.125.
    EXPECT_EQ(depthsOf(blockInPlate(0.1, 4)).held.size(), 16u);
    EXPECT_EQ(depthsOf(blockInPlate(0.3, 4)).tooDeep.size(), 16u);
}

TEST(InitialDepth, SidesOfABodyThatIsHeldByItsEndAreNoFault)
{
    // Elements of 0.1: nodes of the block's sides lie in the plate with their normals along it;
    // those of its end hold it. The second block stands out over an edge of the plate.
    Mesh mesh = test::boxMesh({{"plate", {0, 0, 0}, {10, 10, 1}, {5, 5, 1}},
                               {"block", {2.5, 2.5, 0.7}, {1, 1, 1}, {10, 10, 10}}});
    InitialDepths depths = depthsOf(mesh);
    EXPECT_EQ(depths.held.size(), 121u);
    EXPECT_TRUE(depths.tooDeep.empty());
    EXPECT_EQ(depths.astray.size(), 2 * 40u);

    mesh = test::boxMesh({{"plate", {0, 0, 0}, {10, 10, 1}, {5, 5, 1}},
                          {"block", {9.05, 2.5, 0.7}, {2, 1, 1}, {20, 10, 10}}});
    depths = depthsOf(mesh);
    EXPECT_FALSE(depths.held.empty());
    EXPECT_TRUE(depths.tooDeep.empty());
}

TEST(InitialDepth, ABodyInsideAsAWholeIsTooDeep)
{
    const Mesh mesh = test::boxMesh({{"plate", {0, 0, 0}, {10, 10, 1}, {5, 5, 1}},
                                     {"sheet", {2.5, 2.5, 0.45}, {4, 4, 0.05}, {3, 3, 1}}});
    const InitialDepths depths = depthsOf(mesh);
    EXPECT_EQ(depths.tooDeep.size() + depths.held.size(), 32u);
    EXPECT_EQ(depths.tooDeep.size(), 32u); // 0.55 under the face below, and 0.5 under that above
}

TEST(InitialDepth, BodiesThatTouchOrSitInAFittingHoleHaveNone)
{
    EXPECT_TRUE(depthsOf(blockInPlate(0)).none());
    EXPECT_TRUE(depthsOf(blockInPlate(-0.5)).none());
    // Four walls around a pin of their own size.
    const Mesh mesh = test::boxMesh(
        {{"wall", {1, 0, 0}, {1, 3, 1}, {1, 3, 1}}, {"pin", {0, 0, 0}, {1, 3, 1}, {2, 4, 3}}});
    EXPECT_TRUE(depthsOf(mesh).none());
}

TEST(InitialDepth, SetUpRefusesThemWithPairNodeDepthAndLimit)
{
    Workshop shop(press);
    const std::string text = refusal([&] { shop.setUp(blockInPlate(0.6)); });
    EXPECT_TRUE(contains(
        text, "pair press: 16 contactor nodes start too deep inside the target to be held, such as "
              "node 72 at (2.5 2.5 0.4): it lies 0.6 deep, and contact finds a node down to 0.5, "
              "half the thickness of the target's element there\n"
              "  --> system/contactDict:1:41, in pairs.press"));
    EXPECT_TRUE(contains(text, "move the bodies apart"));
    EXPECT_NO_THROW(shop.setUp(blockInPlate(0.4)));
}

TEST(InitialDepth, ForgivenOverlapsAreNoDeeper)
{
    for (const char* option : {"offset", "ramp; rampTime 1e-6"}) {
        Workshop shop("pairs { press { contactor block; target plate; initialOverlap "
                      + std::string(option) + "; } }");
        EXPECT_TRUE(contains(refusal([&] { shop.setUp(blockInPlate(0.6)); }), "too deep"));
    }
    Workshop moved("pairs { press { contactor block; target plate; initialOverlap move; } }");
    EXPECT_NO_THROW(moved.setUp(blockInPlate(0.6)));
    EXPECT_NO_THROW(moved.run());
}

TEST(InitialDepth, BothSidesOfTwoPassesCount)
{
    // The plate's nodes are deeper in the block's thin elements than these hold.
    Workshop shop("pairs { press { contactor block; target plate; passes two; } }");
    EXPECT_TRUE(
        contains(refusal([&] { shop.setUp(blockInPlate(0.45, 1, 8)); }), "4 contactor nodes"));
    Workshop one("pairs { press { contactor block; target plate; } }");
    EXPECT_NO_THROW(one.setUp(blockInPlate(0.45, 1, 8)));
}

TEST(InitialDepth, TheRunRefusesThemWhereTheSurfacesAreNotMadeAnew)
{
    // `passes` is no part of the recipe of surfaces; nor is, for general contact, what is rigid.
    Workshop shop("pairs { press { contactor block; target plate; } }");
    shop.setUp(blockInPlate(0.45, 1, 8));
    EXPECT_NO_THROW(shop.run());
    shop.folder.write("system/contactDict",
                      "pairs { press { contactor block; target plate; passes two; } }");
    EXPECT_TRUE(contains(refusal([&] { shop.run(); }), "pair press: 4 contactor nodes start too"));

    Workshop general("general;");
    Mesh mesh = blockInPlate(0.6);
    setContact(mesh, general.folder.open().dictionary("system/contactDict"), {true, true},
               general.log);
    general.folder.write(mesh);
    EXPECT_TRUE(contains(refusal([&] { general.run(); }),
                         "pair block in plate: 16 contactor nodes start too deep"));
}
