#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace fpm;
using namespace fpm::test;

namespace {

constexpr double degree = std::numbers::pi / 180;

Corners moved(const Corners& x, const Matrix& rotation, const Vector& translation)
{
    return (x * rotation.transpose()).rowwise() + translation.transpose();
}

/// Largest corner displacement left when the rotation of the middle surface is taken out, as a
/// share of the element's size.
double leftOver(const Corners& before, const Corners& after)
{
    const Corners increment = after - before;
    const Matrix k = matrixOf(midSurfaceRotation(modesOf(after), modesOf(increment)));
    const Corners left = increment - before * k.transpose();
    const Corners shape = left.rowwise() - left.colwise().mean();
    return shape.cwiseAbs().maxCoeff()
           / (before.colwise().maxCoeff() - before.colwise().minCoeff()).maxCoeff();
}

Vector middleNormal(const Corners& x)
{
    const Modes<double> modes = modesOf(x);
    const Vec3<double>* a = modes.mode;
    const Vec3<double> n = cross(a[1], a[2]);
    return Vector(n.x, n.y, n.z).normalized();
}

} // namespace

TEST(Rotation, ARigidMotionOfAWarpedHexahedronLeavesNoDeformation)
{
    std::mt19937 random(4);
    for (int i = 0; i < 500; ++i) {
        const Corners x = warpedHexahedron(random);
        const Matrix r = turn(randomAxis(random), uniform(random, 0, 85) * degree);
        const Vector t = 3 * randomAxis(random);
        EXPECT_LT(leftOver(x, moved(x, r, t)), 1e-12);
    }
}

TEST(Rotation, LargeTurnsInTheMiddleSurfaceLeaveNoDeformation)
{
    std::mt19937 random(5);
    for (int i = 0; i < 500; ++i) {
        const Corners x = warpedHexahedron(random);
        const Matrix r = turn(middleNormal(x), uniform(random, -170, 170) * degree);
        EXPECT_LT(leftOver(x, moved(x, r, randomAxis(random))), 1e-12);
    }
}

TEST(Rotation, TurnsUpTo170DegreesAboutAnyAxisLeaveNoDeformation)
{
    std::mt19937 random(6);
    double worst = 0;
    for (int i = 0; i < 500; ++i) {
        const Corners x = warpedHexahedron(random);
        const Matrix r = turn(randomAxis(random), uniform(random, 0, 170) * degree);
        worst = std::max(worst, leftOver(x, moved(x, r, randomAxis(random))));
    }
    EXPECT_LT(worst, 1e-12);
}

TEST(Rotation, SmallTurnsKeepTheirDigits)
{
    std::mt19937 random(7);
    for (int i = 0; i < 100; ++i) {
        const Corners x = warpedHexahedron(random);
        const Vector axis = randomAxis(random);
        const double angle = 1e-9;
        // Increment of the rotation to first and second order, not a difference of coordinates.
        Matrix spin;
        spin << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
        const Matrix change = angle * spin + angle * angle / 2 * spin * spin;
        const Corners increment = x * change.transpose();
        const Matrix k = matrixOf(midSurfaceRotation(modesOf(x + increment), modesOf(increment)));
        EXPECT_LT((k - change).cwiseAbs().maxCoeff(), 1e-13 * angle);
    }
}

TEST(Rotation, IsZeroForNoMotionAndForAUniformSwelling)
{
    std::mt19937 random(8);
    const Corners x = warpedHexahedron(random);
    const Modes<double> still{};
    EXPECT_EQ(matrixOf(midSurfaceRotation(modesOf(x), still)).cwiseAbs().maxCoeff(), 0);
    const Corners swollen = 1.5 * x;
    const Matrix k = matrixOf(midSurfaceRotation(modesOf(swollen), modesOf(swollen - x)));
    EXPECT_LT(k.cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Rotation, FollowsTheMiddleSurfaceOfAShearedBrick)
{
    // Shear that tilts the vertical edges only: the middle surface does not turn. Shear that tilts
    // the middle surface: all of it counts.
    const Corners x = brick(1, 1, 1);
    Matrix lean = Matrix::Identity(), tilt = Matrix::Identity();
    lean(0, 2) = 0.3;
    tilt(2, 0) = 0.3;
    const Corners leant = x * lean.transpose(), tilted = x * tilt.transpose();
    EXPECT_LT(matrixOf(midSurfaceRotation(modesOf(leant), modesOf(leant - x))).norm(), 1e-15);
    const Matrix k = matrixOf(midSurfaceRotation(modesOf(tilted), modesOf(tilted - x)));
    const Matrix exact = turn(Vector::UnitY(), -std::atan(0.3)) - Matrix::Identity();
    EXPECT_LT((k - exact).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Rotation, TurnsTheStressExactlyWithARigidElement)
{
    std::mt19937 random(9);
    for (int i = 0; i < 200; ++i) {
        const Corners x = warpedHexahedron(random);
        Element<Elastic, StiffnessHourglass> element(materialOf(1, 0.3), x);
        const Matrix stress = randomSymmetric(random, 1);
        element.state.stress = symmetric(stress);
        const Matrix r = turn(randomAxis(random), uniform(random, 0, 85) * degree);
        element.advance(moved(x, r, randomAxis(random)));
        EXPECT_LT((element.stress() - r * stress * r.transpose()).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(Rotation, OfATensorIsKSPlusTheTensor)
{
    std::mt19937 random(10);
    const Matrix r = turn(randomAxis(random), 1.2), s = randomSymmetric(random, 1);
    const Matrix k = r - Matrix::Identity();
    const Mat3<double> rows{
        {k(0, 0), k(0, 1), k(0, 2)}, {k(1, 0), k(1, 1), k(1, 2)}, {k(2, 0), k(2, 1), k(2, 2)}};
    const Matrix turned = matrixOf(rotated(rows, symmetric(s)));
    EXPECT_LT((turned - r * s * r.transpose()).cwiseAbs().maxCoeff(), 1e-15);
}
