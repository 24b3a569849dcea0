#include "model/EdgeCrossing.h"

#include "mesh/Surface.h"
#include "unit/model/BoxMesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fpm;

namespace {

/// Two wedges edge on edge, crossed at right angles: boxes turned on an edge, `overlap` into each
/// other. No node of one is near the other.
Mesh crossedWedges(double overlap)
{
    Mesh mesh = test::boxMesh({{"lower", {-3, -0.5, -0.5}, {6, 1, 1}, {1, 1, 1}},
                               {"upper", {-0.5, -3, -0.5}, {1, 6, 1}, {1, 1, 1}}});
    const double s = std::sqrt(0.5);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        Point& p = mesh.points[i];
        const bool upper = i >= 8;
        const std::size_t across = upper ? 0 : 1;
        const double a = p[across], z = p[2];
        p[across] = s * (a - z);
        p[2] = s * (a + z) + (upper ? 2 * s - overlap : 0);
    }
    return mesh;
}

EdgeCrossings crossings(const Mesh& mesh)
{
    return edgeCrossings(mesh, mesh.points, skin(mesh, 0), skin(mesh, 1));
}

} // namespace

TEST(EdgeCrossing, SeesEdgesThatCrossWhereNoNodeIsInside)
{
    const EdgeCrossings found = crossings(crossedWedges(0.05));
    EXPECT_EQ(found.count, 2u); // the ridge of each passes through the other
    EXPECT_NEAR(found.place[0], 0, 1e-12);
    EXPECT_NEAR(found.place[1], 0, 1e-12);
    EXPECT_NEAR(found.place[2], std::sqrt(0.5), 0.05);
}

TEST(EdgeCrossing, TheRimOfASurfaceOnAPlaneOfSymmetryIsNoEdge)
{
    // The top of the lower block ends at y = 0, where a wedge on top of it cuts into the rim.
    Mesh mesh = test::boxMesh({{"lower", {0, 0, 0}, {4, 4, 1}, {1, 1, 1}},
                               {"upper", {1, -1, 0.9}, {2, 2, 1}, {1, 1, 1}}});
    const auto top = [&](Index part, Index number) {
        std::vector<ElementSide> sides;
        for (const ElementSide& side : skin(mesh, part))
            if (side.side == number) sides.push_back(side);
        return sides;
    };
    std::vector<bool> onPlane;
    for (const Point& p : mesh.points) onPlane.push_back(p[1] == 0);
    const auto lower = top(0, 5), upper = skin(mesh, 1);
    EXPECT_EQ(edgeCrossings(mesh, mesh.points, lower, upper).count, 1u);
    EXPECT_EQ(edgeCrossings(mesh, mesh.points, lower, upper, {{{0, 1, 0}, &onPlane}}).count, 0u);
    // The side in the plane is no surface, and so makes no edge either.
    EXPECT_EQ(edgeCrossings(mesh, mesh.points, skin(mesh, 0), upper, {{{0, 1, 0}, &onPlane}}).count,
              0u);
}

/// A bar along y over one along x, `overlap` into it: two edges of the upper cross the lower.
Mesh bars(double overlap)
{
    return test::boxMesh({{"lower", {0, 0, 0}, {4, 1, 1}, {1, 1, 1}},
                          {"upper", {1, -4, 1 - overlap}, {2, 9, 1}, {1, 1, 1}}});
}

TEST(EdgeCrossing, IsAsDeepAsItIsBehindTheNearestFace)
{
    // Not as behind the sides by which it enters and leaves, half the bar's width away.
    EXPECT_EQ(crossings(bars(0.005)).count, 0u);
    const EdgeCrossings found = crossings(bars(0.2));
    EXPECT_EQ(found.count, 4u);           // and two of the lower cross the upper
    EXPECT_NEAR(found.depth, 0.2, 1e-12); // of 1 through the bar, though a face is 2 wide
}

TEST(EdgeCrossing, AThinSheetIsPassedThroughThoughItsFacesAreWide)
{
    const Mesh mesh = test::boxMesh({{"sheet", {0, 0, 0}, {10, 10, 0.1}, {2, 2, 1}},
                                     {"needle", {2, 2, -3}, {0.5, 0.5, 6}, {1, 1, 1}}});
    const EdgeCrossings found = crossings(mesh);
    EXPECT_EQ(found.count, 4u);
    EXPECT_NEAR(found.depth, 0.5, 1e-12);
}

TEST(EdgeCrossing, SeesNoneWhereTheBodiesAreApart)
{
    EXPECT_EQ(crossings(crossedWedges(-0.01)).count, 0u);
}

TEST(EdgeCrossing, DoesNotTakeANodeInsideForACrossing)
{
    const Mesh mesh = test::boxMesh({{"lower", {0, 0, 0}, {4, 4, 1}, {4, 4, 2}},
                                     {"upper", {1.2, 1.2, 0.9}, {2, 2, 1}, {3, 3, 1}}});
    EXPECT_EQ(crossings(mesh).count, 0u);
}
