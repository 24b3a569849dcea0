#include "unit/kernels/oneContactor.h"
#include "unit/kernels/rotated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace fpm {
namespace {

using namespace test;

/// The corner of a pyramid on two planes of symmetry 60 degrees apart: its image all around has the
/// mean normal of the axis in which they meet.
TEST(FootFaces, TheMeanNormalOnObliquePlanesOfSymmetryLiesInAllOfThem)
{
    const double angle = std::numbers::pi / 3, c = std::cos(angle), s = std::sin(angle);
    for (const double tilt : {-0.3, 0.2}) {
        const std::vector<V> nodes{
            {0.1, 0.1, -0.2}, {0, 0, 0}, {1, 0, tilt}, {1 + c, s, 1.5 * tilt}, {c, s, 0.4 * tilt}};
        const Faces one{
            {1, 2, 3, 4}, {0, 1, 2, 3}, {mirrorEdge(0), freeEdge, freeEdge, mirrorEdge(1)}};
        OneContactor pair(0.3, nodes, 0, one, {.mirrorNormals = {0, -1, 0, -s, c, 0}});
        const auto view = pair.view();
        const V mean = FootFaces<DoublePrecision>(view, 0, 0, -1.0, -1.0).meanNormal(view);
        EXPECT_NEAR(mean.x, 0, 1e-12);
        EXPECT_NEAR(mean.y, 0, 1e-12);
        EXPECT_GT(mean.z, 0.5);
    }
}

} // namespace
} // namespace fpm
