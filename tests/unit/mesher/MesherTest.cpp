#include "base/Error.h"
#include "unit/mesher/mesherCase.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

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

TEST(Mesher, RefinesEveryBodyInAllDirections)
{
    const std::string bodies =
        "bodies { rod { type cylinder; base (0 0 0); radius 1; height 4; core 1; rings 2; axial 3; "
        "} "
        "a { type box; origin (0 0 4); size (9 3 1); cells (3 2 1); grading (4 1 1); } "
        "s { type layers; origin (0 0 9); size (1 1 1); cells (2 1 1); count 2; } "
        "t { type hollowCylinder; base (0 0 20); innerRadius 1; outerRadius 2; height 1; "
        "circumferential 5; radial 1; axial 1; } }";

    const Mesh coarse = meshOf(bodies), fine = meshOf("refinement 3; " + bodies);

    ASSERT_EQ(coarse.parts.size(), fine.parts.size());
    for (std::size_t part = 0; part < coarse.parts.size(); ++part)
        EXPECT_EQ(fine.parts[part].elementCount, 27 * coarse.parts[part].elementCount)
            << fine.parts[part].name;
}

TEST(Mesher, KeepsTheNodesOfAGradedRowWhenItIsRefined)
{
    const std::string box = "bodies { a { type box; origin (0 0 0); size (9 3 1); cells (3 2 1); "
                            "grading (4 0.5 7); } }";
    const Mesh coarse = meshOf(box), fine = meshOf("refinement 2; " + box);

    for (const Point& node : coarse.points) {
        double nearest = 1;
        for (const Point& other : fine.points)
            nearest = std::min(
                nearest, std::hypot(node[0] - other[0], node[1] - other[1], node[2] - other[2]));
        EXPECT_LT(nearest, 1e-12);
    }
}

TEST(Mesher, RefusesARefinementItCannotMake)
{
    const auto refusal = [](const std::string& text) {
        try {
            meshOf(text);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    const std::string box =
        "bodies { a { type box; origin (0 0 0); size (1 1 1); cells (50000 1 1); } }";

    EXPECT_NE(refusal("refinement 0; " + box).find("'refinement' must be an integer between 1"),
              std::string::npos);
    EXPECT_NE(refusal("refinement 3; " + box).find("50000 cells times refinement 3"),
              std::string::npos);
    EXPECT_NE(refusal("refinement 2; bodies { a { type file; file \"a.msh\"; } }")
                  .find("a mesh file cannot be refined"),
              std::string::npos);
}

TEST(Mesher, RefusesMoreThanTheMachineHolds)
{
    const double machine = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
    if (machine > 2e11) GTEST_SKIP() << "as many elements as can be numbered fit this machine";
    try {
        meshOf("bodies { a { type box; origin (0 0 0); size (1 1 1); cells (645 645 645); } }");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::memory);
    }
}

TEST(Mesher, TellsAFewElementsThatSetTheTimeStep)
{
    const MesherCase aCase;
    const std::string box = "bodies { a { type box; origin (0 0 0); size (10 10 10); cells "
                            "(20 4 4); ";
    EXPECT_NE(
        aCase.said(box + "grading (1000 1 1); } }").find("32 of 320 elements (part a, between"),
        std::string::npos);
    EXPECT_EQ(aCase.said(box + "} }").find("time step"), std::string::npos);
}

} // namespace fpm::test
