#include "mesh/Surface.h"

#include "support/boxMesh.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace fpm;

namespace {

Mesh twoBoxes()
{
    Mesh mesh;
    test::addBox(mesh, "lower", {3, 2, 2}, {0, 0, 0}, {3, 4, 5});
    test::addBox(mesh, "upper", {2, 2, 1}, {0, 0, 5}, {3, 4, 1});
    return mesh;
}

} // namespace

TEST(Surface, SkinOfABlockIsItsOutside)
{
    const Mesh mesh = twoBoxes();

    const auto lower = skin(mesh, 0), upper = skin(mesh, 1);

    EXPECT_EQ(lower.size(), 2U * (3 * 2 + 2 * 2 + 3 * 2));
    EXPECT_EQ(upper.size(), 2U * (2 * 2 + 2 * 1 + 2 * 1));
    EXPECT_TRUE(std::ranges::is_sorted(lower));
    double total = 0;
    for (const auto& side : lower) total += area(mesh, side);
    EXPECT_NEAR(total, 2 * (3 * 4 + 4 * 5 + 3 * 5), 1e-12);
}

TEST(Surface, NormalsPointOutward)
{
    const Mesh mesh = twoBoxes();
    const Point middle{1.5, 2, 2.5};

    for (const auto& side : skin(mesh, 0)) {
        const Point at = centre(mesh, side), direction = normal(mesh, side);
        double outward = 0, square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            outward += (at[k] - middle[k]) * direction[k];
            square += direction[k] * direction[k];
        }
        EXPECT_GT(outward, 0);
        EXPECT_NEAR(square, 1, 1e-14);
    }
}

TEST(Surface, SidesFollowTheVtkOrder)
{
    const Mesh mesh = test::boxMesh({1, 1, 1});
    const std::array<Point, 6> expected{
        {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

    for (Index side = 0; side < 6; ++side)
        EXPECT_EQ(normal(mesh, {0, side}), expected[std::size_t(side)]) << side;
}

TEST(Surface, AnnihilatesSidesSharedInAnyRotation)
{
    // The second brick names the shared side from another corner on.
    Mesh mesh = test::boxMesh({2, 1, 1});
    const Hexahedron n = mesh.hexahedra[1];
    mesh.hexahedra[1] = {n[3], n[0], n[1], n[2], n[7], n[4], n[5], n[6]};

    EXPECT_EQ(skin(mesh, 0).size(), 10U);
}

TEST(Surface, ListsEachNodeOnce)
{
    const Mesh mesh = test::boxMesh({3, 3, 3});

    const auto nodes = nodesOf(mesh, skin(mesh, 0));

    EXPECT_EQ(nodes.size(), 64U - 8U);
    EXPECT_TRUE(std::ranges::adjacent_find(nodes, std::greater_equal()) == nodes.end());
}

TEST(Surface, ADegenerateSideHasNoNormal)
{
    Mesh mesh = test::boxMesh({1, 1, 1});
    for (auto& point : mesh.points) point[0] = 0;

    EXPECT_EQ(normal(mesh, {0, 4}), (Point{0, 0, 0}));
    EXPECT_EQ(area(mesh, {0, 4}), 0);
}

TEST(Surface, SidesThatTwoElementsShareLieInside)
{
    const Mesh mesh = test::boxMesh({2, 2, 2});
    EXPECT_TRUE(innerSides(mesh, skin(mesh, 0)).empty());
    // Side 1 of element 0 is side 0 of element 1.
    const std::vector<ElementSide> some{{0, 0}, {0, 1}, {1, 0}, {3, 4}, {0, 5}};
    EXPECT_EQ(innerSides(mesh, some), (std::vector<ElementSide>{{0, 1}, {1, 0}, {0, 5}}));
}

TEST(Surface, BodiesThatTouchWithNodesOfTheirOwnHaveNoInnerSides)
{
    const Mesh mesh = twoBoxes();
    EXPECT_TRUE(innerSides(mesh, skin(mesh, 1)).empty());
}
