#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace fpm;
using namespace fpm::test;

// The three other ways to find the rotation of a step, and what each of them gives for stresses:
// the rates of Jaumann (hughesWinget), of the polar rotation, and of the middle surface.

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr RotationRule everyRule[] = {RotationRule::midSurface, RotationRule::arcsine,
                                      RotationRule::polar, RotationRule::hughesWinget};
constexpr RotationRule soundRules[] = {RotationRule::midSurface, RotationRule::polar,
                                       RotationRule::hughesWinget};

Corners moved(const Corners& x, const Matrix& rotation, const Vector& translation)
{
    return (x * rotation.transpose()).rowwise() + translation.transpose();
}

/// Rotation of one step by a rule, R - I.
template <class T = double>
Matrix rotationBy(RotationRule rule, const Corners& before, const Corners& after)
{
    Modes<T> x = modesOf<T>(Corners(after.rowwise() - after.row(0))),
             w = modesOf<T>(Corners(after - before)), middle;
    return matrixOf(removeRotation(rule, T(0.5), x, w, middle));
}

template <class T = double>
MaterialConstants<T> generalMaterial(
    RotationRule rule, double young, double poisson, double yield = 1e30, double modulus = 0)
{
    MaterialConstants<T> m = materialOf<T>(young, poisson, yield, modulus);
    m.general.rotation = rule;
    if (yield >= 1e30) m.rows = 0;
    return m;
}

/// Polar rotation by singular values: independent of the kernel's iteration.
Matrix polar(const Matrix& f)
{
    const Eigen::JacobiSVD<Matrix> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
}

template <class Hourglass = StiffnessHourglass, class T = double>
using GeneralElement = Element<GeneralPlasticity, Hourglass, T>;

/// Stress over the shear modulus after simple shear x = X + gamma Y of a cube.
Matrix sheared(RotationRule rule, double gamma, int steps, int plane = 0)
{
    const double young = 2.6, poisson = 0.3; // mu = 1
    const Corners start = brick(1, 1, 1);
    GeneralElement<> element(generalMaterial(rule, young, poisson), start);
    const int along = plane, across = (plane + 1) % 3;
    for (int n = 1; n <= steps; ++n) {
        Corners next = start;
        next.col(along) += gamma * n / steps * start.col(across);
        element.advance(next);
    }
    Matrix out = element.stress();
    return (Matrix() << out(along, along), out(along, across), 0, out(across, along),
            out(across, across), 0, 0, 0, out.trace())
        .finished();
}

} // namespace

TEST(RotationRules, ARigidMotionOfAWarpedHexahedronIsTheRotationOfSoundRules)
{
    std::mt19937 random(61);
    for (int i = 0; i < 200; ++i) {
        const Corners x = warpedHexahedron(random);
        const Matrix r = turn(randomAxis(random), uniform(random, 0, 80) * degree);
        const Corners y = moved(x, r, 3 * randomAxis(random));
        for (const RotationRule rule : soundRules)
            EXPECT_LT((rotationBy(rule, x, y) + Matrix::Identity() - r).cwiseAbs().maxCoeff(),
                      1e-12)
                << int(rule);
    }
}

TEST(RotationRules, PolarIsThatOfTheMeanDeformationGradient)
{
    std::mt19937 random(62);
    for (int i = 0; i < 100; ++i) {
        const Corners x = warpedHexahedron(random);
        const Matrix f = Matrix::Identity() + randomMatrix(random, 0.05);
        const Corners y = x * f.transpose();
        EXPECT_LT((rotationBy(RotationRule::polar, x, y) + Matrix::Identity() - polar(f)).norm(),
                  1e-11);
    }
}

TEST(RotationRules, PolarAndSpinDoNotDependOnTheNumberingOfTheCorners)
{
    std::mt19937 random(63);
    const int order[8] = {4, 0, 3, 7, 5, 1, 2, 6}; // another face at the bottom
    double middleSurface = 0;
    for (int i = 0; i < 50; ++i) {
        const Corners x = warpedHexahedron(random), y = x + randomCorners(random, 0.03);
        Corners xr, yr;
        for (int k = 0; k < 8; ++k) {
            xr.row(k) = x.row(order[k]);
            yr.row(k) = y.row(order[k]);
        }
        const auto change = [&](RotationRule rule) {
            return (rotationBy(rule, x, y) - rotationBy(rule, xr, yr)).norm();
        };
        EXPECT_LT(change(RotationRule::polar), 1e-12);
        EXPECT_LT(change(RotationRule::hughesWinget), 1e-12);
        middleSurface = std::max(middleSurface, change(RotationRule::midSurface));
    }
    EXPECT_GT(middleSurface, 1e-3);
}

// benchmark A3: s12 / G and s11 / G of Jaumann, sin(gamma) and 1 - cos(gamma).
TEST(RotationRules, HughesWingetGivesTheJaumannRateInSimpleShear)
{
    for (const double gamma : {0.5, 1.0, 2.0, 3.0, 4.0})
        for (const int plane : {0, 1, 2}) {
            const Matrix s = sheared(RotationRule::hughesWinget, gamma, 2000, plane);
            EXPECT_NEAR(s(0, 1), std::sin(gamma), 2e-6);
            EXPECT_NEAR(s(0, 0), 1 - std::cos(gamma), 2e-6);
            EXPECT_NEAR(s(1, 1), std::cos(gamma) - 1, 2e-6);
        }
}

/// Polar rotations of the single steps: their spin is that of the mean gradient in the limit of
/// small steps, so many steps of `polar` give the Jaumann rate as well.
TEST(RotationRules, IncrementalPolarTendsToTheJaumannRateToo)
{
    for (const double gamma : {1.0, 4.0})
        for (const int plane : {0, 1, 2}) {
            const Matrix s = sheared(RotationRule::polar, gamma, 2000, plane);
            EXPECT_NEAR(s(0, 1), std::sin(gamma), 1e-5);
            EXPECT_NEAR(s(0, 0), 1 - std::cos(gamma), 1e-5);
        }
}

TEST(RotationRules, ErrorsInSimpleShearAreOfSecondOrder)
{
    for (const RotationRule rule : {RotationRule::hughesWinget, RotationRule::polar}) {
        const double coarse = std::abs(sheared(rule, 2, 50)(0, 1) - std::sin(2.0)),
                     fine = std::abs(sheared(rule, 2, 100)(0, 1) - std::sin(2.0));
        EXPECT_NEAR(coarse / fine, 4, 0.3) << int(rule);
    }
}

// The middle surface is spanned by xi and eta. Its rotation in simple shear depends on which plane
// is sheared: along the surface it stands still and the stress is G gamma; across it turns with the
// whole shear and the stress at gamma = 1 is G ln 2; in its plane it lies between.
TEST(RotationRules, TheMiddleSurfaceGivesAStressThatDependsOnTheNumbering)
{
    EXPECT_NEAR(sheared(RotationRule::midSurface, 1, 1000, 0)(0, 1), 0.8898, 1e-4);
    EXPECT_NEAR(sheared(RotationRule::midSurface, 1, 1000, 1)(0, 1), 1, 1e-6);
    EXPECT_NEAR(sheared(RotationRule::midSurface, 1, 1000, 2)(0, 1), std::log(2.0), 1e-6);
}

TEST(RotationRules, AStressedElementThatTurnsKeepsItsStress)
{
    std::mt19937 random(64);
    const Matrix initial = (Matrix() << 100, 30, 0, 30, -50, 0, 0, 0, 20).finished();
    const Vector axis = Vector(1, 1, 1).normalized();
    for (const RotationRule rule : soundRules)
        for (const int steps : {36, 360}) {
            const Corners x = warpedHexahedron(random);
            GeneralElement<> element(generalMaterial(rule, 2.1e5, 0.3), x);
            element.state.stress = symmetric(initial);
            for (int n = 1; n <= steps; ++n)
                element.advance(moved(x, turn(axis, 2 * std::numbers::pi * n / steps), axis));
            EXPECT_LT((element.stress() - initial).norm(), 1e-9 * initial.norm()) << int(rule);
            EXPECT_LT(std::abs(element.work), 1e-9);
        }
}

TEST(RotationRules, FloatElementsThatTurnKeepTheirStress)
{
    std::mt19937 random(65);
    const Corners x = warpedHexahedron(random);
    const Vector axis = randomAxis(random);
    for (const RotationRule rule : soundRules) {
        GeneralElement<StiffnessHourglass, float> element(generalMaterial<float>(rule, 1000, 0.3),
                                                          x);
        element.state.stress = symmetric<float>(Vector(1, -0.5, 0.2).asDiagonal());
        const double start = mises(element.stress());
        for (int n = 1; n <= 2000; ++n)
            element.advance(moved(x, turn(axis, 20 * std::numbers::pi * n / 2000), Vector::Zero()));
        EXPECT_NEAR(mises(element.stress()), start, 1e-3 * start) << int(rule);
    }
}

TEST(RotationRules, StretchWhileTurningIsTurnedStretch)
{
    std::mt19937 random(66);
    const Corners x = warpedHexahedron(random);
    const Vector axis = randomAxis(random);
    const int steps = 400;
    for (const RotationRule rule : soundRules) {
        GeneralElement<> turning(generalMaterial(rule, 1, 0.3), x),
            still(generalMaterial(rule, 1, 0.3), x);
        Matrix r = Matrix::Identity();
        for (int n = 1; n <= steps; ++n) {
            Matrix f = Matrix::Identity();
            f(0, 0) += 0.1 * n / steps;
            r = turn(axis, 90 * degree * n / steps);
            still.advance(x * f.transpose());
            turning.advance(x * f.transpose() * r.transpose());
        }
        const Matrix expected = r * still.stress() * r.transpose();
        EXPECT_LT((turning.stress() - expected).norm(), 1e-6 * expected.norm()) << int(rule);
    }
}

TEST(RotationRules, RunTimeMiddleSurfaceEqualsTheFixedOneToTheLastBit)
{
    std::mt19937 random(67);
    int yielding = 0;
    for (int i = 0; i < 50; ++i) {
        const Corners x = warpedHexahedron(random), y = x + randomCorners(random, 0.03);
        const auto m = generalMaterial(RotationRule::midSurface, 1, 0.3, 0.001, 0.1);
        GeneralElement<> general(m, x);
        Element<J2Plasticity, StiffnessHourglass> plain(m, x);
        general.advance(y);
        plain.advance(y);
        yielding += plain.step.plasticStrainIncrement > 0;
        EXPECT_EQ(general.stress(), plain.stress());
        EXPECT_EQ(general.force, plain.force);
    }
    EXPECT_GT(yielding, 30);
}

TEST(RotationRules, EveryRuleDoesTheWorkOfItsForces)
{
    std::mt19937 random(68);
    for (const RotationRule rule : everyRule) {
        const Corners x = warpedHexahedron(random);
        GeneralElement<> element(generalMaterial(rule, 1, 0.3), x);
        const Matrix f = randomSymmetric(random, 2e-4);
        double work = 0;
        Corners before = Corners::Zero();
        for (int n = 1; n <= 20; ++n) {
            const Corners next = x + n * (x * f.transpose());
            const Corners move = next - element.x;
            element.advance(next);
            work += workOf(before + element.force, move) / 2;
            before = element.force;
        }
        if (rule == RotationRule::arcsine) continue; // its spurious turns are no motion of the body
        EXPECT_NEAR(element.work, work, 1e-2 * work) << int(rule);
    }
}

// The paper's arcsines, as printed.

TEST(ArcsineRotation, IsRightForClockwiseTurnsInThePlaneAndWrongForTheOthers)
{
    const Corners x = brick(1, 0.7, 0.3);
    for (const double angle : {-40.0, -1.0, -0.01})
        EXPECT_LT((rotationBy(RotationRule::arcsine, x,
                              moved(x, turn({0, 0, 1}, angle * degree), Vector::Zero()))
                   + Matrix::Identity() - turn({0, 0, 1}, angle * degree))
                      .norm(),
                  1e-12);
    for (const double angle : {0.01, 1.0, 40.0})
        EXPECT_LT((rotationBy(RotationRule::arcsine, x,
                              moved(x, turn({0, 0, 1}, angle * degree), Vector::Zero()))
                   + Matrix::Identity() - turn({0, 0, 1}, -angle * degree))
                      .norm(),
                  1e-12);
}

TEST(ArcsineRotation, IsRightForTurnsOutOfThePlaneUpToARightAngle)
{
    const Corners x = brick(1, 0.7, 0.3);
    const Vector axis = Vector(1, 2, 0).normalized();
    for (const double angle : {-89.0, -5.0, 5.0, 89.0}) {
        const Matrix r = turn(axis, angle * degree);
        EXPECT_LT((rotationBy(RotationRule::arcsine, x, moved(x, r, Vector::Zero()))
                   + Matrix::Identity() - r)
                      .norm(),
                  1e-10);
    }
    // Of 100 degrees the arcsine makes 80.
    const Corners beyond = moved(x, turn(axis, 100 * degree), Vector::Zero());
    const SurfaceTilt<double> tilt =
        surfaceTilt<true>(modesOf(beyond), modesOf(Corners(beyond - x)));
    EXPECT_LT((matrixOf(tilt.tilt) + Matrix::Identity() - turn(axis, 80 * degree)).norm(), 1e-10);
}

TEST(ArcsineRotation, TakesTheMeanOfTheFourArcsines)
{
    std::mt19937 random(69);
    for (int i = 0; i < 100; ++i) {
        Corners x = brick(1, 0.7, 0.3), y = x;
        Eigen::Matrix<double, 4, 3> before, after;
        for (int c = 0; c < 4; ++c) {
            const Vector move(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2), 0);
            y.row(c) += move;
            y.row(c + 4) += move;
            before.row(c) = x.row(c) + x.row(c + 4);
            after.row(c) = y.row(c) + y.row(c + 4);
        }
        before.rowwise() -= Eigen::RowVector3d(before.colwise().mean());
        after.rowwise() -= Eigen::RowVector3d(after.colwise().mean());
        double mean = 0;
        for (int c = 0; c < 4; ++c) {
            const Vector a = before.row(c), b = after.row(c);
            mean += std::asin(b.cross(a).norm() / (a.norm() * b.norm())) / 4;
        }
        EXPECT_LT(
            (rotationBy(RotationRule::arcsine, x, y) + Matrix::Identity() - turn({0, 0, 1}, -mean))
                .norm(),
            1e-12);
    }
}

TEST(ArcsineRotation, FailsForHalfOfAllSmallRotations)
{
    std::mt19937 random(70);
    int wrong = 0;
    for (int i = 0; i < 400; ++i) {
        const Corners x = warpedHexahedron(random, 0);
        const Matrix r = turn(randomAxis(random), degree);
        const double error = (rotationBy(RotationRule::arcsine, x, moved(x, r, Vector::Zero()))
                              + Matrix::Identity() - r)
                                 .norm();
        wrong += error > 1e-6;
    }
    EXPECT_NEAR(wrong, 200, 40);
}
