#include "model/FaceTree.h"

#include "mesh/Surface.h"
#include "model/PointAlgebra.h"
#include "unit/model/BoxMesh.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace fpm;

namespace {

FaceTree treeOf(const Mesh& mesh)
{
    return FaceTree(mesh, skin(mesh, 0));
}

double
nearestByTryingAll(const Mesh& mesh, const std::vector<ElementSide>& sides, const Point& point)
{
    double best = std::numeric_limits<double>::infinity();
    for (const ElementSide& side : sides)
        best = std::min(best, FaceTree(mesh, std::span(&side, 1)).nearest(point).distance);
    return best;
}

} // namespace

TEST(FaceTree, MeasuresHeightOutsideAndDepthInside)
{
    const FaceTree tree = treeOf(test::boxMesh({{"block", {0, 0, 0}, {4, 4, 2}, {4, 4, 2}}}));

    const auto above = tree.nearest({1.3, 2.6, 2.5});
    EXPECT_NEAR(above.height, 0.5, 1e-14);
    EXPECT_NEAR(above.point[2], 2.0, 1e-14);
    EXPECT_NEAR(tree.nearest({1.3, 2.6, 1.8}).height, -0.2, 1e-14);
}

TEST(FaceTree, TakesAtAnEdgeTheFaceThatPointsBestAtThePoint)
{
    const FaceTree tree = treeOf(test::boxMesh({{"block", {0, 0, 0}, {1, 1, 1}}}));

    const auto hit = tree.nearest({1.1, 0.5, 1.4});

    EXPECT_NEAR(hit.distance, std::hypot(0.1, 0.4), 1e-14);
    EXPECT_NEAR(hit.height, 0.4, 1e-14);
}

TEST(FaceTree, AgreesWithTryingEveryFace)
{
    const Mesh mesh = test::boxMesh({{"block", {0, 0, 0}, {50, 3, 1}, {5, 30, 4}}});
    const auto sides = skin(mesh, 0);
    const FaceTree tree(mesh, sides);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-20, 70);

    for (int i = 0; i < 300; ++i) {
        const Point point{x(random), x(random), x(random)};
        const auto hit = tree.nearest(point);
        EXPECT_NEAR(hit.distance, nearestByTryingAll(mesh, sides, point), 1e-12);
        EXPECT_NEAR(length(difference(point, hit.point)), hit.distance, 1e-12);
    }
}
