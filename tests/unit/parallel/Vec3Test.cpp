#include "parallel/Vec3.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

using namespace fpm;

namespace {

struct Pair {
    Eigen::Matrix3d dense;
    Mat3<double> rows;
};

Vec3<double> vector(const Eigen::Vector3d& v)
{
    return {v.x(), v.y(), v.z()};
}

Pair randomMatrix(std::mt19937& random)
{
    std::uniform_real_distribution<double> numbers(-1, 1);
    const Eigen::Matrix3d m = Eigen::Matrix3d::NullaryExpr([&] { return numbers(random); });
    return {m, {vector(m.row(0)), vector(m.row(1)), vector(m.row(2))}};
}

void expectNear(const Vec3<double>& a, const Eigen::Vector3d& b)
{
    EXPECT_NEAR(a.x, b.x(), 1e-15);
    EXPECT_NEAR(a.y, b.y(), 1e-15);
    EXPECT_NEAR(a.z, b.z(), 1e-15);
}

void expectNear(const Mat3<double>& a, const Eigen::Matrix3d& b)
{
    expectNear(a.x, Eigen::Vector3d(b.row(0)));
    expectNear(a.y, Eigen::Vector3d(b.row(1)));
    expectNear(a.z, Eigen::Vector3d(b.row(2)));
}

} // namespace

TEST(Vec3, AgreesWithDenseAlgebra)
{
    std::mt19937 random(43);
    for (int i = 0; i < 50; ++i) {
        const Pair m = randomMatrix(random), n = randomMatrix(random);
        const Eigen::Vector3d a = m.dense.row(0), b = n.dense.row(0);
        EXPECT_NEAR(dot(m.rows.x, n.rows.x), a.dot(b), 1e-15);
        expectNear(cross(m.rows.x, n.rows.x), a.cross(b));
        expectNear(multiplyAdd(0.3, m.rows.x, n.rows.x), 0.3 * a + b);
        expectNear(m.rows * n.rows.x, m.dense * b);
        expectNear(m.rows * n.rows, m.dense * n.dense);
        expectNear(transpose(m.rows), m.dense.transpose());
        Mat3<double> sum = m.rows;
        addOuter(sum, m.rows.x, n.rows.x);
        expectNear(sum, m.dense + a * b.transpose());
    }
}

TEST(Vec3, SymmetricTensorsContractOverAllNineComponents)
{
    const Sym3<double> a{1, 2, 3, 4, 5, 6}, b{7, 8, 9, 10, 11, 12};
    EXPECT_EQ(contract(a, b), 7 + 16 + 27 + 2 * (40 + 55 + 72));
    const Mat3<double> m = matrix(a);
    EXPECT_EQ(m.x.y, 4);
    EXPECT_EQ(m.y.z, 5);
    EXPECT_EQ(m.z.x, 6);
    EXPECT_EQ(m.x.z, 6);
}
