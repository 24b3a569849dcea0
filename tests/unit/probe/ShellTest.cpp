#include "probe/Shell.h"

#include "support/boxMesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fpm;

namespace {

std::vector<Point> positionsOf(const Mesh& mesh, const Shell& shell)
{
    std::vector<Point> positions;
    for (const Index node : shell.nodes) positions.push_back(mesh.points[std::size_t(node)]);
    return positions;
}

int creaseCount(const ShellShape& shape)
{
    int count = 0;
    for (const auto bits : shape.creases)
        for (int k = 0; k < 4; ++k) count += bits >> k & 1;
    return count;
}

const std::vector<Index> firstPart{0};

} // namespace

TEST(Shell, HasTheOuterFacesAndNoInnerVertex)
{
    Mesh mesh;
    test::addBox(mesh, "block", {3, 3, 3}, {0, 0, 0}, {1, 1, 1});

    const Shell shell = makeShell(mesh, firstPart, {});

    EXPECT_EQ(shell.quads.size(), 54u);
    EXPECT_EQ(shell.nodes.size(), 64u - 8u);
}

TEST(Shell, LeavesOutFacesInAMirrorPlane)
{
    Mesh mesh;
    test::addBox(mesh, "block", {2, 2, 2}, {0, 0, 0}, {1, 1, 1});
    MirrorPlanes mirror;
    mirror.used = {true, true, false};

    const Shell shell = makeShell(mesh, firstPart, mirror);

    EXPECT_EQ(shell.quads.size(), 24u - 8u);
}

TEST(Shell, AveragesElementValuesOverTheFacesOfOnePartOnly)
{
    Mesh mesh;
    test::addBox(mesh, "left", {2, 1, 1}, {0, 0, 0}, {2, 1, 1});
    test::addBox(mesh, "right", {1, 1, 1}, {2, 0, 0}, {1, 1, 1});
    const std::vector<Index> both{0, 1};
    const Shell shell = makeShell(mesh, both, {});

    const auto values = vertexValues(shell, {false, {10, 20, 99}});

    for (std::size_t vertex = 0; vertex < values.size(); ++vertex) {
        const double x = mesh.points[std::size_t(shell.nodes[vertex])][0];
        if (x == 0)
            EXPECT_DOUBLE_EQ(values[vertex], 10);
        else if (x == 1)
            EXPECT_DOUBLE_EQ(values[vertex], 15);
        else
            EXPECT_DOUBLE_EQ(values[vertex], shell.nodes[vertex] < 12 ? 20 : 99);
    }
}

TEST(Shell, MarksTheTwelveEdgesOfABlockAsSharp)
{
    Mesh mesh;
    test::addBox(mesh, "block", {2, 2, 2}, {0, 0, 0}, {1, 1, 1});
    const Shell shell = makeShell(mesh, firstPart, {});

    const ShellShape shape = makeShape(shell, positionsOf(mesh, shell));

    EXPECT_EQ(creaseCount(shape), 12 * 2 * 2); // two elements an edge, seen from both its faces
}

TEST(Shell, DrawsNoSharpEdgeWhereTheMirrorGoesOn)
{
    Mesh mesh;
    test::addBox(mesh, "block", {1, 1, 1}, {0, 0, 0}, {1, 1, 1});
    MirrorPlanes mirror;
    mirror.used = {true, true, false};
    const Shell shell = makeShell(mesh, firstPart, mirror);

    const ShellShape shape = makeShape(shell, positionsOf(mesh, shell));

    // left: the edges of a block that is whole, 2 on top, 2 below, 1 upright, from both faces
    EXPECT_EQ(creaseCount(shape), 10);
}

TEST(Shell, SmoothsNormalsAcrossAShallowBend)
{
    Mesh mesh;
    test::addBox(mesh, "strip", {2, 1, 1}, {0, 0, 0}, {2, 1, 0.1});
    for (Point& point : mesh.points)
        if (point[0] > 1.5) point[2] += 0.2; // 11 degrees
    const Shell shell = makeShell(mesh, firstPart, {});

    const ShellShape shape = makeShape(shell, positionsOf(mesh, shell));

    for (std::size_t quad = 0; quad < shell.quads.size(); ++quad)
        for (std::size_t k = 0; k < 4; ++k) {
            const Point& normal = shape.cornerNormals[quad][k];
            const Point& at = shape.positions[std::size_t(shell.quads[quad][k])];
            if (at[0] != 1 || normal[2] < 0.5) continue;
            EXPECT_NEAR(std::atan2(-normal[0], normal[2]), std::atan2(0.2, 1) / 2, 1e-2);
        }
}
