#include "kernels/particle/PressureForces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fpm;

namespace {

using Vec = Vec3<double>;

constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

std::array<Vec, 4> warpedFace(std::mt19937& random)
{
    std::uniform_real_distribution<double> jitter(-0.3, 0.3);
    std::array<Vec, 4> x;
    for (std::size_t i = 0; i < 4; ++i)
        x[i] = {corner[i][0] + jitter(random), corner[i][1] + jitter(random), jitter(random)};
    return x;
}

void expectNear(const Vec& a, const Vec& b, double tolerance)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

} // namespace

TEST(Pressure, OnAFlatFacePressesInwardInEqualShares)
{
    const Vec x[4] = {{0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}};
    Vec force[4];
    pressureOnFace(x, 10.0, force);
    for (const Vec& f : force) expectNear(f, {0, 0, -15}, 1e-14);
}

/// -p times the integral of N_I t1 x t2 by 4 x 4 Gauss points.
TEST(Pressure, IsConsistentWithTheBilinearFace)
{
    std::mt19937 random(3);
    const double place[4] = {-0.861136311594052575, -0.339981043584856265, 0.339981043584856265,
                             0.861136311594052575};
    const double weight[4] = {0.347854845137453857, 0.652145154862546143, 0.652145154862546143,
                              0.347854845137453857};
    for (int repeat = 0; repeat < 20; ++repeat) {
        const std::array<Vec, 4> face = warpedFace(random);
        const Vec x[4] = {face[0], face[1], face[2], face[3]};
        Vec wanted[4] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, force[4];
        for (int point = 0; point < 16; ++point) {
            const double xi = place[point % 4], eta = place[point / 4];
            Vec t1{0, 0, 0}, t2{0, 0, 0};
            for (int i = 0; i < 4; ++i) {
                t1 += (0.25 * corner[i][0] * (1 + corner[i][1] * eta)) * x[i];
                t2 += (0.25 * corner[i][1] * (1 + corner[i][0] * xi)) * x[i];
            }
            for (int i = 0; i < 4; ++i)
                wanted[i] += (-7 * weight[point % 4] * weight[point / 4] * 0.25
                              * (1 + corner[i][0] * xi) * (1 + corner[i][1] * eta))
                             * cross(t1, t2);
        }
        pressureOnFace(x, 7.0, force);
        for (int i = 0; i < 4; ++i) expectNear(force[i], wanted[i], 1e-13);
    }
}
