#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

/// The four sign patterns of Flanagan and Belytschko at the corners, in the order of Q.
Eigen::Matrix<double, 8, 4> patterns()
{
    Eigen::Matrix<double, 8, 4> out;
    for (int i = 0; i < 8; ++i) {
        const double* s = cornerSign[i];
        out.row(i) << s[1] * s[2], s[2] * s[0], s[0] * s[1], s[0] * s[1] * s[2];
    }
    return out;
}

/// A random displacement without any mean gradient: hourglass patterns minus their linear part.
Corners hourglassField(std::mt19937& random, const Corners& x, double size)
{
    const Corners b = cornerGradient(meanGradient(modesOf(x)));
    Corners field = Corners::Zero();
    for (int j = 0; j < 4; ++j) field += size * patterns().col(j) * randomAxis(random).transpose();
    const Corners centred = x.rowwise() - x.colwise().mean();
    return field - centred * (b.transpose() * field) / volumeOf(x);
}

/// Trapezoidal work of the corner forces on a random walk of small hourglass steps, and what the
/// element booked on the way.
template <class Element>
double walk(std::mt19937& random, Element& element, double size, int steps)
{
    double work = 0;
    for (int n = 0; n < steps; ++n) {
        const Corners before = element.force;
        const Corners move = hourglassField(random, element.x, size);
        element.advance(element.x + move);
        work += workOf(before + element.force, move) / 2;
    }
    return work;
}

} // namespace

TEST(Hourglass, StiffnessFormIsTheFormulaOfFlanaganAndBelytschko)
{
    std::mt19937 random(21);
    const Corners x = warpedHexahedron(random);
    MaterialConstants<double> m = materialOf(1, 0.3);
    m.hourglass = 0.05;
    Element<Elastic, StiffnessHourglass> element(m, x);
    const Corners move = hourglassField(random, x, 1e-8);
    element.advance(x + move);
    const Corners b = cornerGradient(meanGradient(modesOf(x)));
    const double k = 0.05 * m.pressureWaveModulus * b.squaredNorm() / (8 * volumeOf(x));
    const Eigen::Matrix<double, 8, 4> pattern = patterns(),
                                      gamma = pattern - b * (x.transpose() * pattern) / volumeOf(x);
    double energy = 0;
    for (int j = 0; j < 4; ++j) {
        const Vector q = move.transpose() * gamma.col(j);
        energy += k / 2 * q.squaredNorm();
        const Vec3<double>& stored = element.state.hourglass[j];
        EXPECT_LT((Vector(stored.x, stored.y, stored.z) - k * q).norm(), 1e-6 * k * q.norm());
    }
    const Corners force = k * gamma * (gamma.transpose() * move);
    EXPECT_LT((element.force - force).norm(), 1e-6 * force.norm());
    EXPECT_NEAR(element.step.hourglass, energy, 1e-6 * energy);
}

TEST(Hourglass, StiffnessAndPhysicalWorkEqualTheWorkOfTheCornerForces)
{
    std::mt19937 random(22);
    for (int i = 0; i < 20; ++i) {
        const Corners x = warpedHexahedron(random);
        Element<Elastic, StiffnessHourglass> artificial(materialOf(1, 0.3), x);
        Element<Elastic, PhysicalHourglass> physical(materialOf(1, 0.3), x);
        const double first = walk(random, artificial, 1e-5, 50);
        EXPECT_NEAR(artificial.work, first, 1e-4 * first);
        const double second = walk(random, physical, 1e-5, 50);
        EXPECT_NEAR(physical.work, second, 1e-4 * second);
    }
}

TEST(Hourglass, WorkOfAYieldingSectionEqualsTheWorkOfTheCornerForces)
{
    std::mt19937 random(23);
    MaterialConstants<double> m = materialOf(1, 0.3, 1e-5, 0.1);
    m.coupledHourglass = 1;
    for (int i = 0; i < 20; ++i) {
        Element<J2Plasticity, PhysicalHourglass> element(m, warpedHexahedron(random));
        const double work = walk(random, element, 2e-6, 200);
        EXPECT_GT(element.state.equivalentPlasticStrain, 1e-6);
        EXPECT_NEAR(element.work, work, 1e-4 * work);
    }
}

TEST(Hourglass, ViscousWorkIsTheForceTimesTheMoveAndLeavesNothingBehind)
{
    std::mt19937 random(24);
    MaterialConstants<double> m = materialOf(1, 0.3);
    m.hourglass = 0.1;
    const Corners x = warpedHexahedron(random);
    Element<Elastic, ViscousHourglass> element(m, x);
    const double rate = 1e3;
    const Corners move = hourglassField(random, x, 1e-7);
    element.advance(x + move, rate);
    EXPECT_GT(element.step.hourglass, 0);
    EXPECT_NEAR(element.step.hourglass, workOf(element.force, move), 1e-4 * element.step.hourglass);
    element.advance(element.x, rate);
    EXPECT_EQ(element.step.hourglass, 0);
    EXPECT_LT(element.force.norm(), 1e-10);
}

TEST(Hourglass, ViscousCoefficientOfACubeIsTheOneOfTheManuals)
{
    // C = Q_h rho V^(2/3) c_d / 4.
    const double density = 3, side = 2;
    MaterialConstants<double> m = materialOf(5, 0.3);
    m.hourglass = 0.1;
    const Corners x = brick(side, side, side);
    Element<Elastic, ViscousHourglass> element(m, x);
    element.mass = density * side * side * side;
    const double c = 0.1 * side * side * std::sqrt(density * m.pressureWaveModulus) / 4, rate = 10,
                 size = 1e-9;
    Corners move = Corners::Zero();
    for (int i = 0; i < 8; ++i) move(i, 0) = size * cornerSign[i][1] * cornerSign[i][2];
    element.advance(x + move, rate);
    const double q = c * 8 * size * rate;
    for (int i = 0; i < 8; ++i)
        EXPECT_NEAR(element.force(i, 0), q * cornerSign[i][1] * cornerSign[i][2], 1e-6 * q);
}

TEST(Hourglass, ForcesTurnWithTheElement)
{
    std::mt19937 random(25);
    const Corners x = warpedHexahedron(random), move = hourglassField(random, x, 1e-3);
    Element<Elastic, StiffnessHourglass> artificial(materialOf(1, 0.3), x);
    Element<Elastic, PhysicalHourglass> physical(materialOf(1, 0.3), x);
    const Matrix r = turn(randomAxis(random), 1.3);
    const auto check = [&](auto& element) {
        element.advance(x + move);
        const Corners before = element.force;
        element.advance((x + move) * r.transpose());
        EXPECT_LT((element.force - before * r.transpose()).cwiseAbs().maxCoeff(),
                  1e-12 * before.norm());
        EXPECT_LT(std::abs(element.step.hourglass), 1e-12 * element.work);
    };
    check(artificial);
    check(physical);
}

TEST(Hourglass, ViscousDampingTakesLessThanTwiceTheVelocityAtTheStableStep)
{
    // v' = (1 - 16 Q_h / sqrt 3) v for a hourglass mode of any brick: 0.076 for Q_h = 0.1; the
    // explicit step would grow from Q_h = 0.216 on.
    std::mt19937 random(45);
    MaterialConstants<double> m = materialOf(1, 0.3);
    m.hourglass = 0.1;
    for (int i = 0; i < 20; ++i) {
        const Corners x =
            brick(uniform(random, 0.1, 3), uniform(random, 0.1, 3), uniform(random, 0.1, 3));
        Element<Elastic, ViscousHourglass> element(m, x);
        element.mass = volumeOf(x);
        element.advance(x);
        const double dt = element.step.stableTimeStep;
        const Corners velocity = 1e-6 / dt * patterns().col(1) * Eigen::RowVector3d(0, 1, 0);
        element.advance(x + dt * velocity, 1 / dt);
        const Corners after = velocity - dt / (element.mass / 8) * element.force;
        const double factor = 1 - 16 * 0.1 / std::sqrt(3.0);
        EXPECT_LT((after - factor * velocity).norm(), 1e-3 * velocity.norm());
    }
}
