#include "advise/ReducedCase.h"

#include "model/readModel.h"
#include "unit/advise/symmetricScene.h"
#include "unit/model/CaseFolder.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// symmetricScene as dictionaries; contact by the skins of the parts.
class ReducedCaseTest : public testing::Test
{
protected:
    ReducedCaseTest()
    {
        Mesh mesh = symmetricScene().mesh;
        mesh.contact.clear();
        mesh.nodeSets["ground"] = nodesWhere(mesh, [](Point p) { return p[2] == -1; });
        mesh.nodeSets["left"] = nodesWhere(mesh, [](Point p) { return p[0] == -3 && p[2] == 0; });
        mesh.nodeSets["right"] = nodesWhere(mesh, [](Point p) { return p[0] == 3 && p[2] == 0; });
        mesh.nodeSets["top"] = nodesWhere(mesh, [](Point p) { return p[2] == 1; });
        folder_.write(mesh);
        folder_.write("constant/partProperties",
                      "word elastoplastic;\nparts\n{\nlower { model $word; density 2.7e-9;\n"
                      "youngsModulus 70000; poissonsRatio 0.3; yieldStress 285; }\n"
                      "upper { like lower; }\n}\n");
        folder_.write("constant/boundaryConditions",
                      "ground { type fixed; set ground; }\n"
                      "left { type velocity; set left; value (-5 0 0); components (x); }\n"
                      "right { type velocity; set right; value (5 0 0); components (x); }\n"
                      "weight { type force; set top; value (0 0 -8); components (z); }\n");
        folder_.write("0/initialConditions",
                      "fall { type velocity; part upper; value (0 0 -1000); }\n");
        folder_.write(
            "system/contactDict",
            "pairs { touch { contactor upper; target lower; friction { static 0.2; } } }");
        folder_.write("system/controlDict",
                      "endTime 1e-4;\nfunctions\n{\n"
                      "corner { type point; part upper; position (-1 0.5 1); }\n"
                      "pull { type reaction; condition left; factor 3; }\n"
                      "hold { type reaction; condition ground; }\n}\n");
        folder_.write("system/meshDict", "bodies { }\n");
    }

    Model write(const std::vector<Advice>& advice, bool cut)
    {
        Log log = Log::quiet();
        writeReducedCase(folder_.open(), advice, cut, less_ / "less", log);
        return readModel(Case(less_ / "less"), log);
    }

    CaseFolder folder_;
    TemporaryFolder less_;
};

double forceOf(const Model& model)
{
    double sum = 0;
    for (const BoundaryCondition& condition : model.boundaryConditions)
        if (condition.kind == BoundaryCondition::Kind::force) sum += condition.value[2];
    return sum;
}

} // namespace

TEST_F(ReducedCaseTest, TheCutIsNoSurfaceAndNodesOnItBearTheirShare)
{
    const Model quarter = write({}, true);

    EXPECT_EQ(quarter.mesh.hexahedra.size(), (24u + 16u) / 4);
    // Of the skin of the upper block's 5 x 3 x 3 nodes all but the 3 inside: of the quarter's 18,
    // one on both planes in the middle of the height, and one beside it on y = 1.
    EXPECT_EQ(quarter.contactPairs.at(0).contactorNodes.size(), 18u - 2);
    EXPECT_EQ(quarter.contactPairs.at(0).targetSides.size(), 6u + 6 + 2 + 3);
    // 15 nodes share 8: on both planes 1, on one of them 2 + 1, on none 2.
    const double share = 8.0 / 15;
    EXPECT_NEAR(forceOf(quarter), -8.0 / 4, 1e-12);
    std::vector<double> each;
    for (const BoundaryCondition& condition : quarter.boundaryConditions)
        if (condition.kind == BoundaryCondition::Kind::force)
            each.push_back(-condition.value[2] / double(condition.nodes.size()) / share);
    ASSERT_EQ(each.size(), 3u);
    EXPECT_NEAR(each[0], 1, 1e-12);
    EXPECT_NEAR(each[1], 0.5, 1e-12);
    EXPECT_NEAR(each[2], 0.25, 1e-12);
}

TEST_F(ReducedCaseTest, HistoriesFollowToTheSideThatIsKept)
{
    // The only point lies at low x and low y: that corner is kept, and with it the left end.
    const Model quarter = write({}, true);
    ASSERT_EQ(quarter.control.histories.size(), 4u); // the energies by themselves
    EXPECT_EQ(quarter.mesh.points[std::size_t(quarter.control.histories[0].node)],
              (Point{-1, 0.5, 1}));
    EXPECT_EQ(quarter.control.histories[1].factor, 12);
    EXPECT_EQ(quarter.control.histories[2].factor, 4);
    for (const BoundaryCondition& condition : quarter.boundaryConditions)
        EXPECT_NE(condition.name, "right");
    const std::string readme = readText(less_ / "less/README.md");
    EXPECT_NE(readme.find("condition 'right' lay on the side"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(less_ / "less/system/meshDict.whole"));
    EXPECT_FALSE(std::filesystem::exists(less_ / "less/system/meshDict"));
}

TEST_F(ReducedCaseTest, EntriesAreChangedAndValuesNobodyUsesLeave)
{
    Advice advice{"elastic", "part lower", "", "", "", {}, false};
    advice.edits.set("constant/partProperties", "parts.lower.model", "elastic");
    advice.edits.set("constant/partProperties", "parts.upper.model", "elastoplastic");
    advice.edits.remove("system/contactDict", "pairs.touch.friction", "did no work");
    const Model model = write({advice}, false);
    EXPECT_EQ(model.parts[0].kind, PartKind::elastic);
    EXPECT_EQ(model.parts[1].kind, PartKind::elastoplastic);
    EXPECT_EQ(model.contactPairs.at(0).friction, 0);
    EXPECT_TRUE(std::filesystem::exists(less_ / "less/system/meshDict"));
}

TEST_F(ReducedCaseTest, WhatFailsLeavesNothingAndWhatExistsIsKept)
{
    folder_.write("0/initialConditions",
                  "fall { type velocity; part upper; value (1 1 -1000); }\n");
    EXPECT_THROW(write({}, true), Error);
    EXPECT_TRUE(std::filesystem::is_empty(less_.path()));
    writeBytes(less_ / "less", "mine");
    EXPECT_THROW(write({}, false), Error);
    EXPECT_EQ(readBytes(less_ / "less"), "mine");
    Log log = Log::quiet();
    EXPECT_THROW(writeReducedCase(folder_.open(), {}, false, folder_.root() / "less", log), Error);
}

} // namespace fpm::test
