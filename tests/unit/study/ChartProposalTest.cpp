#include "study/ChartProposal.h"

#include "study/CaseSurvey.h"
#include "unit/case/TemporaryCase.h"
#include "unit/model/Refusal.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace fpm;
using fpm::test::contains;

namespace {

/// A case of dictionaries alone.
struct ChartProposalTest : testing::Test {
    ChartProposalTest()
    {
        folder.write("system/controlDict",
                     "functions { force { type reaction; condition push; } tip { type point; "
                     "fields (velocity displacement); } energies { type energies; } }");
        folder.write("constant/boundaryConditions",
                     "push { type velocity; value (0 3 -1); } held { type fixed; }");
        folder.write("system/meshDict",
                     "bodies { rod { type cylinder; radius 10; height 60; sector half; core 2; "
                     "rings 3; axial 20; } }");
        folder.write("constant/partProperties", "parts { rod { model elastic; } }");
    }
    Case open() const { return Case(folder.root()); }
    TemporaryCase folder;
};

} // namespace

TEST_F(ChartProposalTest, FindsTheElementsOfTheBodies)
{
    CaseSurvey rod = surveyOf(open());
    EXPECT_EQ(rod.elements, 2 * 2 * (2 + 2 * 3) * 20);
    EXPECT_DOUBLE_EQ(rod.size, 3); // along the axis
    folder.write("system/meshDict",
                 "bodies { tube { type hollowCylinder; innerRadius 9; outerRadius 11; height 8; "
                 "circumferential 8; radial 2; axial 4; } "
                 "plate { type layers; size (4 4 3); cells (2 2 1); count 3; } }");
    const CaseSurvey tube = surveyOf(open());
    EXPECT_EQ(tube.elements, 64 + 12);
    EXPECT_DOUBLE_EQ(tube.size, 20 * std::numbers::pi / 8); // of the body with the most
    EXPECT_EQ(tube.cells.size(), 4u);
}

TEST_F(ChartProposalTest, RefinesWhatCannotBeHalved)
{
    EXPECT_TRUE(contains(proposedChartDict(open()), "values  (1 2 3);"));
    folder.write("system/meshDict", "bodies { a { type box; size (8 4 1); cells (8 4 1); } }");
    const std::string text = proposedChartDict(open());
    EXPECT_TRUE(contains(text, "(1 (4 2 1))"));
    EXPECT_TRUE(contains(text, "(2 (8 4 1))"));
    EXPECT_TRUE(contains(text, "steps   (2 1 0.5);"));
    folder.write("system/meshDict", "bodies { a { type file; file \"a.msh\"; } }");
    EXPECT_TRUE(contains(proposedChartDict(open()), "The mesh comes from a file."));
}

TEST_F(ChartProposalTest, TakesThePartsPairsAndHistoriesThereAre)
{
    std::string text = proposedChartDict(open());
    EXPECT_TRUE(contains(text, "partProperties.parts.rod.hourglass.form"));
    EXPECT_FALSE(contains(text, "hourglass.plastic"));
    EXPECT_FALSE(contains(text, "contactLimit"));
    EXPECT_TRUE(contains(text, "y           fy;")) << "pushed along y";
    EXPECT_TRUE(contains(text, "postProcessing/tip/0/velocity.dat"));
    EXPECT_TRUE(contains(text, "y           vy;"));
    folder.write("constant/partProperties",
                 "parts { rod { model elastic; } foil { model elastoplastic; } "
                 "film { like foil; } die { model rigidPrescribed; } }");
    folder.write("system/contactDict",
                 "pairs { a { normalScale 2; } b { } c { target wall; } "
                 "d { target wall; enforcement penalty; } } surfaces { wall { type plane; } }");
    text = proposedChartDict(open());
    EXPECT_TRUE(contains(text, "parts.foil.hourglass.plastic"));
    EXPECT_FALSE(contains(text, "parts.rod."));
    EXPECT_FALSE(contains(text, "parts.film."));
    EXPECT_TRUE(contains(text, "((0.6 0.3 0.3)"));
    EXPECT_TRUE(contains(text, "(6 3 3))"));
    EXPECT_FALSE(contains(text, "pairs.c."));
}

TEST_F(ChartProposalTest, RefusesACaseWithoutHistories)
{
    folder.write("system/controlDict", "endTime 1;");
    EXPECT_TRUE(contains(test::refusal([&] { proposedChartDict(open()); }),
                         "no history whose error could be charted"));
}
