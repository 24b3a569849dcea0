#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "unit/mesher/mesherCase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace fpm::test {

namespace {

std::set<double> coordinates(const Mesh& mesh, const std::vector<Index>& nodes, int component)
{
    std::set<double> values;
    for (const Index node : nodes) values.insert(mesh.points[node][component]);
    return values;
}

std::vector<Index> nodesOfSet(const Mesh& mesh, const std::string& set)
{
    return nodesOf(mesh, mesh.sideSets.at(set));
}

} // namespace

TEST(Box, HasTheCellsAskedFor)
{
    const Mesh mesh =
        meshOf("bodies { a { type box; origin (1 2 3); size (4 5 6); cells (3 4 5); } }");

    EXPECT_EQ(mesh.hexahedra.size(), 3u * 4 * 5);
    EXPECT_EQ(mesh.points.size(), 4u * 5 * 6);
    ASSERT_EQ(mesh.parts.size(), 1u);
    EXPECT_EQ(mesh.parts[0].name, "a");
    EXPECT_NEAR(quality(mesh).totalVolume, 120, 1e-11);
    EXPECT_NEAR(quality(mesh).minScaledJacobian, 1, 1e-12);
}

TEST(Box, HasOneBitPatternForEveryPlaneOfNodes)
{
    const Mesh mesh = meshOf("bodies { a { type box; origin (0.1 0.2 -0.3); size (0.7 1.1 1.3); "
                             "cells (7 11 13); } }");
    const auto nodes = partNodes(mesh, "a");

    EXPECT_EQ(coordinates(mesh, nodes, 0).size(), 8u);
    EXPECT_EQ(coordinates(mesh, nodes, 1).size(), 12u);
    EXPECT_EQ(coordinates(mesh, nodes, 2).size(), 14u);
    EXPECT_EQ(coordinates(mesh, nodesOfSet(mesh, "a.zMin"), 2), std::set<double>{-0.3});
    EXPECT_EQ(coordinates(mesh, nodesOfSet(mesh, "a.zMax"), 2), std::set<double>{-0.3 + 1.3});
}

TEST(Box, NumbersItsElementsWithZetaAlongZ)
{
    const Mesh mesh =
        meshOf("bodies { a { type box; origin (0 0 0); size (1 1 1); cells (3 2 4); } }");

    for (const auto& cell : mesh.hexahedra)
        for (int corner = 0; corner < 4; ++corner)
            EXPECT_LT(mesh.points[cell[corner]][2], mesh.points[cell[corner + 4]][2]);
}

TEST(Box, GradesFromTheFirstCellToTheLast)
{
    const Mesh mesh =
        meshOf("bodies { a { type box; origin (0 0 0); size (10 1 1); cells (10 1 1); "
               "grading (4 1 1); } }");
    const auto places = coordinates(mesh, partNodes(mesh, "a"), 0);
    const std::vector<double> x(places.begin(), places.end());

    ASSERT_EQ(x.size(), 11u);
    EXPECT_NEAR((x[10] - x[9]) / (x[1] - x[0]), 4, 1e-12);
    for (int cell = 1; cell < 10; ++cell)
        EXPECT_NEAR((x[cell + 1] - x[cell]) / (x[cell] - x[cell - 1]), std::pow(4, 1. / 9), 1e-12);
    EXPECT_EQ(x.back(), 10);
}

TEST(Box, StandsSteepGrading)
{
    const Mesh mesh = meshOf("bodies { a { type box; origin (0 0 0); size (1 1 1); "
                             "cells (100 2 2); grading (1e6 1 1e-6); } }");

    EXPECT_NEAR(quality(mesh).totalVolume, 1, 1e-12);
}

TEST(Box, KeepsItsShapeAtAnySizeAndPlace)
{
    for (const std::string size : {"1e-9", "1", "1e9"}) {
        const Mesh mesh = meshOf("bodies { a { type box; origin (0 0 0); size (" + size + " " + size
                                 + " " + size + "); cells (3 3 3); } }");

        EXPECT_NEAR(quality(mesh).minScaledJacobian, 1, 1e-9);
    }
    const Mesh sheet = meshOf(
        "bodies { a { type box; origin (1e6 0 0); size (1000 1000 1e-4); cells (4 4 1); } }");
    EXPECT_EQ(sheet.points.size(), 50u);
}

TEST(Box, HasSixOutwardSideSets)
{
    const Mesh mesh =
        meshOf("bodies { a { type box; origin (0 0 0); size (1 2 3); cells (2 3 4); } }");
    const std::map<std::string, std::pair<std::size_t, Point>> expected{
        {"a.xMin", {12, {-1, 0, 0}}}, {"a.xMax", {12, {1, 0, 0}}}, {"a.yMin", {8, {0, -1, 0}}},
        {"a.yMax", {8, {0, 1, 0}}},   {"a.zMin", {6, {0, 0, -1}}}, {"a.zMax", {6, {0, 0, 1}}}};

    ASSERT_EQ(mesh.sideSets.size(), 6u);
    for (const auto& [name, facts] : expected) {
        const auto& sides = mesh.sideSets.at(name);
        EXPECT_EQ(sides.size(), facts.first) << name;
        for (const auto& side : sides)
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(normal(mesh, side)[k], facts.second[k], 1e-12) << name;
    }
}

TEST(Layers, TouchExactlyWithoutSharingNodes)
{
    const Mesh mesh = meshOf("bodies { plate { type layers; origin (0 0 -5); size (100 100 5); "
                             "cells (5 5 1); count 3; } }");

    ASSERT_EQ(mesh.parts.size(), 3u);
    EXPECT_EQ(mesh.parts[2].name, "plate3");
    EXPECT_EQ(mesh.points.size(), 3u * 72);
    for (const std::string layer : {"1", "2"}) {
        const auto above = std::to_string(std::stoi(layer) + 1);
        const auto top = nodesOfSet(mesh, "plate" + layer + ".zMax");
        const auto bottom = nodesOfSet(mesh, "plate" + above + ".zMin");
        EXPECT_EQ(coordinates(mesh, top, 2), coordinates(mesh, bottom, 2));
        EXPECT_EQ(coordinates(mesh, top, 2).size(), 1u);
    }
    EXPECT_EQ(coordinates(mesh, nodesOfSet(mesh, "plate3.zMax"), 2), std::set<double>{0});
}

TEST(Layers, PutTheNodesOfAPlateOfThreeLayersWhereTheReferenceHasThem)
{
    const Mesh mesh = meshOf("bodies { plate { type layers; origin (0 0 -5); size (100 100 5); "
                             "cells (50 50 1); count 3; } }");

    ASSERT_EQ(mesh.hexahedra.size(), 7500u);
    ASSERT_EQ(mesh.points.size(), 3u * 5202);
    std::set<Point> places;
    for (const Point& point : mesh.points) {
        for (int k = 0; k < 2; ++k) EXPECT_EQ(point[k], 2 * std::round(point[k] / 2));
        EXPECT_NEAR(point[2], std::round(point[2] * 0.6) / 0.6, 1e-12);
        places.insert(point);
    }
    EXPECT_EQ(places.size(), 51u * 51 * 4);
}

} // namespace fpm::test
