#include "base/Error.h"
#include "mesh/Surface.h"
#include "unit/mesher/mesherCase.h"

#include <gtest/gtest.h>

#include <fstream>

namespace fpm::test {

namespace {

/// Two blocks on one another in format 2.2, tags with gaps, volumes, surfaces, a curve, a point.
const std::string twoBlocks = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
6
0 9 "corner"
1 8 "edge"
2 5 "base"
2 6 "middle"
3 1 "lower"
3 2 "upper"
$EndPhysicalNames
$Nodes
12
101 0 0 0
102 1 0 0
103 1 1 0
104 0 1 0
205 0 0 1
206 1 0 1
207 1 1 1
208 0 1 1
309 0 0 2
310 1 0 2
311 1 1 2
312 0 1 2
$EndNodes
$Elements
7
1 15 2 9 1 101
2 1 2 8 1 101 102
3 3 2 5 1 101 104 103 102
4 3 2 6 2 205 208 207 206
5 3 2 7 3 309 310 311 312
70 5 2 1 1 101 102 103 104 205 206 207 208
80 5 2 2 2 205 206 207 208 309 310 311 312
$EndElements
)";

Mesh import(const std::string& text, const std::string& file = "part.msh")
{
    const MesherCase theCase;
    writeBytes(theCase / file, text);
    return theCase.mesh("bodies { part { type file; file \"" + file + "\"; } }");
}

ExitCode refusal(const std::string& text)
{
    try {
        import(text);
    } catch (const Error& error) {
        return error.code();
    }
    return ExitCode::success;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST(FileBody, MakesPartsOfPhysicalVolumes)
{
    const Mesh mesh = import(twoBlocks);

    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(mesh.parts[0].name, "lower");
    EXPECT_EQ(mesh.parts[1].name, "upper");
    EXPECT_EQ(mesh.points.size(), 12u);
}

TEST(FileBody, MakesSetsOfOtherGroupsAndNamesTheNameless)
{
    const Mesh mesh = import(twoBlocks);

    EXPECT_EQ(mesh.sideSets.size(), 3u);
    EXPECT_EQ(normal(mesh, mesh.sideSets.at("base").at(0))[2], -1);
    EXPECT_EQ(normal(mesh, mesh.sideSets.at("part.surface7").at(0))[2], 1);
    EXPECT_EQ(mesh.nodeSets.at("edge").size(), 2u);
    EXPECT_EQ(mesh.nodeSets.at("corner").size(), 1u);
}

TEST(FileBody, TakesTheOutwardSideOfAFaceBetweenTwoParts)
{
    const Mesh mesh = import(twoBlocks); // the outward normal of "middle" points down, out of the
                                         // upper block

    const auto& middle = mesh.sideSets.at("middle");
    ASSERT_EQ(middle.size(), 1u);
    EXPECT_EQ(mesh.partOf(middle[0].element), 1);
}

TEST(FileBody, IsOnePartWithoutPhysicalVolumes)
{
    const auto start = twoBlocks.find("$PhysicalNames"), end = twoBlocks.find("$Nodes");
    auto text = twoBlocks.substr(0, start) + twoBlocks.substr(end);
    text = replaced(replaced(text, "70 5 2 1 1", "70 5 2 0 1"), "80 5 2 2 2", "80 5 2 0 2");

    const Mesh mesh = import(text);

    ASSERT_EQ(mesh.parts.size(), 1u);
    EXPECT_EQ(mesh.parts[0].name, "part");
    EXPECT_EQ(mesh.parts[0].elementCount, 2);
}

TEST(FileBody, StandsBesideOtherBodies)
{
    const MesherCase theCase;
    writeBytes(theCase / "part.msh", twoBlocks);

    const Mesh mesh =
        theCase.mesh("bodies { a { type box; origin (0 0 2); size (1 1 1); cells (1 1 "
                     "1); } part { type file; file \"part.msh\"; } } "
                     "sets { top { type plane; point (0 0 2); normal (0 0 1); bodies "
                     "(part); } }");

    EXPECT_EQ(mesh.parts.size(), 3u);
    EXPECT_EQ(mesh.points.size(), 20u);
    EXPECT_EQ(mesh.sideSets.at("top").size(), 1u);
    EXPECT_EQ(mesh.partOf(mesh.sideSets.at("top")[0].element), mesh.findPart("upper"));
}

TEST(FileBody, RefusesWhatGmshCannotRead)
{
    EXPECT_EQ(refusal(replaced(twoBlocks, "103 1 1 0", "103 1,0 1 0")), ExitCode::mesh);
    EXPECT_EQ(refusal(replaced(twoBlocks, "309 310 311 312\n$", "309 310 311 999\n$")),
              ExitCode::mesh);
    EXPECT_EQ(refusal(replaced(twoBlocks, "312 0 1 2", "311 0 1 2")), ExitCode::mesh);
}

TEST(FileBody, SurvivesAFileCutAnywhere)
{
    for (std::size_t size = 0; size + 20 < twoBlocks.size(); size += 37)
        EXPECT_EQ(refusal(twoBlocks.substr(0, size)), ExitCode::mesh) << size;
}

TEST(FileBody, RunsNoScriptThatCallsItselfAMesh)
{
    const TemporaryFolder folder;
    const auto trace = folder / "trace";
    const std::string script = "SystemCall \"touch " + trace.string() + "\";\n";

    EXPECT_EQ(refusal(script), ExitCode::mesh);
    EXPECT_EQ(refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + script), ExitCode::mesh);
    EXPECT_FALSE(std::filesystem::exists(trace));
}

TEST(FileBody, RunsNoOptionsThatLieBesideTheMesh)
{
    const MesherCase theCase;
    const auto trace = theCase / "trace";
    writeBytes(theCase / "part.msh", twoBlocks);
    writeBytes(theCase / "part.msh.opt", "SystemCall \"touch " + trace.string() + "\";\n");

    theCase.mesh("bodies { part { type file; file \"part.msh\"; } }");

    EXPECT_FALSE(std::filesystem::exists(trace));
}

TEST(FileBody, MeshesAGeometryOnlyWhenAllowed)
{
    const MesherCase theCase;
    writeBytes(theCase / "block.geo", R"(
        Point(1) = {0, 0, 0};
        l[] = Extrude {1, 0, 0} { Point{1}; Layers{2}; };
        s[] = Extrude {0, 1, 0} { Curve{l[1]}; Layers{3}; Recombine; };
        Extrude {0, 0, 1} { Surface{s[1]}; Layers{4}; Recombine; }
    )");
    const std::string meshDict = "bodies { block { type file; file \"block.geo\"; } }";

    EXPECT_EQ(theCase.mesh(meshDict, true).hexahedra.size(), 24u);
    EXPECT_THROW(theCase.mesh(meshDict, false), Error);
}

} // namespace fpm::test
