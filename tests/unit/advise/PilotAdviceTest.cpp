#include "advise/PilotAdvice.h"

#include "advise/StaticAdvice.h"
#include "unit/advise/symmetricScene.h"
#include "unit/model/CaseFolder.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

const std::vector<std::string> columns{"time",    "kinetic",       "internal", "plastic",
                                       "damping", "bulkViscosity", "external"};

/// Results of symmetricScene: `upper` falls on `lower`, which bends.
class PilotAdviceTest : public testing::Test
{
protected:
    PilotAdviceTest()
    {
        folder_.write(
            "constant/partProperties",
            "parts { lower { model elastic; } upper { like lower; model elastoplastic; } }");
        folder_.write("system/contactDict", "pairs { touch { friction 0.3; } }");
        model_.contactPairs[0].friction = 0.3;
        results_.frames = 11;
        results_.lastTime = model_.control.endTime;
        results_.longestStep = 1e-5;
        results_.parts.resize(2);
        results_.parts[0] = {100, 0, 5, 0.2};
        results_.parts[1] = {200, 0.1, 5, 0.1};
        results_.low = results_.high = model_.mesh.points;
        results_.frictionWork = {500.0};
        results_.energies = Table{columns, {{0, 1000, 0, 0, 10, 10, 0}}};
    }
    /// "kind subject" of all advice but that on precision, which is always there.
    std::vector<std::string> said() const
    {
        std::vector<std::string> words;
        for (const Advice& one : pilotAdvice(model_, folder_.open(), results_))
            if (one.kind != "precision") words.push_back(one.kind + " " + one.subject);
        return words;
    }
    using Words = std::vector<std::string>;

    CaseFolder folder_;
    Model model_ = symmetricScene();
    Results results_;
};

} // namespace

TEST_F(PilotAdviceTest, NothingIsSaidOfWhatEverythingNeeds)
{
    EXPECT_EQ(said(), Words{});
}

TEST_F(PilotAdviceTest, APartStaysElasticBelowHalfItsYieldStress)
{
    results_.parts[1] = {142, 0, 5, 0.1};
    EXPECT_EQ(said(), Words{"elastic part upper stays elastic"});
    results_.parts[1].mises = 143; // yield stress 285
    EXPECT_EQ(said(), Words{});
    results_.parts[1] = {142, 1e-9, 5, 0.1};
    EXPECT_EQ(said(), Words{});
}

TEST_F(PilotAdviceTest, APartMayBeRigidWhereItIsLooseAndDeformsAFiftiethOfTheOthers)
{
    results_.parts[1] = {200, 0, 5, 0.004};
    EXPECT_EQ(said(), Words{}); // the weight acts on its nodes
    std::erase_if(model_.boundaryConditions, [](const auto& c) { return c.name == "weight"; });
    EXPECT_EQ(said(), Words{"rigid part upper may be rigidFree"});
    results_.parts[1].deviation = 0.0041;
    EXPECT_EQ(said(), Words{});
    results_.parts[1].deviation = 0.004;
    model_.parts[0].kind = PartKind::rigidPrescribed; // two rigid parts cannot meet
    EXPECT_EQ(said(), Words{});
}

TEST_F(PilotAdviceTest, WorkBelowATenThousandthOfTheEnergyIsNone)
{
    results_.frictionWork = {0.09};
    EXPECT_EQ(said(), Words{"friction friction of pair touch does no work"});
    results_.frictionWork = {std::nullopt}; // not stated is not none
    EXPECT_EQ(said(), Words{});
    results_.energies->rows[0][5] = 0.09;
    EXPECT_EQ(said(), Words{"viscosity bulkViscosity 0"});
    results_.energies->rows[0][4] = 0.09;
    model_.control.massDamping = 1;
    EXPECT_EQ(said(), (Words{"viscosity bulkViscosity 0", "damping massDamping 0"}));
}

TEST_F(PilotAdviceTest, PartsThatTakeTheirModelFromAnotherKeepIt)
{
    for (Part& part : model_.parts) {
        part.kind = PartKind::elastoplastic;
        part.hardening = {{0, 285}, {1, 1185}};
    }
    folder_.write("constant/partProperties",
                  "parts { lower { model elastoplastic; } upper { like lower; } }");
    for (const bool both : {false, true}) {
        results_.parts[1].plasticStrain = both ? 0 : 0.1;
        results_.parts[1].mises = 100;
        CaseEdits edits;
        for (const Advice& one : pilotAdvice(model_, folder_.open(), results_))
            if (one.kind == "elastic") edits.add(one.edits);
        edits.make(folder_.open(), OutputFolder(folder_.root()));
        const Dictionary parts = folder_.open().dictionary("constant/partProperties").sub("parts");
        EXPECT_EQ(parts.sub("lower").word("model"), "elastic");
        EXPECT_EQ(parts.sub("upper").word("model"), both ? "elastic" : "elastoplastic");
    }
}

TEST_F(PilotAdviceTest, SweptBoxesStayApartByTwiceTheDisplacementBetweenFrames)
{
    // The upper block starts 2 higher and comes down by 1 in some frame.
    for (const Index node : model_.contactPairs[0].contactorNodes) {
        results_.high[std::size_t(node)][2] += 2;
        results_.low[std::size_t(node)][2] += 1;
    }
    results_.fastest = 0.49 / 1e-5;
    EXPECT_EQ(said(), Words{"pairs pair touch does not meet"});
    results_.fastest = 0.51 / 1e-5;
    EXPECT_EQ(said(), Words{});
    results_.fastest = 0.49 / 1e-5;
    results_.lastTime = 0.5 * model_.control.endTime; // who knows what follows
    EXPECT_EQ(said(), Words{});
}

TEST_F(PilotAdviceTest, WithoutResultsThereIsTheSpeedAskedFor)
{
    Model model = symmetricScene();
    std::erase_if(model.boundaryConditions, [](const auto& c) { return c.name == "weight"; });
    // 1000 for 1e-4: 0.1. Both sides may go twice as far: 0.4.
    EXPECT_TRUE(pairAdvice(model).empty());
    for (const Index node : nodesOfPart(model.mesh, 1))
        model.mesh.points[std::size_t(node)][2] += 0.41;
    EXPECT_EQ(pairAdvice(model).size(), 1u);
    for (const Index node : nodesOfPart(model.mesh, 1))
        model.mesh.points[std::size_t(node)][2] -= 0.02;
    EXPECT_TRUE(pairAdvice(model).empty());
}

TEST_F(PilotAdviceTest, FramesThatNobodyReadsNeedNotBeWritten)
{
    Model model = symmetricScene();
    model.control.writeInterval = 1e-5;
    model.control.historyInterval = 1e-7;
    const auto interval = [&](const std::string& probes) {
        folder_.write("system/probeDict", probes);
        const auto advice = outputAdvice(model, folder_.open());
        return advice.empty() ? "" : advice[0].edits.changes.at(0).value;
    };
    EXPECT_EQ(interval("tables { a { type extrema; } }"), "");
    EXPECT_EQ(interval("pictures { a { times (4e-5 8e-5); } }"), "4e-05");
    EXPECT_EQ(interval("pictures { a { times (4e-5 7e-5); } }"), "");
    EXPECT_EQ(interval("pictures { a { field U; } }"), "1e-04");
}

} // namespace fpm::test
