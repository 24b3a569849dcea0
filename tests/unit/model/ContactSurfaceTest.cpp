#include "model/ContactSurface.h"

#include "mesh/Surface.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

const Mesh& blocks()
{
    static const Mesh mesh = test::boxMesh(
        {{"lower", {0, 0, 0}, {4, 4, 1}, {4, 4, 1}}, {"upper", {0, 0, 1}, {4, 4, 1}, {2, 2, 1}}});
    return mesh;
}

std::vector<ElementSide> contactor(const std::string& name, const std::string& surfaces)
{
    const auto dictionary = Dictionary::parse(
        "pairs { p { contactor " + name + "; target upper; } } surfaces { " + surfaces + " }");
    const ContactEntries entries = readContactEntries(dictionary);
    return contactSides(blocks(), entries, entries.pairs.front(), "contactor", dictionary);
}

} // namespace

TEST(ContactSurface, IsTheWholeSkinOfAPart)
{
    EXPECT_EQ(contactor("lower", "").size(), 16u + 16u + 16u);
}

TEST(ContactSurface, IsASideSetWhereNoPartHasTheName)
{
    EXPECT_EQ(contactor("lower.zMax", ""), blocks().sideSets.at("lower.zMax"));
}

TEST(ContactSurface, KeepsTheSidesThatFaceADirection)
{
    EXPECT_EQ(contactor("top", "top { part lower; facing (0.2 0 3); }"),
              blocks().sideSets.at("lower.zMax"));
}

TEST(ContactSurface, KeepsTheSidesWithinABox)
{
    const auto sides = contactor("part", "part { set lower.zMax; within box ((0 0 0) (2 1 2)); }");

    ASSERT_EQ(sides.size(), 2u);
    for (const ElementSide& side : sides) EXPECT_LT(centre(blocks(), side)[0], 2);
}

TEST(ContactSurface, KeepsTheSidesWithinACylinder)
{
    EXPECT_EQ(
        contactor("spot", "spot { set lower.zMax; within cylinder ((2 2 0) (2 2 5) 0.8); }").size(),
        4u);
}

TEST(ContactSurface, TellsWhereAnEmptySurfaceLostItsSides)
{
    const std::string text = refusal([] {
        contactor("top", "top { part lower; facing (0 0 1); within box ((0 0 2) (4 4 3)); }");
    });

    EXPECT_TRUE(contains(
        text, "surface 'top' is empty: 48 sides of part 'lower', of which 16 face (0 0 1), "
              "of which 0 lie within the box"));
}

TEST(ContactSurface, RefusesNamesThatMeanNothing)
{
    EXPECT_TRUE(contains(refusal([] { contactor("lowr", ""); }), "did you mean 'lower'?"));
    EXPECT_TRUE(contains(refusal([] { contactor("s", "s { part lowr; }"); }),
                         "the mesh has no part 'lowr'"));
    EXPECT_TRUE(contains(refusal([] { contactor("s", "s { set lower.zMx; }"); }),
                         "did you mean 'lower.zMax'?"));
}

TEST(ContactSurface, RefusesRegionsThatHoldNothing)
{
    EXPECT_TRUE(
        contains(refusal([] { contactor("s", "s { part lower; within box ((0 0 5) (1 1 1)); }"); }),
                 "the first corner (0 0 5) is not below the second (1 1 1)"));
    EXPECT_TRUE(contains(
        refusal([] { contactor("s", "s { part lower; within cylinder ((0 0 0) (0 0 1) 0); }"); }),
        "the radius must be > 0"));
    EXPECT_TRUE(
        contains(refusal([] { contactor("s", "s { part lower; within sphere ((0 0 0) 1); }"); }),
                 "unknown region 'sphere'"));
    EXPECT_TRUE(contains(refusal([] { contactor("s", "s { part lower; facing (0 0 0); }"); }),
                         "points nowhere"));
}

TEST(ContactSurface, RefusesSetsInsideTheMaterial)
{
    Mesh mesh = test::boxMesh(
        {{"lower", {0, 0, 0}, {1, 1, 2}, {1, 1, 2}}, {"block", {0, 0, 3}, {1, 1, 1}, {1, 1, 1}}});
    mesh.sideSets["interface"] = {{0, 5}};
    for (const char* surfaces : {"", "s { set interface; }"}) {
        const auto dictionary = Dictionary::parse(
            std::string("pairs { p { contactor block; target ") + (*surfaces ? "s" : "interface")
            + "; } } surfaces { " + surfaces + " }");
        const ContactEntries entries = readContactEntries(dictionary);
        EXPECT_TRUE(contains(refusal([&] {
                                 contactSides(mesh, entries, entries.pairs.front(), "target",
                                              dictionary);
                             }),
                             "1 of 1 sides lie inside the material, such as that at (0.5 0.5 1)"));
    }
}
