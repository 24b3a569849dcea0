#include "base/Error.h"
#include "unit/mesher/mesherCase.h"

#include <gtest/gtest.h>

namespace fpm::test {

TEST(Mesher, MeshesTheAnnotatedDictionary)
{
    const MesherCase theCase;
    const std::string text = readBytes(std::string(FPM_SOURCE_DIR) + "/etc/caseDicts/meshDict");

    const Mesh mesh = theCase.mesh(text);

    EXPECT_EQ(mesh.parts.size(), 6u);
    EXPECT_EQ(mesh.nodeSets.size(), 1u);
}

TEST(Mesher, MakesTheSameMeshTwice)
{
    const std::string text =
        "bodies { rod { type cylinder; base (0 0 0); radius 1; height 4; core 4; "
        "rings 3; axial 9; } a { type box; origin (0 0 4); size (3 3 1); cells "
        "(20 20 2); } }";

    const Mesh first = meshOf(text), second = meshOf(text);

    EXPECT_EQ(first.points, second.points);
    EXPECT_EQ(first.hexahedra, second.hexahedra);
    EXPECT_EQ(first.sideSets, second.sideSets);
}

TEST(Mesher, CutsPartsIntoPatches)
{
    const Mesh mesh =
        meshOf("bodies { a { type box; origin (0 0 0); size (1 1 1); cells (10 10 10); } }");

    EXPECT_EQ(mesh.patchStarts.back(), 1000);
    EXPECT_GE(mesh.patchStarts.size(), 5u);
}

TEST(Mesher, RefusesMoreThanTheMachineHolds)
{
    try {
        meshOf("bodies { a { type box; origin (0 0 0); size (1 1 1); cells (1290 1290 1290); } }");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::memory);
    }
}

} // namespace fpm::test
