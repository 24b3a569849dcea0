#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <vector>

using namespace fpm;
using namespace fpm::test;

namespace {

template <class Hourglass>
class HexahedronPatch : public testing::Test
{
};

using Forms = testing::Types<StiffnessHourglass, ViscousHourglass, PhysicalHourglass>;
TYPED_TEST_SUITE(HexahedronPatch, Forms);

/// 3 x 3 x 3 distorted hexahedra in the unit cube; inner nodes are moved at random.
struct Grid {
    static constexpr int cells = 3, points = cells + 1;
    std::vector<Vector> x;

    explicit Grid(std::mt19937& random)
    {
        for (int k = 0; k < points; ++k)
            for (int j = 0; j < points; ++j)
                for (int i = 0; i < points; ++i) {
                    x.push_back(Vector(i, j, k) / cells);
                    if (inner(int(x.size()) - 1)) x.back() += 0.08 * randomAxis(random);
                }
    }
    static bool inner(int node)
    {
        for (const int n : {node % points, node / points % points, node / points / points})
            if (n == 0 || n == cells) return false;
        return true;
    }
    static int node(int cell, int corner)
    {
        const int n[3] = {cell % cells, cell / cells % cells, cell / cells / cells};
        int at[3];
        for (int c = 0; c < 3; ++c) at[c] = n[c] + (cornerSign[corner][c] > 0 ? 1 : 0);
        return at[0] + points * (at[1] + points * at[2]);
    }
    Corners corners(int cell) const
    {
        Corners out;
        for (int i = 0; i < 8; ++i) out.row(i) = x[std::size_t(node(cell, i))].transpose();
        return out;
    }
};

} // namespace

TYPED_TEST(HexahedronPatch, AnyLinearFieldGivesTheExactStrainAndNoHourglassForce)
{
    std::mt19937 random(11);
    for (int i = 0; i < 200; ++i) {
        const Corners x = warpedHexahedron(random);
        // lambda = 0 and 2 mu = 1: the stress is the strain.
        Element<Elastic, TypeParam> element(materialOf(1, 0), x);
        const Matrix f = Matrix::Identity() + randomMatrix(random, 0.1);
        const Corners end = x * f.transpose();
        element.advance(end, 10);

        const Matrix r =
            Matrix::Identity() + matrixOf(midSurfaceRotation(modesOf(end), modesOf(end - x)));
        const Matrix left = r.transpose() * f - Matrix::Identity(); // in the frame of the start
        // Mid-step geometry in the frame of the end: x_end - R left x_start / 2.
        const Matrix middle = f - r * left / 2;
        const Matrix gradient = r * left * middle.inverse();
        const Matrix strain = (gradient + gradient.transpose()) / 2;
        EXPECT_LT((element.stress() - strain).cwiseAbs().maxCoeff(), 1e-12);
        for (const Vec3<double>& q : element.state.hourglass)
            EXPECT_LT(std::abs(q.x) + std::abs(q.y) + std::abs(q.z), 1e-12);
        EXPECT_LT(std::abs(element.step.hourglass), 1e-24);
    }
}

TYPED_TEST(HexahedronPatch, ASwellingAndATurnGiveEveryElementTheSameStress)
{
    std::mt19937 random(12);
    const Grid grid(random);
    // The swelling has one rotation for every middle surface, so finite steps stay uniform.
    const Matrix f = 1.2 * turn(randomAxis(random), 1.0);
    for (int cell = 0; cell < 27; ++cell) {
        const Corners x = grid.corners(cell);
        Element<Elastic, TypeParam> element(materialOf(1, 0), x);
        element.advance(x * f.transpose(), 10);
        const Matrix exact = 0.2 / 1.1 * Matrix::Identity();
        EXPECT_LT((element.stress() - exact).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TYPED_TEST(HexahedronPatch, ASmallLinearFieldIsUniformAndInBalance)
{
    std::mt19937 random(13);
    const Grid grid(random);
    const MaterialConstants<double> material = materialOf(1, 0.3);
    // The middle surfaces of two elements turn differently in second order: 1e-7 squared.
    const Matrix gradient = randomMatrix(random, 1e-7);
    const Matrix strain = (gradient + gradient.transpose()) / 2;
    const Matrix stress =
        material.lambda * strain.trace() * Matrix::Identity() + material.twoMu * strain;
    std::vector<Vector> force(grid.x.size(), Vector::Zero());
    double largest = 0;
    for (int cell = 0; cell < 27; ++cell) {
        const Corners x = grid.corners(cell);
        Element<Elastic, TypeParam> element(material, x);
        element.advance(x + x * gradient.transpose(), 10);
        EXPECT_LT((element.stress() - stress).cwiseAbs().maxCoeff(), 1e-12);
        for (int i = 0; i < 8; ++i)
            force[std::size_t(Grid::node(cell, i))] += element.force.row(i).transpose();
        largest = std::max(largest, element.force.cwiseAbs().maxCoeff());
    }
    for (int node = 0; node < int(force.size()); ++node)
        if (Grid::inner(node)) {
            EXPECT_LT(force[std::size_t(node)].norm(), 1e-5 * largest);
        }
}

TYPED_TEST(HexahedronPatch, AUniformStressIsInBalanceAtInnerNodes)
{
    std::mt19937 random(14);
    const Grid grid(random);
    const Matrix stress = randomSymmetric(random, 1);
    std::vector<Vector> force(grid.x.size(), Vector::Zero());
    for (int cell = 0; cell < 27; ++cell) {
        const Corners x = grid.corners(cell);
        Element<Elastic, TypeParam> element(materialOf(1, 0.3), x);
        element.state.stress = symmetric(stress);
        element.advance(x);
        for (int i = 0; i < 8; ++i)
            force[std::size_t(Grid::node(cell, i))] += element.force.row(i).transpose();
    }
    for (int node = 0; node < int(force.size()); ++node)
        if (Grid::inner(node)) {
            EXPECT_LT(force[std::size_t(node)].norm(), 1e-12);
        }
}
