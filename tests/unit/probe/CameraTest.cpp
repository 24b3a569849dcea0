#include "probe/Camera.h"

#include <gtest/gtest.h>

using namespace fpm;

namespace {

Camera cubeCamera(const Point& view, bool perspective)
{
    Camera camera(view, {0, 0, 1}, perspective);
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) camera.include({x, y, z});
    camera.fit(200, 200, 0);
    return camera;
}

} // namespace

TEST(Camera, SeesXToTheRightAndZUpwardsFromTheFront)
{
    const Camera camera = cubeCamera({0, -1, 0}, false);

    const Projected corner = camera.project({1, -1, 1});

    EXPECT_NEAR(corner.x, 200, 1e-9);
    EXPECT_NEAR(corner.y, 0, 1e-9);
    EXPECT_GT(corner.depth, camera.project({1, 1, 1}).depth);
}

TEST(Camera, TakesAnotherUprightWhenLookingAlongIt)
{
    const Camera camera = cubeCamera({0, 0, 1}, false);

    EXPECT_NEAR(camera.toView({0, 1, 0})[1], 1, 1e-12);
    EXPECT_NEAR(camera.toView({1, 0, 0})[0], 1, 1e-12);
}

TEST(Camera, KeepsAPerspectiveViewInsideThePicture)
{
    const Camera camera = cubeCamera({1, -1.2, 0.8}, true);

    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) {
                const Projected p = camera.project({x, y, z});
                EXPECT_GE(p.x, 0);
                EXPECT_LE(p.x, 200);
                EXPECT_GE(p.y, 0);
                EXPECT_LE(p.y, 200);
            }
}

TEST(Camera, DrawsNearThingsLargerInPerspective)
{
    const Camera camera = cubeCamera({0, -1, 0}, true);

    const double near = camera.project({1, -1, 0}).x - camera.project({-1, -1, 0}).x;
    const double far = camera.project({1, 1, 0}).x - camera.project({-1, 1, 0}).x;

    EXPECT_GT(near, 1.05 * far);
}
