#include "kernels/contact/narrow/FaceProjection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fpm;

namespace {

double uniform(std::mt19937& random, double low = -1, double high = 1)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

Vec3<double> randomVector(std::mt19937& random, double size)
{
    return {size * uniform(random), size * uniform(random), size * uniform(random)};
}

double length(const Vec3<double>& a)
{
    return std::sqrt(dot(a, a));
}

FaceCorners<double> seenFrom(const Vec3<double> (&corner)[4], const Vec3<double>& point)
{
    return {{corner[0] - point, corner[1] - point, corner[2] - point, corner[3] - point}};
}

Vec3<double> pointOn(const Vec3<double> (&corner)[4], double xi, double eta)
{
    double n[4];
    shapeFunctions(xi, eta, n);
    return n[0] * corner[0] + n[1] * corner[1] + n[2] * corner[2] + n[3] * corner[3];
}

/// A point `gap` above (xi, eta) of the face along its normal there.
Vec3<double> pointAbove(const Vec3<double> (&corner)[4], double xi, double eta, double gap)
{
    const Projection<double> on = gapAt(seenFrom(corner, {0, 0, 0}), xi, eta);
    return pointOn(corner, xi, eta) + gap * on.normal;
}

} // namespace

TEST(FaceProjection, ShapeFunctionsAreAPartitionOfUnity)
{
    std::mt19937 random(35);
    for (int i = 0; i < 100; ++i) {
        double n[4];
        shapeFunctions(uniform(random, -2, 2), uniform(random, -2, 2), n);
        EXPECT_NEAR(n[0] + n[1] + n[2] + n[3], 1, 1e-15);
    }
    const double at[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int corner = 0; corner < 4; ++corner) {
        double n[4];
        shapeFunctions(at[corner][0], at[corner][1], n);
        for (int k = 0; k < 4; ++k) EXPECT_EQ(n[k], k == corner ? 1 : 0);
    }
}

TEST(FaceProjection, FindsPointsOverAParallelogramInOneStep)
{
    std::mt19937 random(36);
    for (int i = 0; i < 100; ++i) {
        const Vec3<double> origin = randomVector(random, 1), a = randomVector(random, 1);
        Vec3<double> b = randomVector(random, 1);
        if (length(cross(a, b)) < 0.3 * length(a) * length(b)) b = cross(a, b) + a;
        const Vec3<double> corner[4] = {origin, origin + a, origin + a + b, origin + b};
        const double xi = uniform(random, -0.5, 0.5), eta = uniform(random, -0.5, 0.5),
                     gap = uniform(random);
        const FaceCorners<double> face = seenFrom(corner, pointAbove(corner, xi, eta, gap));
        double foundXi = 0, foundEta = 0;
        double size;
        EXPECT_TRUE(projectionStep(face, foundXi, foundEta, size));
        EXPECT_NEAR(foundXi, xi, 1e-12);
        EXPECT_NEAR(foundEta, eta, 1e-12);
        EXPECT_NEAR(gapAt(face, foundXi, foundEta).gap, gap, 1e-12);
    }
}

TEST(FaceProjection, FindsPointsOverAPlaneQuadrilateral)
{
    std::mt19937 random(37);
    for (int i = 0; i < 200; ++i) {
        Vec3<double> corner[4] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        for (Vec3<double>& x : corner)
            x += Vec3<double>{0.3 * uniform(random), 0.3 * uniform(random), 0};
        const double xi = uniform(random), eta = uniform(random), gap = uniform(random, -0.5, 0.5);
        const FaceCorners<double> face = seenFrom(corner, pointAbove(corner, xi, eta, gap));
        double foundXi = 0, foundEta = 0;
        project(face, foundXi, foundEta);
        EXPECT_NEAR(foundXi, xi, 1e-12);
        EXPECT_NEAR(foundEta, eta, 1e-12);
        const Projection<double> found = gapAt(face, foundXi, foundEta);
        EXPECT_NEAR(found.gap, gap, 1e-12);
        EXPECT_NEAR(found.normal.z, 1, 1e-15);
    }
}

TEST(FaceProjection, ConvergesOnWarpedFaces)
{
    std::mt19937 random(38);
    for (int i = 0; i < 500; ++i) {
        Vec3<double> corner[4] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        for (Vec3<double>& x : corner) x += randomVector(random, 0.25);
        const double xi = uniform(random), eta = uniform(random), gap = uniform(random, -0.3, 0.3);
        const FaceCorners<double> face = seenFrom(corner, pointAbove(corner, xi, eta, gap));
        double foundXi = 0, foundEta = 0;
        project(face, foundXi, foundEta);
        EXPECT_NEAR(foundXi, xi, 1e-9);
        EXPECT_NEAR(foundEta, eta, 1e-9);
        EXPECT_NEAR(gapAt(face, foundXi, foundEta).gap, gap, 1e-9);
        Vec3<double> offset, t1, t2;
        evaluateFace(face, foundXi, foundEta, offset, t1, t2);
        EXPECT_LT(std::abs(dot(offset, t1)) + std::abs(dot(offset, t2)), 1e-9);
    }
}

TEST(FaceProjection, GapIsNegativeBehindTheFace)
{
    const Vec3<double> corner[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Projection<double> behind = gapAt(seenFrom(corner, {0.5, 0.5, -0.1}), 0.0, 0.0);
    EXPECT_DOUBLE_EQ(behind.gap, -0.1);
    EXPECT_DOUBLE_EQ(behind.normal.z, 1);
}

TEST(FaceProjection, LeavesTheFaceWhereThePointIsBesideIt)
{
    const Vec3<double> corner[4] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    double xi = 0, eta = 0;
    project(seenFrom(corner, {5, 1, 1}), xi, eta);
    EXPECT_NEAR(xi, 4, 1e-10);
    EXPECT_NEAR(eta, 0, 1e-10);
    EXPECT_EQ(clampedUnit(xi), 1);
    EXPECT_EQ(clampedUnit(-xi), -1);
    EXPECT_EQ(clampedUnit(0.25), 0.25);
}

TEST(FaceProjection, ADegenerateFaceStaysFinite)
{
    const Vec3<double> line[4] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    double xi = 0.1, eta = 0.2;
    const FaceCorners<double> face = seenFrom(line, {0.3, 0, 1});
    project(face, xi, eta);
    EXPECT_EQ(xi, 0.1);
    EXPECT_EQ(eta, 0.2);
    const Projection<double> found = gapAt(face, xi, eta);
    EXPECT_EQ(found.gap, 0);
    EXPECT_EQ(length(found.normal), 0);
}

TEST(FaceProjection, ConvergesInFloat)
{
    const FaceCorners<float> face{
        {{-1.2f, -0.9f, -0.5f}, {0.8f, -1.1f, -0.4f}, {0.9f, 1, -0.5f}, {-1, 0.9f, -0.3f}}};
    float xi = 0, eta = 0;
    project(face, xi, eta);
    Vec3<float> offset, t1, t2;
    evaluateFace(face, xi, eta, offset, t1, t2);
    EXPECT_LT(std::abs(dot(offset, t1)) + std::abs(dot(offset, t2)), 1e-5);
}
