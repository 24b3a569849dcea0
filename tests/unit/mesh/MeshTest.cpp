#include "mesh/Mesh.h"

#include "support/boxMesh.h"

#include <gtest/gtest.h>

using namespace fpm;

TEST(Mesh, FindsPartsByNameAndElement)
{
    Mesh mesh;
    test::addBox(mesh, "rod", {2, 1, 1});
    test::addBox(mesh, "plate", {3, 1, 1});

    EXPECT_EQ(mesh.findPart("plate"), 1);
    EXPECT_EQ(mesh.findPart("die"), -1);
    EXPECT_EQ(mesh.partOf(0), 0);
    EXPECT_EQ(mesh.partOf(1), 0);
    EXPECT_EQ(mesh.partOf(2), 1);
    EXPECT_EQ(mesh.partOf(4), 1);
}

TEST(Mesh, NumbersTheSidesOfABrick)
{
    const Mesh mesh = test::boxMesh({1, 1, 1});

    // Corner c of the brick is node 0 1 3 2 4 5 7 6 of the grid.
    EXPECT_EQ(mesh.sideNodes({0, 4}), (Quad{0, 2, 3, 1}));
    EXPECT_EQ(mesh.sideNodes({0, 5}), (Quad{4, 5, 7, 6}));
}
