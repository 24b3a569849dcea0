#include "mesh/SharpEdges.h"

#include "mesh/Surface.h"
#include "mesh/Vector.h"
#include "support/boxMesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fpm::test {
namespace {

std::vector<ElementSide> sidesTowards(const Mesh& mesh, const Point& direction)
{
    std::vector<ElementSide> out;
    for (const ElementSide& side : skin(mesh, 0))
        if (vector::dot(normal(mesh, side), direction) > 0.9) out.push_back(side);
    return out;
}

TEST(SharpEdges, OfABoxAreItsTwelveEdges)
{
    const Mesh mesh = boxMesh({2, 3, 4});
    const std::vector<SharpEdge> edges = sharpEdges(mesh, skin(mesh, 0));
    EXPECT_EQ(edges.size(), 4u * (2 + 3 + 4));
    for (const SharpEdge& edge : edges) {
        const auto x = [&](std::size_t k) { return mesh.points[std::size_t(edge.nodes[k])]; };
        const Point along = vector::difference(x(1), x(0));
        // Both faces have their material on the inner side of an outward normal.
        const Point first = vector::cross(along, vector::difference(x(2), x(1))),
                    second = vector::cross(vector::difference(x(4), x(0)), along);
        const Point middle{0.5, 0.5, 0.5};
        EXPECT_GT(vector::dot(first, vector::difference(x(0), middle)), 0);
        EXPECT_GT(vector::dot(second, vector::difference(x(0), middle)), 0);
        EXPECT_EQ(edge.sides.size(), 2u);
    }
}

TEST(SharpEdges, ReentrantEdgesAreNone)
{
    // An L: one of three by three columns is missing.
    Mesh mesh = boxMesh({2, 2, 1}, {2, 2, 1});
    mesh.hexahedra.pop_back();
    mesh.parts[0].elementCount = 3;
    const std::vector<SharpEdge> edges = sharpEdges(mesh, skin(mesh, 0));
    // Top and bottom have 8 edges each; of 6 upright ones the inner one does not count.
    EXPECT_EQ(edges.size(), 8u + 8u + 5u);
}

TEST(SharpEdges, WhereASurfaceEndsTheBodyDecides)
{
    const Mesh mesh = boxMesh({2, 2, 2});
    const std::vector<ElementSide> top = sidesTowards(mesh, {0, 0, 1});
    EXPECT_EQ(sharpEdges(mesh, top).size(), 8u); // all around
    // Half of the top: its inner border lies in the middle of a flat side.
    std::vector<ElementSide> half;
    std::ranges::copy_if(top, std::back_inserter(half),
                         [&](const ElementSide& side) { return centre(mesh, side)[0] < 0.5; });
    EXPECT_EQ(sharpEdges(mesh, half).size(), 4u);
    for (const SharpEdge& edge : sharpEdges(mesh, half)) EXPECT_EQ(edge.sides.size(), 1u);
}

TEST(SharpEdges, APlaneOfSymmetryHasNone)
{
    const Mesh mesh = boxMesh({1, 1, 1});
    std::vector<bool> holds;
    for (const Point& p : mesh.points) holds.push_back(p[0] == 0);
    // Without the side x = 0: the four edges along x and the four of the far side.
    EXPECT_EQ(sharpEdges(mesh, skin(mesh, 0), {&holds}).size(), 8u);
    EXPECT_EQ(sharpEdges(mesh, sidesTowards(mesh, {0, 0, 1}), {&holds}).size(), 3u);
}

} // namespace
} // namespace fpm::test
