#include "advise/Results.h"

#include "base/Log.h"
#include "case/PerformanceRecord.h"
#include "io/VtkHdf.h"
#include "unit/advise/symmetricScene.h"
#include "unit/model/CaseFolder.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// The scene with frames and histories of two runs.
class ResultsTest : public testing::Test
{
protected:
    ResultsTest()
    {
        History energies;
        energies.name = "energies";
        model_.control.histories = {energies};
        model_.contactPairs[0].friction = 0.3;
        folder_.write(model_.mesh);
    }
    void addFrame(const std::string& name, double lift, const std::string& runId) const
    {
        Frame frame;
        frame.time = std::stod(name);
        frame.runId = runId;
        ResultField u{"U", 3, {}};
        for (std::size_t n = 0; n < model_.mesh.points.size(); ++n)
            u.values.insert(u.values.end(), {0, 0, lift});
        frame.nodeFields = {u};
        writeFrame(OutputFolder(folder_.root()), name, frame, model_.mesh.points.size(),
                   model_.mesh.hexahedra.size());
    }
    void addHistories(const std::string& runId) const
    {
        const std::string file = "postProcessing/energies/0/energies.dat";
        folder_.write(file, "# fpm run " + runId + " " + file + "\n# time kinetic\n0 5\n");
        PerformanceRecord performance;
        performance.runId = runId;
        performance.frictionWork = {{"touch", 7}};
        folder_.write(performanceFile, performance.text());
    }
    std::optional<Results> read()
    {
        said_.clear();
        Log log = Log::into(said_);
        return readResults(folder_.root(), model_, log);
    }

    CaseFolder folder_;
    Model model_ = symmetricScene();
    std::string said_;
};

} // namespace

TEST_F(ResultsTest, AreOfTheRunInStatus)
{
    addFrame("0", 0, "one");
    addFrame("1", 0.5, "one");
    addFrame("2", 9, "two");
    addHistories("one");
    folder_.write("status", "state finished; runId one;\n");

    const auto results = read();

    ASSERT_TRUE(results);
    EXPECT_EQ(results->frames, 2U);
    EXPECT_NEAR(results->high[0][2] - model_.mesh.points[0][2], 0.5, 1e-6);
    EXPECT_EQ(results->frictionWork, std::vector<std::optional<double>>{7.0});
    ASSERT_TRUE(results->energies);
    EXPECT_NE(said_.find("left out: 1 frames of other runs, at times 2"), said_.npos) << said_;
}

TEST_F(ResultsTest, LeaveOutHistoriesOfAnotherRun)
{
    addFrame("0", 0, "two");
    addFrame("1", 0.5, "two");
    addHistories("one");
    folder_.write("status", "state finished; runId two;\n");

    const auto results = read();

    ASSERT_TRUE(results);
    EXPECT_EQ(results->frictionWork, std::vector<std::optional<double>>{std::nullopt});
    EXPECT_FALSE(results->energies);
    EXPECT_NE(said_.find("0/performance is of another run"), said_.npos) << said_;
    EXPECT_NE(said_.find("energies.dat is of another run"), said_.npos) << said_;
}

TEST_F(ResultsTest, AreNoneOfAnotherMesh)
{
    addFrame("0", 0, "one");
    addFrame("1", 0.5, "one");
    folder_.write("status", "state finished; runId one;\n");
    Model other = symmetricScene();
    other.mesh.points[0][0] -= 0.1;
    folder_.write(other.mesh);

    EXPECT_FALSE(read());
    EXPECT_NE(said_.find("left out: 2 frames of another mesh"), said_.npos) << said_;
}

TEST_F(ResultsTest, RefuseAForgedFrameWithFewerNodes)
{
    addFrame("0", 0, "one");
    folder_.write("status", "state finished; runId one;\n");
    Frame frame;
    frame.time = 1;
    frame.runId = "one";
    frame.nodeFields = {{"U", 3, {0, 0, 0}}};
    frame.elementFields = {{"S", 6, {0, 0, 0, 0, 0, 0}}};
    writeFrame(OutputFolder(folder_.root()), "1", frame, 1, 1);

    EXPECT_THROW(read(), Error);
}

TEST_F(ResultsTest, PassOverAForgedFieldWithFewerColumns)
{
    addFrame("0", 0, "one");
    folder_.write("status", "state finished; runId one;\n");
    Frame frame;
    frame.time = 1;
    frame.runId = "one";
    const std::size_t nodes = model_.mesh.points.size();
    const std::size_t elements = model_.mesh.hexahedra.size();
    frame.nodeFields = {{"U", 1, std::vector<double>(nodes, 9)}};
    frame.elementFields = {{"S", 1, std::vector<double>(elements, 9)}};
    writeFrame(OutputFolder(folder_.root()), "1", frame, nodes, elements);

    const auto results = read();

    ASSERT_TRUE(results);
    EXPECT_EQ(results->high[0][2], model_.mesh.points[0][2]);
}

} // namespace fpm::test
