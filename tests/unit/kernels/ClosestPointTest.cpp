#include "kernels/contact/narrow/ClosestPoint.h"

#include "kernels/contact/narrow/SignedGap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace fpm;

namespace {

double uniform(std::mt19937& random, double low = -1, double high = 1)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

double squareAt(const FaceCorners<double>& face, double xi, double eta)
{
    Vec3<double> offset, t1, t2;
    evaluateFace(face, xi, eta, offset, t1, t2);
    return dot(offset, offset);
}

/// Least square over a lattice of the face, narrowed around its best point until it is exact.
double leastSquare(const FaceCorners<double>& face)
{
    double xi = 0, eta = 0, half = 1, best = squareAt(face, 0, 0);
    for (int level = 0; level < 25; ++level) {
        const int n = level == 0 ? 40 : 4;
        const double x = xi, y = eta;
        for (int i = -n; i <= n; ++i)
            for (int j = -n; j <= n; ++j) {
                const double a = std::clamp(x + half * i / n, -1.0, 1.0),
                             b = std::clamp(y + half * j / n, -1.0, 1.0);
                const double here = squareAt(face, a, b);
                if (here < best) {
                    best = here;
                    xi = a;
                    eta = b;
                }
            }
        half = level == 0 ? 0.1 : 0.5 * half;
    }
    return best;
}

struct Shape {
    double skew, aspect, warp, distance;
};

/// A face seen from a point near it: sheared by up to `skew` degrees, longer than wide, corners
/// shaken, warped out of its plane by a share of its width.
FaceCorners<double> randomFace(std::mt19937& random, const Shape& shape)
{
    const double shear = std::tan(shape.skew * uniform(random) * 3.14159265358979 / 180);
    const double at[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    FaceCorners<double> face;
    const Vec3<double> point{uniform(random, -2, 2) * shape.aspect, uniform(random, -2, 2),
                             2 * shape.distance * uniform(random)};
    for (int k = 0; k < 4; ++k) {
        const double x = at[k][0] + 0.2 * uniform(random), y = at[k][1] + 0.2 * uniform(random);
        const Vec3<double> corner{shape.aspect * x + shear * y, y,
                                  shape.warp * (k % 2 == 0 ? 1 : -1) * uniform(random)};
        face.corner[k] = corner - point;
    }
    return face;
}

} // namespace

TEST(ClosestPoint, IsTheLeastDistanceOfAllPointsOfTheFace)
{
    std::mt19937 random(41);
    for (const Shape& shape : {Shape{0, 1, 0, 0.5}, Shape{60, 1, 0, 0.5}, Shape{60, 5, 0, 0.5},
                               Shape{45, 1, 0.2, 0.25}, Shape{60, 5, 0.3, 0.25}})
        for (int i = 0; i < 300; ++i) {
            const FaceCorners<double> face = randomFace(random, shape);
            const FacePoint<double> found = closestPoint(face, 0.0, 0.0);
            const double least = leastSquare(face);
            EXPECT_NEAR(std::sqrt(found.square), std::sqrt(least), 1e-6 * (1 + std::sqrt(least)))
                << "skew " << shape.skew << " aspect " << shape.aspect << " warp " << shape.warp;
            EXPECT_NEAR(squareAt(face, found.xi, found.eta), found.square,
                        1e-12 * (1 + found.square));
        }
}

TEST(ClosestPoint, CannotBeFoundByClampingCoordinatesOnASkewedFace)
{
    // Sheared by 60 degrees, the point beside its long corner: the clamped projection is elsewhere.
    const double s = std::sqrt(3.0);
    const Vec3<double> point{2.5, 0.8, 0};
    const Vec3<double> corner[4] = {{-1 - s, -1, 0}, {1 - s, -1, 0}, {1 + s, 1, 0}, {-1 + s, 1, 0}};
    FaceCorners<double> face;
    for (int k = 0; k < 4; ++k) face.corner[k] = corner[k] - point;
    double xi = 0, eta = 0;
    ASSERT_TRUE(project(face, xi, eta));
    ASSERT_GT(xi, 1);
    const double clamped = squareAt(face, clampedUnit(xi), clampedUnit(eta));
    const FacePoint<double> found = closestPoint(face, 0.0, 0.0);
    // The edge from (1 - s, -1) to (1 + s, 1) has the normal (1, -s) / 2.
    const double distance = (2.5 - 1 - s * 0.8) / 2;
    EXPECT_NEAR(found.square, distance * distance, 1e-12);
    EXPECT_GT(clamped, 1.5 * found.square);
    EXPECT_EQ(found.where, 1);
}

TEST(ClosestPoint, NamesTheEdgeOrCornerItLiesOn)
{
    const auto from = [](Vec3<double> point) {
        FaceCorners<double> face;
        const Vec3<double> corner[4] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
        for (int k = 0; k < 4; ++k) face.corner[k] = corner[k] - point;
        return closestPoint(face, 0.0, 0.0).where;
    };
    EXPECT_EQ(from({1, 1, 0.5}), insideFace);
    EXPECT_EQ(from({2, 1, 0.5}), insideFace); // the border belongs to the face
    EXPECT_EQ(from({1, -1, 0.5}), 0);
    EXPECT_EQ(from({3, 1, 0.5}), 1);
    EXPECT_EQ(from({1, 3, 0.5}), 2);
    EXPECT_EQ(from({-1, 1, 0.5}), 3);
    EXPECT_EQ(from({-1, -1, 0}), firstCorner);
    EXPECT_EQ(from({3, -1, 0}), firstCorner + 1);
    EXPECT_EQ(from({3, 3, 0}), firstCorner + 2);
    EXPECT_EQ(from({-1, 3, 0}), firstCorner + 3);
}

TEST(ClosestPoint, OfDegenerateFacesIsFound)
{
    // F26: a triangle, two corners in one place; and a face without area.
    const Vec3<double> wedge[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
    const Vec3<double> line[4] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    std::mt19937 random(43);
    for (int i = 0; i < 300; ++i) {
        const Vec3<double> point{uniform(random), uniform(random), uniform(random)};
        for (const auto& corner : {wedge, line}) {
            FaceCorners<double> face;
            for (int k = 0; k < 4; ++k) face.corner[k] = corner[k] - point;
            const FacePoint<double> found = closestPoint(face, 0.0, 0.0);
            EXPECT_NEAR(std::sqrt(found.square), std::sqrt(leastSquare(face)), 1e-6);
        }
        FaceCorners<double> face;
        for (int k = 0; k < 4; ++k) face.corner[k] = wedge[k] - point;
        EXPECT_NEAR(gapAt(face, 0.0, 1.0).normal.z, 1, 1e-12) << "at the collapsed side";
    }
}

TEST(ClosestPoint, ArcCosineIsThatOfTheLibrary)
{
    for (double x = -1; x <= 1; x += 1e-3) EXPECT_NEAR(arcCosine(x), std::acos(x), 3e-8);
    EXPECT_EQ(arcCosine(2.0), 0);
}
