#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "support/logFile.h"
#include "unit/mesher/mesherCase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace fpm::test {

namespace {

/// Area of the regular polygon with `sides` corners on the unit circle.
double polygonArea(int sides)
{
    return 0.5 * sides * std::sin(2 * std::numbers::pi / sides);
}

std::set<Point> placesOf(const Mesh& mesh)
{
    return {mesh.points.begin(), mesh.points.end()};
}

const std::string rod = "base (0 0 0); radius 10; height 50; core 3; rings 2; axial 4; ";

} // namespace

TEST(Cylinder, PutsTheNodesOfAQuarterRodWhereTheReferenceHasThem)
{
    // One section of the rod of the plate impact, radius 10: core 2, rings 2.
    const std::vector<std::array<double, 2>> section{{0, 0},
                                                     {2.75, 0},
                                                     {5.5, 0},
                                                     {0, 2.75},
                                                     {2.425, 2.425},
                                                     {4.85, 2.1},
                                                     {0, 5.5},
                                                     {2.1, 4.85},
                                                     {4.2, 4.2},
                                                     {7.75, 0},
                                                     {10, 0},
                                                     {7.04439766, 2.96341716},
                                                     {9.23879533, 3.82683432},
                                                     {5.63553391, 5.63553391},
                                                     {7.07106781, 7.07106781},
                                                     {2.96341716, 7.04439766},
                                                     {3.82683432, 9.23879533},
                                                     {0, 7.75},
                                                     {0, 10}};

    const Mesh mesh = meshOf("bodies { rod { type cylinder; base (0 0 0); axis z; radius 10; "
                             "height 50; sector quarter; core 2; rings 2; axial 20; } }");

    ASSERT_EQ(mesh.hexahedra.size(), 240u);
    ASSERT_EQ(mesh.points.size(), 399u);
    std::set<std::pair<std::size_t, double>> found;
    for (const Point& point : mesh.points)
        for (std::size_t node = 0; node < section.size(); ++node)
            if (std::hypot(point[0] - section[node][0], point[1] - section[node][1]) < 1e-6)
                found.insert({node, point[2]});
    EXPECT_EQ(found.size(), 399u);
    for (const auto& [node, z] : found) EXPECT_EQ(z, 2.5 * std::round(z / 2.5));
}

TEST(Cylinder, FillsTheSectorAskedFor)
{
    for (const auto& [sector, quarters] : {std::pair{"quarter", 1}, {"half", 2}, {"full", 4}}) {
        const Mesh mesh = meshOf("bodies { rod { type cylinder; sector " + std::string(sector)
                                 + "; " + rod + "} }");

        EXPECT_EQ(mesh.hexahedra.size(), std::size_t(quarters * 4 * 3 * 7)) << sector;
        const double area = 100 * polygonArea(24) * quarters / 4;
        EXPECT_NEAR(quality(mesh).totalVolume, 50 * area, 1e-8) << sector;
        EXPECT_GT(quality(mesh).minScaledJacobian, 0.7) << sector;
    }
}

TEST(Cylinder, IsMirroredInTheAxesAndDiagonalsToTheBit)
{
    const Mesh mesh = meshOf("bodies { rod { type cylinder; " + rod + "} }");
    const auto places = placesOf(mesh);

    for (const auto& [x, y, z] : places) {
        EXPECT_TRUE(places.contains({-x, y, z}));
        EXPECT_TRUE(places.contains({x, -y, z}));
        EXPECT_TRUE(places.contains({y, x, z}));
    }
}

TEST(Cylinder, HasItsOuterNodesOnTheCircle)
{
    const Mesh mesh = meshOf("bodies { rod { type cylinder; " + rod + "} }");

    const auto nodes = nodesOf(mesh, mesh.sideSets.at("rod.outer"));
    EXPECT_EQ(nodes.size(), 24u * 5);
    for (const Index node : nodes)
        EXPECT_NEAR(std::hypot(mesh.points[node][0], mesh.points[node][1]), 10, 4e-15);
}

TEST(Cylinder, LiesAlongAnyAxis)
{
    for (int axis = 0; axis < 3; ++axis) {
        const Mesh mesh = meshOf("bodies { rod { type cylinder; axis " + std::string(1, "xyz"[axis])
                                 + "; sector quarter; base (1 2 3); radius 10; height 50; core 2; "
                                   "rings 1; axial 3; } }");
        const Point base{1, 2, 3};

        for (const Point& point : mesh.points)
            for (int k = 0; k < 3; ++k) EXPECT_GE(point[k], base[k]);
        for (const auto& cell : mesh.hexahedra)
            for (int corner = 0; corner < 4; ++corner)
                EXPECT_LT(mesh.points[cell[corner]][axis], mesh.points[cell[corner + 4]][axis]);
        const auto top = nodesOf(mesh, mesh.sideSets.at("rod.top"));
        for (const Index node : top) EXPECT_EQ(mesh.points[node][axis], base[axis] + 50);
    }
}

TEST(Cylinder, NamesItsCutPlanesAfterTheirNormals)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const std::string angle : {"0", "90", "180", "270"}) {
            const Mesh mesh =
                meshOf("bodies { rod { type cylinder; axis " + std::string(1, "xyz"[axis])
                       + "; sector quarter; startAngle " + angle + "; " + rod + "} }");

            for (int k = 0; k < 3; ++k) {
                const auto set = mesh.sideSets.find("rod.sym" + std::string(1, "XYZ"[k]));
                ASSERT_EQ(set == mesh.sideSets.end(), k == axis);
                if (k == axis) continue;
                EXPECT_EQ(set->second.size(), 20u);
                for (const Index node : nodesOf(mesh, set->second))
                    EXPECT_EQ(mesh.points[node][k], 0);
            }
        }
}

TEST(Cylinder, StartsItsSectorWhereAskedTo)
{
    const Mesh mesh =
        meshOf("bodies { rod { type cylinder; sector half; startAngle 180; " + rod + "} }");

    for (const Point& point : mesh.points) EXPECT_LE(point[1], 0);
    EXPECT_EQ(mesh.sideSets.count("rod.symY"), 1u);
    EXPECT_EQ(mesh.sideSets.count("rod.symX"), 0u);
    EXPECT_GT(quality(mesh).minScaledJacobian, 0.7);
}

TEST(Cylinder, HasEndsOfBottomAndTop)
{
    const Mesh mesh = meshOf("bodies { rod { type cylinder; base (0 0 0); radius 1; height 1; "
                             "core 1; rings 1; axial 1; } }");

    EXPECT_EQ(mesh.sideSets.at("rod.bottom").size(), 12u);
    EXPECT_EQ(mesh.sideSets.at("rod.ends").size(), 24u);
    EXPECT_EQ(mesh.sideSets.at("rod.outer").size(), 8u);
}

TEST(HollowCylinder, HasTheVolumeOfItsPolygons)
{
    for (const auto& [sector, quarters] : {std::pair{"quarter", 1}, {"half", 2}, {"full", 4}}) {
        const Mesh mesh =
            meshOf("bodies { die { type hollowCylinder; base (0 0 0); innerRadius 45; "
                   "outerRadius 50; height 200; sector "
                   + std::string(sector) + "; circumferential 16; radial 2; axial 5; } }");

        EXPECT_EQ(mesh.hexahedra.size(), 16u * 2 * 5) << sector;
        EXPECT_EQ(mesh.points.size(), (quarters == 4 ? 16u : 17u) * 3 * 6) << sector;
        const double area = polygonArea(16 * 4 / quarters) * (2500 - 2025) * quarters / 4;
        EXPECT_NEAR(quality(mesh).totalVolume, 200 * area, 1e-7) << sector;
    }
}

TEST(HollowCylinder, NumbersItsElementsWithZetaOutward)
{
    for (const std::string axis : {"x", "y", "z"}) {
        const Mesh mesh = meshOf("bodies { die { type hollowCylinder; base (0 0 0); axis " + axis
                                 + "; innerRadius 45; outerRadius 50; height 20; circumferential "
                                   "12; radial 2; axial 2; } }");
        const int along = axis[0] - 'x';

        const auto radius = [&](Index node) {
            const Point& at = mesh.points[node];
            return std::hypot(at[(along + 1) % 3], at[(along + 2) % 3]);
        };
        for (const auto& cell : mesh.hexahedra)
            for (int corner = 0; corner < 4; ++corner)
                EXPECT_NEAR(radius(cell[corner + 4]) - radius(cell[corner]), 2.5, 1e-12);
    }
}

TEST(HollowCylinder, NamesNoPlacesOfGmsh)
{
    MesherCase folder;
    Log log = test::logInto(folder / "log");
    makeMesh(Dictionary::parse("bodies { die { type hollowCylinder; base (0 0 100); axis y; "
                               "innerRadius 45; outerRadius 50; height 100; sector quarter; "
                               "startAngle 90; circumferential 16; radial 1; axial 10; } }",
                               "meshDict"),
             Case(folder / ""), false, log);
    log.finish();

    EXPECT_EQ(readBytes(folder / "log").find("warning"), std::string::npos);
}

TEST(HollowCylinder, TakesAnyNumberOfCellsAround)
{
    for (const int around : {3, 4, 5, 7, 30}) {
        const Mesh mesh = meshOf("bodies { die { type hollowCylinder; base (0 0 0); innerRadius 1; "
                                 "outerRadius 1.001; height 1; circumferential "
                                 + std::to_string(around) + "; radial 1; axial 1; } }");

        EXPECT_EQ(mesh.hexahedra.size(), std::size_t(around));
        EXPECT_EQ(mesh.sideSets.at("die.inner").size(), std::size_t(around));
        EXPECT_EQ(mesh.sideSets.at("die.ends").size(), 2u * around);
    }
}

TEST(Cylinder, TellsTheAreaThatItsChordsLack)
{
    const MesherCase aCase;
    const auto said = [&](const std::string& body) {
        return aCase.said("bodies { r { base (0 0 0); height 5; axial 1; " + body + " } }");
    };
    // 8 and 16 sides around: 1 - sin(2 pi / n) / (2 pi / n) = 9.97 and 2.55 %.
    for (const char* sector : {"full", "half", "quarter"}) {
        const std::string rest = " sector " + std::string(sector) + ";";
        EXPECT_NE(said("type cylinder; radius 10; core 1; rings 1;" + rest)
                      .find("r: its chords lack 9.97 % of the round section"),
                  std::string::npos);
        EXPECT_NE(said("type cylinder; radius 10; core 2; rings 1;" + rest)
                      .find("lack 2.55 % of the round section, and so of mass and stiffness: more "
                            "cells around, or 1.013 times the radius for the same area"),
                  std::string::npos);
        EXPECT_EQ(said("type cylinder; radius 10; core 5; rings 1;" + rest).find("lack"),
                  std::string::npos); // 40 sides, 0.41 %
    }
    const std::string tube = "type hollowCylinder; innerRadius 8; outerRadius 10; radial 1; ";
    EXPECT_NE(said(tube + "circumferential 16;").find("lack 2.55 %"), std::string::npos);
    EXPECT_EQ(said(tube + "circumferential 40;").find("lack"), std::string::npos);
}

TEST(Cylinder, HasTheAreaOfTheCircleWithTheReportedRadius)
{
    const MesherCase aCase;
    const std::string rest = " base (0 0 0); height 1; axial 1; core 1; rings 1; } }";
    const std::string said = aCase.said("bodies { r { type cylinder; radius 10;" + rest);
    const std::size_t at = said.find(" or ") + 4;
    const double factor = std::stod(said.substr(at));
    const Mesh mesh =
        meshOf("bodies { r { type cylinder; radius " + std::to_string(10 * factor) + ";" + rest);
    EXPECT_NEAR(quality(mesh).totalVolume, 100 * std::numbers::pi, 0.05);
}

} // namespace fpm::test
