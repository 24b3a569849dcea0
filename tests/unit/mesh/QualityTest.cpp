#include "mesh/Quality.h"

#include "base/Error.h"
#include "support/TemporaryFolder.h"
#include "support/boxMesh.h"
#include "support/logFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace fpm;

namespace {

/// Volume by 2 x 2 x 2 Gauss points, exact for bilinear faces.
double gaussVolume(const Mesh& mesh, Index element)
{
    constexpr std::array<std::array<int, 3>, 8> sign{{{-1, -1, -1},
                                                      {1, -1, -1},
                                                      {1, 1, -1},
                                                      {-1, 1, -1},
                                                      {-1, -1, 1},
                                                      {1, -1, 1},
                                                      {1, 1, 1},
                                                      {-1, 1, 1}}};
    double volume = 0;
    for (const auto& gauss : sign) {
        double j[3][3] = {};
        for (std::size_t corner = 0; corner < 8; ++corner) {
            std::array<double, 3> factor;
            for (std::size_t k = 0; k < 3; ++k)
                factor[k] = 1 + sign[corner][k] * gauss[k] / std::sqrt(3.0);
            const auto& x = mesh.points[std::size_t(mesh.hexahedra[std::size_t(element)][corner])];
            for (std::size_t i = 0; i < 3; ++i) {
                j[i][0] += x[i] * sign[corner][0] * factor[1] * factor[2] / 8;
                j[i][1] += x[i] * sign[corner][1] * factor[0] * factor[2] / 8;
                j[i][2] += x[i] * sign[corner][2] * factor[0] * factor[1] / 8;
            }
        }
        volume += j[0][0] * (j[1][1] * j[2][2] - j[1][2] * j[2][1])
                  - j[0][1] * (j[1][0] * j[2][2] - j[1][2] * j[2][0])
                  + j[0][2] * (j[1][0] * j[2][1] - j[1][1] * j[2][0]);
    }
    return volume;
}

std::string refusal(const Mesh& mesh)
{
    Log log = Log::quiet();
    try {
        checkMesh(mesh, "meshDict", log);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::mesh);
        return std::string(error.what()) + " | " + error.advice();
    }
    return "";
}

/// What checkMesh says, read from its log.
std::string warnings(const Mesh& mesh)
{
    const test::TemporaryFolder folder;
    {
        Log log = test::logInto(folder / "log");
        checkMesh(mesh, "meshDict", log);
    }
    return test::readBytes(folder / "log");
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST(Quality, VolumeOfWarpedElementsIsExact)
{
    Mesh mesh = test::boxMesh({3, 3, 3});
    std::mt19937 random(7);
    for (auto& point : mesh.points)
        for (double& x : point) x += 0.1 * (double(random()) / 4294967296.0 - 0.5) + 100;

    for (Index element = 0; element < 27; ++element)
        EXPECT_NEAR(volume(mesh, element), gaussVolume(mesh, element), 1e-13);
}

TEST(Quality, KnowsABrick)
{
    const Mesh mesh = test::boxMesh({2, 2, 2}, {2, 4, 8});

    const Quality result = quality(mesh);

    EXPECT_DOUBLE_EQ(result.minScaledJacobian, 1);
    EXPECT_DOUBLE_EQ(result.medianScaledJacobian, 1);
    EXPECT_DOUBLE_EQ(result.maxEdgeRatio, 4);
    EXPECT_DOUBLE_EQ(result.minHeight, 1);
    EXPECT_DOUBLE_EQ(result.totalVolume, 64);
}

TEST(Quality, FindsTheWorstElement)
{
    Mesh mesh = test::boxMesh({5, 1, 1}, {5, 1, 1});
    mesh.points[std::size_t(mesh.hexahedra[4][6])] = {4.5, 0.5, 1};

    const Quality result = quality(mesh);

    EXPECT_EQ(result.worstElement, 4);
    EXPECT_LT(result.minScaledJacobian, 0.9);
    EXPECT_DOUBLE_EQ(result.medianScaledJacobian, 1);
}

TEST(CheckMesh, AcceptsABlock)
{
    EXPECT_EQ(refusal(test::boxMesh({3, 4, 5})), "");
    EXPECT_FALSE(contains(warnings(test::boxMesh({3, 4, 5})), "warning"));
}

TEST(CheckMesh, RefusesNumbersOutOfRangeAndRepeated)
{
    Mesh mesh = test::boxMesh({3, 1, 1});
    mesh.hexahedra[1][2] = Index(mesh.points.size());
    EXPECT_TRUE(contains(refusal(mesh), "nodes outside 0 ... 15: 1 (1) |"));
    mesh.hexahedra[1][2] = -1;
    EXPECT_TRUE(contains(refusal(mesh), "nodes outside"));
    mesh.hexahedra[1][2] = mesh.hexahedra[1][3];
    EXPECT_TRUE(contains(refusal(mesh), "a node twice: 1 (1)"));
}

TEST(CheckMesh, RefusesCoordinatesThatAreNone)
{
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), -2e15}) {
        Mesh mesh = test::boxMesh({3, 1, 1});
        mesh.points[5][1] = bad;
        EXPECT_TRUE(contains(refusal(mesh), "beyond 1e15: 1 (5)")) << bad;
    }
}

TEST(CheckMesh, NamesInvertedElements)
{
    Mesh mesh = test::boxMesh({20, 1, 1}, {20, 1, 1});
    auto& n = mesh.hexahedra[17];
    std::swap_ranges(n.begin(), n.begin() + 4, n.begin() + 4);

    EXPECT_TRUE(contains(refusal(mesh), "turned inside out: 1 (17)"));
    EXPECT_FALSE(contains(refusal(mesh), "mirrored"));
}

TEST(CheckMesh, SuspectsMirroredNumbering)
{
    Mesh mesh = test::boxMesh({20, 1, 1}, {20, 1, 1});
    for (auto& n : mesh.hexahedra) std::swap_ranges(n.begin(), n.begin() + 4, n.begin() + 4);

    const std::string text = refusal(mesh);

    EXPECT_TRUE(contains(text, "inside out: 20 (0, 1, 2"));
    EXPECT_TRUE(contains(text, "0, 1, 2, 3, 4, 5, 6, 7, 8, 9, ..."));
    EXPECT_TRUE(contains(text, "mirrored numbering"));
}

TEST(CheckMesh, RefusesAMeshWithoutElements)
{
    EXPECT_NE(refusal(Mesh()), "");
}

TEST(CheckMesh, WarnsOfDistortedElements)
{
    Mesh mesh = test::boxMesh({1, 1, 1});
    for (std::size_t node = 4; node < 8; ++node) mesh.points[node][0] += 20;

    EXPECT_TRUE(
        contains(warnings(mesh), "badly distorted elements (scaled Jacobian below 0.1): 1 (0)"));
}

TEST(CheckMesh, WarnsOfOrphanNodes)
{
    Mesh mesh = test::boxMesh({2, 2, 2});
    mesh.points.push_back({9, 9, 9});

    EXPECT_TRUE(contains(warnings(mesh), "belong to no element and have no mass: 1"));
}

TEST(CheckMesh, WarnsOfUnmergedNodesInsideOnePartOnly)
{
    Mesh parts;
    test::addBox(parts, "lower", {3, 3, 1}, {0, 0, 0});
    test::addBox(parts, "upper", {3, 3, 1}, {0, 0, 1});
    Mesh onePart = parts;
    onePart.parts = {{"both", 0, 18}};
    for (auto& point : onePart.points) point[0] += 1e-13 * point[1];

    EXPECT_FALSE(contains(warnings(parts), "unmerged"));
    EXPECT_TRUE(contains(warnings(onePart), "16 nodes of part 'both'"));
}
