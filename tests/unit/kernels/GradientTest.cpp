#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

using namespace fpm;
using namespace fpm::test;

namespace {

struct Integrals {
    double volume = 0;
    Corners gradient = Corners::Zero();
};

/// Volume and integral of dN/dx by 2 x 2 x 2 Gauss points: exact for a trilinear hexahedron, and
/// independent of the mode form.
Integrals gaussIntegrals(const Corners& x)
{
    Integrals sum;
    for (const auto& gauss : cornerSign) {
        Corners natural; // dN/dxi
        for (int i = 0; i < 8; ++i) {
            const double* s = cornerSign[i];
            const double f[3] = {1 + s[0] * gauss[0] / std::sqrt(3.0),
                                 1 + s[1] * gauss[1] / std::sqrt(3.0),
                                 1 + s[2] * gauss[2] / std::sqrt(3.0)};
            natural.row(i) << s[0] * f[1] * f[2] / 8, s[1] * f[2] * f[0] / 8,
                s[2] * f[0] * f[1] / 8;
        }
        const Matrix jacobian = x.transpose() * natural;
        sum.volume += jacobian.determinant();
        sum.gradient += jacobian.determinant() * natural * jacobian.inverse();
    }
    return sum;
}

template <class Check>
void onWarpedHexahedra(const Check& check)
{
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) check(warpedHexahedron(random));
}

} // namespace

TEST(Gradient, VolumeIsExactForWarpedFaces)
{
    onWarpedHexahedra([](const Corners& x) {
        const double exact = gaussIntegrals(x).volume;
        EXPECT_NEAR(volumeOf(x), exact, 1e-12 * exact);
    });
}

TEST(Gradient, IsTheDerivativeOfTheVolume)
{
    onWarpedHexahedra([](const Corners& x) {
        const Corners b = cornerGradient(meanGradient(modesOf(x)));
        // The volume is linear in every single coordinate, so the difference has no error of its
        // own.
        const double h = 0.1;
        for (int i = 0; i < 8; ++i)
            for (int c = 0; c < 3; ++c) {
                Corners up = x, down = x;
                up(i, c) += h;
                down(i, c) -= h;
                const double derivative =
                    (gaussIntegrals(up).volume - gaussIntegrals(down).volume) / (2 * h);
                EXPECT_NEAR(b(i, c), derivative, 1e-9 * b.cwiseAbs().maxCoeff());
            }
    });
}

TEST(Gradient, IsTheIntegralOfTheShapeFunctionDerivatives)
{
    onWarpedHexahedra([](const Corners& x) {
        const Corners b = cornerGradient(meanGradient(modesOf(x)));
        const double error = (b - gaussIntegrals(x).gradient).cwiseAbs().maxCoeff();
        EXPECT_LT(error, 1e-12 * b.cwiseAbs().maxCoeff());
    });
}

TEST(Gradient, AnnihilatesTranslationsAndReproducesLinearFields)
{
    onWarpedHexahedra([](const Corners& x) {
        const Corners b = cornerGradient(meanGradient(modesOf(x)));
        EXPECT_LT(b.colwise().sum().cwiseAbs().maxCoeff(), 1e-12 * b.cwiseAbs().maxCoeff());
        const double volume = volumeOf(x);
        const Matrix identity = x.transpose() * b / volume;
        EXPECT_LT((identity - Matrix::Identity()).cwiseAbs().maxCoeff(), 1e-12);
    });
}

TEST(Gradient, SquareIsTheSumOverCornersAndComponents)
{
    onWarpedHexahedra([](const Corners& x) {
        const Gradient<double> gradient = meanGradient(modesOf(x));
        const double exact = cornerGradient(gradient).squaredNorm();
        EXPECT_NEAR(gradientSquare512(gradient) / 512, exact, 1e-13 * exact);
    });
}

TEST(Gradient, VolumeOfAnElementTurnedInsideOutIsNegative)
{
    Corners x = brick(1, 2, 3);
    x.col(2) *= -1;
    EXPECT_DOUBLE_EQ(volumeOf(x), -6);
}
