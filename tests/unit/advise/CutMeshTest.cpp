#include "advise/CutMesh.h"

#include "mesh/Quality.h"
#include "unit/advise/symmetricScene.h"

#include <gtest/gtest.h>

namespace fpm::test {

TEST(CutMesh, KeepsAQuarterWithItsSets)
{
    Model model = symmetricScene();
    Mesh& mesh = model.mesh;
    mesh.nodeSets["top"] = nodesWhere(mesh, [](Point p) { return p[2] == 1; });
    mesh.sideSets["under"] = facing(mesh, "upper", {0, 0, -1});
    mesh.nodeSets["gone"] = nodesWhere(mesh, [](Point p) { return p[0] == -3; });
    // A node of the plane that lies off it by rounding.
    for (Point& p : mesh.points)
        if (p == Point{0, 1, 1}) p[1] = 1 + 1e-10;
    const Cut cut(mesh, {{0, 0.0}, {1, 1.0}}, {1, -1});
    EXPECT_EQ(cut.factor(), 4);

    const Mesh quarter = cutMesh(mesh, cut);

    ASSERT_EQ(quarter.parts.size(), 2u);
    EXPECT_EQ(quarter.parts[0].elementCount, 3 * 2 * 1);
    EXPECT_EQ(quarter.parts[1].elementCount, 2 * 1 * 2);
    EXPECT_NEAR(quality(quarter).totalVolume, (24 + 2) / 4.0, 1e-12);
    EXPECT_EQ(quarter.points.size(), 4u * 3 * 2 + 3u * 2 * 3);
    int onY = 0;
    for (const Point& p : quarter.points) {
        EXPECT_GE(p[0], 0);
        EXPECT_LE(p[1], 1);
        onY += p[1] == 1;
    }
    EXPECT_EQ(onY, 4 * 2 + 3 * 3);
    EXPECT_EQ(quarter.nodeSets.at("top").size(), 3u * 2);
    EXPECT_EQ(quarter.sideSets.at("under").size(), 2u);
    for (const ElementSide& side : quarter.sideSets.at("under"))
        EXPECT_EQ(centre(quarter, side)[2], 0);
    EXPECT_TRUE(quarter.nodeSets.at("gone").empty());
}

TEST(CutMesh, MovesPointsToTheSideThatIsKept)
{
    const Model model = symmetricScene();
    const Cut cut(model.mesh, {{0, 0.0}, {1, 1.0}}, {1, -1});
    EXPECT_EQ(cut.kept({-2, 0.5, 3}), (Point{2, 0.5, 3}));
    EXPECT_EQ(cut.kept({-2, 1.75, 3}), (Point{2, 0.25, 3}));
    EXPECT_TRUE(cut.keeps(Point{0, 1, 7}));
    EXPECT_EQ(cut.planesAt({0, 1, 7}), 2u);
    EXPECT_EQ(cut.planesAt({0, 0.5, 7}), 1u);
}

} // namespace fpm::test
