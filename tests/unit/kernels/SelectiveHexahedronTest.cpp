#include "kernels/element/SelectiveHexahedron.h"

#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace fpm;
using namespace fpm::test;

// The eight-point element with mean dilatation, against Gauss integration written with Eigen.

namespace {

/// One selective element that follows prescribed corner positions.
template <class T = double>
struct Selective {
    struct Store {
        ElementState<T>* state;
        void read(int point, ElementState<T>& to) const { to = state[point]; }
        void store(int point, const ElementState<T>& from, const ElementStep<T>& taken) const
        {
            state[point] = from;
            state[point].equivalentPlasticStrain += taken.plasticStrainIncrement;
            state[point].temperatureRise += taken.temperatureIncrement;
        }
    };
    MaterialConstants<T> material;
    Corners x;
    double mass = 1;
    ElementState<T> state[8]{};
    ElementStep<T> step{};
    Corners force = Corners::Zero();
    double work = 0;

    Selective(const MaterialConstants<T>& m, const Corners& start) : material(m), x(start) {}
    void advance(const Corners& next, double rate = 0)
    {
        const Corners increment = next - x, shape = next.rowwise() - next.row(0);
        Modes<T> w = modesOf<T>(increment);
        step = updateSelective<GeneralPlasticity>(material, modesOf<T>(shape), w, T(mass), T(rate),
                                                  Store{state});
        force = cornersOf(w);
        work += double(step.internal);
        x = next;
    }
    Matrix stress(int point) const { return matrixOf(state[point].stress); }
};

MaterialConstants<double> elasticOf(double young, double poisson)
{
    MaterialConstants<double> m = materialOf(young, poisson);
    m.rows = 0;
    return m;
}

/// Gradients of the shape functions and weight at a Gauss point.
struct GaussPoint {
    Corners gradient;
    double volume;
    GaussPoint(const Corners& x, int point)
    {
        const double g = 1 / std::sqrt(3.0);
        const double at[3] = {point & 1 ? g : -g, point & 2 ? g : -g, point & 4 ? g : -g};
        Corners local;
        for (int i = 0; i < 8; ++i)
            for (int c = 0; c < 3; ++c) {
                local(i, c) = cornerSign[i][c] / 8;
                for (int d = 0; d < 3; ++d)
                    if (d != c) local(i, c) *= 1 + cornerSign[i][d] * at[d];
            }
        const Matrix jacobian = x.transpose() * local; // dx_i / dxi_k
        volume = jacobian.determinant();
        gradient = local * jacobian.inverse();
    }
};

using Stiffness = Eigen::Matrix<double, 24, 24>;
using StrainMatrix = Eigen::Matrix<double, 6, 24>;

StrainMatrix strainMatrix(const Corners& gradient)
{
    StrainMatrix b = StrainMatrix::Zero();
    for (int i = 0; i < 8; ++i)
        for (int c = 0; c < 3; ++c) {
            const int d = (c + 1) % 3;
            b(c, 3 * i + c) = gradient(i, c);
            b(3 + c, 3 * i + c) = gradient(i, d); // engineering shear c-d
            b(3 + c, 3 * i + d) = gradient(i, c);
        }
    return b;
}

/// sum V B^T D B, with the mean dilatation or, without, the plain full integration.
Stiffness gaussStiffness(const MaterialConstants<double>& m, const Corners& x, bool meanDilatation)
{
    Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
    d.topLeftCorner<3, 3>().setConstant(m.lambda);
    for (int c = 0; c < 3; ++c) {
        d(c, c) += m.twoMu;
        d(3 + c, 3 + c) = m.twoMu / 2;
    }
    Eigen::Matrix<double, 1, 24> mean = Eigen::Matrix<double, 1, 24>::Zero();
    double volume = 0;
    for (int p = 0; p < 8; ++p) {
        const GaussPoint point(x, p);
        mean += point.volume * strainMatrix(point.gradient).topRows<3>().colwise().sum();
        volume += point.volume;
    }
    mean /= volume;
    Stiffness k = Stiffness::Zero();
    for (int p = 0; p < 8; ++p) {
        const GaussPoint point(x, p);
        StrainMatrix b = strainMatrix(point.gradient);
        if (meanDilatation) {
            const Eigen::Matrix<double, 1, 24> rest = (mean - b.topRows<3>().colwise().sum()) / 3;
            for (int c = 0; c < 3; ++c) b.row(c) += rest;
        }
        k += point.volume * b.transpose() * d * b;
    }
    return k;
}

double stableStep(const MaterialConstants<double>& m, const Corners& x, double mass)
{
    Selective<> element(m, x);
    element.mass = mass;
    element.advance(x);
    return element.step.stableTimeStep;
}

double exactStep(const Stiffness& k, double mass)
{
    const Eigen::SelfAdjointEigenSolver<Stiffness> modes(k / (mass / 8));
    return 2 / std::sqrt(modes.eigenvalues().maxCoeff());
}

} // namespace

TEST(SelectiveHexahedron, ForcesAreThoseOfGaussIntegrationWithMeanDilatation)
{
    std::mt19937 random(81);
    for (int i = 0; i < 50; ++i) {
        const Corners x = warpedHexahedron(random), u = randomCorners(random, 1e-8);
        const auto m = elasticOf(3, uniform(random, -0.4, 0.49));
        Selective<> element(m, x);
        element.advance(x + u);
        Eigen::Matrix<double, 24, 1> moved;
        for (int c = 0; c < 24; ++c) moved(c) = u(c / 3, c % 3);
        const Eigen::Matrix<double, 24, 1> exact = gaussStiffness(m, x, true) * moved;
        double difference = 0;
        for (int c = 0; c < 24; ++c)
            difference = std::max(difference, std::abs(element.force(c / 3, c % 3) - exact(c)));
        EXPECT_LT(difference, 1e-6 * exact.cwiseAbs().maxCoeff());
    }
}

TEST(SelectiveHexahedron, AnyLinearFieldIsTheOnePointElementWithTheSameSpin)
{
    std::mt19937 random(82);
    for (int i = 0; i < 50; ++i) {
        const Corners start = warpedHexahedron(random);
        MaterialConstants<double> m = materialOf(1, 0.3, 0.02, 0.1);
        m.general.rotation = RotationRule::hughesWinget;
        m.linearViscosity = 0.06;
        m.quadraticViscosity = 1.2;
        if (i % 2) { // backstress, power law, rate and heat
            m.general.kinematicModulus = 0.05;
            m.general.powerModulus = 0.03;
            m.general.powerExponent = 0.4;
            m.general.rateLaw = RateLaw::cowperSymonds;
            m.general.referenceRate = 2;
            m.general.rateCoefficient = 0.25;
            m.general.heatPerWork = 5;
            m.general.temperature = m.general.roomTemperature = 293;
            m.general.softeningExponent = 1.1;
            m.general.inverseMeltingRange = 1e-3;
        }
        Selective<> selective(m, start);
        Element<GeneralPlasticity, StiffnessHourglass> reduced(m, start);
        Matrix f = Matrix::Identity();
        for (int n = 0; n < 10; ++n) {
            f = (Matrix::Identity() + randomMatrix(random, 0.03)) * f;
            selective.advance(start * f.transpose(), 5);
            reduced.advance(start * f.transpose(), 5);
        }
        EXPECT_GT(reduced.state.equivalentPlasticStrain, 0.01);
        for (int p = 0; p < 8; ++p) {
            EXPECT_LT((selective.stress(p) - reduced.stress()).cwiseAbs().maxCoeff(), 1e-13);
            EXPECT_NEAR(selective.state[p].equivalentPlasticStrain,
                        reduced.state.equivalentPlasticStrain, 1e-13);
            EXPECT_LT((matrixOf(selective.state[p].backstress) - matrixOf(reduced.state.backstress))
                          .cwiseAbs()
                          .maxCoeff(),
                      1e-13);
            EXPECT_NEAR(selective.state[p].temperatureRise, reduced.state.temperatureRise, 1e-13);
        }
        EXPECT_LT((selective.force - reduced.force).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_NEAR(selective.step.internal, reduced.step.internal, 1e-13);
        EXPECT_NEAR(selective.step.plastic, reduced.step.plastic, 1e-13);
        EXPECT_NEAR(selective.step.bulkViscosity, reduced.step.bulkViscosity, 1e-13);
    }
}

// Benchmark A2: a stressed element that turns keeps its stress, whatever the size of the steps.
TEST(SelectiveHexahedron, AStressedElementThatTurnsKeepsItsStress)
{
    std::mt19937 random(83);
    const Vector axis = Vector(1, 1, 1).normalized();
    const Matrix initial = (Matrix() << 100, 30, 0, 30, -50, 0, 0, 0, 20).finished();
    for (const int steps : {8, 36, 360}) {
        const Corners x = warpedHexahedron(random);
        Selective<> element(elasticOf(2.1e5, 0.3), x);
        for (auto& state : element.state) state.stress = symmetric(initial);
        for (int n = 1; n <= steps; ++n) {
            const Matrix r = turn(axis, 2 * std::numbers::pi * n / steps);
            element.advance((x * r.transpose()).rowwise() + axis.transpose());
            const Corners exact = element.force;
            EXPECT_LT(exact.colwise().sum().norm(), 1e-11 * exact.norm());
        }
        for (int p = 0; p < 8; ++p)
            EXPECT_LT((element.stress(p) - initial).norm(), 1e-9 * initial.norm());
        EXPECT_LT(std::abs(element.work), 1e-8);
    }
}

TEST(SelectiveHexahedron, AFloatElementThatTurnsKeepsItsStress)
{
    std::mt19937 random(84);
    const Corners x = warpedHexahedron(random);
    const Vector axis = randomAxis(random);
    MaterialConstants<float> m = materialOf<float>(1000, 0.3);
    Selective<float> element(m, x);
    for (auto& state : element.state)
        state.stress = symmetric<float>(Vector(1, -0.5, 0.2).asDiagonal());
    const double start = mises(element.stress(0));
    for (int n = 1; n <= 2000; ++n)
        element.advance(x * turn(axis, 20 * std::numbers::pi * n / 2000).transpose());
    for (int p = 0; p < 8; ++p) EXPECT_NEAR(mises(element.stress(p)), start, 2e-3 * start);
}

TEST(SelectiveHexahedron, ItsForcesDoTheWorkOfItsStress)
{
    std::mt19937 random(85);
    const Corners x = warpedHexahedron(random);
    Selective<> element(elasticOf(1, 0.3), x);
    const Corners velocity = randomCorners(random, 2e-3);
    double work = 0;
    Corners before = Corners::Zero();
    for (int n = 1; n <= 50; ++n) {
        element.advance(x + n * velocity);
        work += workOf(before + element.force, velocity) / 2;
        before = element.force;
    }
    EXPECT_NEAR(element.work, work, 1e-3 * work);
}

// Locking: of the 18 ways to deform only one may be stiff against change of volume.
TEST(SelectiveHexahedron, HasOneIncompressibilityConstraint)
{
    std::mt19937 random(86);
    const auto stiffModes = [](const Stiffness& k, double mu) {
        const Eigen::SelfAdjointEigenSolver<Stiffness> modes(k);
        return (modes.eigenvalues().array() > 50 * mu).count();
    };
    const auto softModes = [](const Stiffness& k, double mu) {
        const Eigen::SelfAdjointEigenSolver<Stiffness> modes(k);
        return (modes.eigenvalues().array() < 1e-6 * mu).count();
    };
    for (int i = 0; i < 20; ++i) {
        const Corners x = warpedHexahedron(random, 0.1);
        const auto m = elasticOf(3, 0.4999);
        EXPECT_EQ(stiffModes(gaussStiffness(m, x, true), 1), 1);
        EXPECT_GE(stiffModes(gaussStiffness(m, x, false), 1), 7);
        EXPECT_EQ(softModes(gaussStiffness(m, x, true), 1), 6); // no hourglass modes
    }
}

// Bending u = x z of a brick, length a, height h: the deviator of the fibre strain and a parasitic
// shear. The energy over that of a beam is (2/3 + (a/h)^2 / 2) / (1 + nu): at nu = 0.3 0.90 for a
// cube, 2.1 for a = 2 h, 6.7 for a = 4 h.
TEST(SelectiveHexahedron, BendsAsKnownOfMeanDilatation)
{
    for (const double nu : {0.0, 0.3})
        for (const double a : {1.0, 2.0, 4.0}) {
            const Corners x = brick(a, 1, 1);
            Corners u = Corners::Zero();
            const double curvature = 1e-7;
            for (int i = 0; i < 8; ++i) u(i, 0) = curvature * x(i, 0) * x(i, 2);
            Selective<> element(elasticOf(1, nu), x);
            element.advance(x + u);
            const double energy = workOf(element.force, u) / 2,
                         beam = 0.5 * curvature * curvature * a / 12;
            EXPECT_NEAR(energy / beam, (2.0 / 3 + a * a / 2) / (1 + nu), 1e-5);
        }
}

// Eight points see higher frequencies than one where an element is almost turned inside out: there
// the bound of Flanagan and Belytschko would not do.
TEST(SelectiveHexahedron, ItsStepIsSafeForDistortedElements)
{
    std::mt19937 random(87);
    double least = 1e300, most = 0;
    int onePointTooLong = 0, count = 0;
    for (int i = 0; i < 600; ++i) {
        const Corners x = warpedHexahedron(random, i % 2 == 0 ? 0.25 : 0.45);
        double smallest = 1e300;
        for (int p = 0; p < 8; ++p) smallest = std::min(smallest, GaussPoint(x, p).volume);
        if (!(smallest > 0)) continue;
        ++count;
        const double density = 2.5, mass = density * volumeOf(x);
        for (const double nu : {-0.3, 0.0, 0.3, 0.45, 0.499}) {
            const auto m = elasticOf(3, nu);
            const double exact = exactStep(gaussStiffness(m, x, true), mass);
            const double margin = exact / stableStep(m, x, mass);
            least = std::min(least, margin);
            most = std::max(most, margin);
            Element<Elastic, StiffnessHourglass> onePoint(m, x);
            onePoint.mass = mass;
            onePoint.advance(x);
            onePointTooLong += onePoint.step.stableTimeStep > exact;
        }
    }
    EXPECT_GT(count, 300);
    EXPECT_GT(least, 1);
    EXPECT_LT(most, 3);
    EXPECT_GT(onePointTooLong, 0);
}

TEST(SelectiveHexahedron, ItsStepIsExactForACubeAndNeverBelowOnePointForBricks)
{
    std::mt19937 random(88);
    for (const double nu : {0.0, 0.3, 0.499}) {
        const auto m = elasticOf(3, nu);
        const Corners cube = brick(0.7, 0.7, 0.7);
        const double mass = 2 * volumeOf(cube),
                     exact = exactStep(gaussStiffness(m, cube, true), mass);
        if (nu > 0.1) { // dilatation, not shear, is the fastest mode
            EXPECT_NEAR(stableStep(m, cube, mass), exact, 1e-9 * exact);
        }
        for (int i = 0; i < 20; ++i) {
            const Corners x =
                brick(uniform(random, 0.1, 3), uniform(random, 0.1, 3), uniform(random, 0.1, 3));
            Element<Elastic, StiffnessHourglass> onePoint(m, x);
            onePoint.mass = 2 * volumeOf(x);
            onePoint.advance(x);
            const double step = stableStep(m, x, onePoint.mass);
            EXPECT_GE(step, onePoint.step.stableTimeStep * (1 - 1e-12));
            EXPECT_LE(step, exactStep(gaussStiffness(m, x, true), onePoint.mass) * (1 + 1e-9));
        }
    }
}

TEST(SelectiveHexahedron, AnInvertedPointIsReported)
{
    Corners x = brick(1, 1, 1);
    x.row(6) << -0.4, -0.4, -0.4; // one corner pushed through: the volume stays positive
    ASSERT_GT(volumeOf(x), 0);
    ASSERT_LT(GaussPoint(x, 7).volume, 0);
    EXPECT_LT(stableStep(elasticOf(1, 0.3), x, 1), 0);
}

// The lagged viscous force: with damping c2 = 8 F / m u'Cu the step obeys
// (omega dt / 2)^2 + c2 dt / 2 = 1.
TEST(SelectiveHexahedron, ItsStepShrinksWithBulkViscosity)
{
    MaterialConstants<double> m = elasticOf(1, 0.3);
    const Corners x = brick(1, 1, 1);
    const double free = stableStep(m, x, 1);
    m.linearViscosity = 0.06;
    const double damped = stableStep(m, x, 1);
    const double length = 1 / std::sqrt(3.0),
                 c2 = 4 * 0.06 * std::sqrt(m.pressureWaveModulus) / length;
    EXPECT_NEAR(damped * damped / (free * free) + c2 * damped / 2, 1, 1e-12);
}

TEST(SelectiveHexahedron, OneLayerBearsTwoThirdsOfThePlasticMoment)
{
    // Plane strain: the section bears 2/sqrt(3) sigma_y h^2 / 4. An element whose mean dilatation
    // is one number cannot thin where it stretches and thicken where it shortens: its strain
    // deviator in bending is (2, -1, -1) / 3 in place of (1, -1, 0), and its two points lie at h /
    // sqrt(12).
    const double yield = 1, height = 2, slice = 0.01; // short: no shear of the trilinear shape
    const Corners start = brick(slice, 1, height);
    Corners bent = Corners::Zero();
    for (int i = 0; i < 8; ++i) bent(i, 0) = start(i, 0) * start(i, 2);
    Selective<> element(materialOf(1e4, 0.3, yield), start);
    const double curvature = 2e-6;
    double before = 0;
    for (int step = 1; step <= 1000; ++step) {
        before = element.work;
        element.advance(start + step * curvature * bent);
    }
    const double moment = (element.work - before) / (curvature * slice),
                 whole = 2 / std::sqrt(3) * yield * height * height / 4;
    EXPECT_NEAR(moment / whole, 2.0 / 3, 1e-3);
}
