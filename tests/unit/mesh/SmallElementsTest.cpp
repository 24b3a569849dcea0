#include "mesh/SmallElements.h"

#include "support/boxMesh.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// A bar of elements, the first `few` of them `thin` times as long as the others.
Mesh bar(Index cells, Index few, double thin)
{
    Mesh mesh;
    addBox(mesh, "bar", {cells, 1, 1}, {0, 0, 0}, {double(cells), 1, 1});
    for (Point& p : mesh.points)
        p[0] = p[0] < few ? p[0] * thin : few * thin + (p[0] - double(few));
    return mesh;
}

TEST(SmallElements, AFewThinOnesAreFoundWithPlaceAndRatio)
{
    const Mesh mesh = bar(100, 2, 0.01);
    const auto few = smallElements(mesh, elementHeights(mesh));
    ASSERT_TRUE(few);
    EXPECT_EQ(few->count, 2u);
    EXPECT_EQ(few->total, 100u);
    EXPECT_NEAR(few->ratio(), 100, 1e-9);
    EXPECT_NEAR(few->lower[0], 0.005, 1e-12);
    EXPECT_NEAR(few->upper[0], 0.015, 1e-12);
    EXPECT_EQ(smallElementsText(*few),
              "2 of 100 elements (part bar, between (0.005 0.5 0.5) and (0.015 0.5 0.5))");
}

TEST(SmallElements, EvenMeshesHaveNoneNorThoseWithManySmallOnes)
{
    for (const auto& [few, thin] : {std::pair{Index(0), 1.0}, {2, 0.5}, {11, 0.01}, {50, 0.01}}) {
        const Mesh mesh = bar(100, few, thin);
        EXPECT_FALSE(smallElements(mesh, elementHeights(mesh))) << few << " of " << thin;
    }
}

TEST(SmallElements, WhatHasNoSizeDoesNotCount)
{
    const Mesh mesh = bar(100, 1, 0.01);
    std::vector<double> sizes = elementHeights(mesh);
    sizes[0] = 0; // of a rigid part
    EXPECT_FALSE(smallElements(mesh, sizes));
    EXPECT_FALSE(smallElements(mesh, std::vector<double>(100, 0.0)));
}

} // namespace
} // namespace fpm::test
