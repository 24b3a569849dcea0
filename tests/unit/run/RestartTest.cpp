#include "case/PerformanceRecord.h"
#include "case/RunStatus.h"
#include "run/Checkpoints.h"
#include "run/TimeLoop.h"
#include "support/TemporaryFolder.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace fpm::test {
namespace {

namespace fs = std::filesystem;

Model impact()
{
    Model model =
        twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {3e4, -2e4, -1e5}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    model.control.endTime = 2e-5;
    model.control.writeInterval = 5e-6;
    model.control.historyInterval = 1e-6;
    model.control.histories.resize(2);
    model.control.histories[0].name = "energies";
    model.control.histories[1].name = "forces";
    model.control.histories[1].kind = History::Kind::contactForces;
    return model;
}

std::string contentOf(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Every history and the fields of every frame, without the id of their run.
std::map<std::string, std::string> resultsIn(const fs::path& folder)
{
    const std::string id = readStatus(folder)->runId;
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string file = fs::relative(entry.path(), folder).string();
        const bool isHistory = file.ends_with(".dat"), isFrame = file.ends_with(".vtkhdf");
        if (!entry.is_regular_file() || (!isHistory && !isFrame) || file.starts_with("later"))
            continue;
        std::string text = contentOf(entry.path());
        if (isFrame) text.resize(text.size() - 8); // its checksum
        for (auto at = text.find(id); at != text.npos; at = text.find(id))
            text.erase(at, id.size());
        out[file] = text;
    }
    return out;
}

struct Ended {
    std::uint64_t state = 0;
    std::string said;
};

Ended runWhole(const Model& model, const fs::path& folder, std::int64_t maxSteps = -1)
{
    Ended out;
    Log log = Log::into(out.said);
    const auto solver = startedSolver(model);
    RunOptions options;
    options.maxSteps = maxSteps;
    runTimeLoop(*solver, model, folder, options, log);
    out.state = stateChecksum(*solver);
    return out;
}

Ended goOn(Model model, const fs::path& folder)
{
    Ended out;
    Log log = Log::into(out.said);
    model.control.latest = true;
    const std::optional<Checkpoint> from = findCheckpoint(folder, model.control, {}, log);
    if (!from) throw Error(ExitCode::checkpoint, "none was found");
    const auto solver = makeSolver(model);
    solver->restore(from->state);
    RunOptions options;
    options.from = &*from;
    runTimeLoop(*solver, model, folder, options, log);
    out.state = stateChecksum(*solver);
    return out;
}

TEST(Restart, AtAnyStepLeavesWhatOneRunLeaves)
{
    const Model model = impact();
    const TemporaryFolder whole;
    const Ended expected = runWhole(model, whole.path());
    const auto results = resultsIn(whole.path());
    EXPECT_EQ(results.size(), 2 + 5u);
    for (const std::int64_t steps : {1, 2, 33, 150, 151, 152, 300}) {
        const TemporaryFolder parts;
        runWhole(model, parts.path(), steps);
        Model other = model;
        other.control.backend = "openmp";
        other.control.threads = 2;
        other.control.simd = "scalar";
        const Ended found = goOn(other, parts.path());
        EXPECT_EQ(found.state, expected.state) << steps;
        const auto now = resultsIn(parts.path());
        for (const auto& [file, text] : results)
            EXPECT_TRUE(now.contains(file) && now.at(file) == text) << file << " from " << steps;
        EXPECT_EQ(now.size(), results.size()) << steps;
    }
}

TEST(Restart, ALaterEndIsReachedAndAnEarlierOneIsNothingToDo)
{
    Model model = impact();
    const TemporaryFolder folder;
    runWhole(model, folder.path());
    model.control.endTime = 3e-5;
    goOn(model, folder.path());
    const auto status = readStatus(folder.path());
    EXPECT_EQ(status->state, RunState::finished);
    EXPECT_EQ(status->time, 3e-5);
    EXPECT_TRUE(fs::exists(folder.path() / "2.5e-05/fields.vtkhdf"));
}

TEST(Restart, TheRecordTellsOfTheWholeRunAndOfItsLastPart)
{
    const Model model = impact();
    const TemporaryFolder folder;
    runWhole(model, folder.path(), 100);
    const auto first = readPerformance(folder.path());
    ASSERT_TRUE(first);
    EXPECT_EQ(first->parts, 1);
    EXPECT_EQ(first->partSteps, 100);
    EXPECT_EQ(first->partSeconds, first->wallSeconds);
    EXPECT_GT(first->partSeconds, 0);
    const auto label = checkpointLabel(folder.path() / checkpointFile);
    ASSERT_TRUE(label);
    EXPECT_GT(label->wallSeconds, 0);
    EXPECT_GT(label->cpuSeconds, 0);
    EXPECT_GT(label->lastStep, 0);

    const Ended ended = goOn(model, folder.path());
    const auto second = readPerformance(folder.path());
    ASSERT_TRUE(second);
    EXPECT_EQ(second->parts, 2);
    EXPECT_EQ(second->partSteps, second->steps - 100);
    EXPECT_NEAR(second->wallSeconds, first->wallSeconds + second->partSeconds,
                1e-4 * second->wallSeconds); // written with six digits
    EXPECT_NE(ended.said.find("in 2 parts"), std::string::npos) << ended.said;
}

TEST(Restart, ADamagedCheckpointIsPassedOverForTheOneBefore)
{
    Model model = impact();
    model.control.checkpoint.steps = 100;
    const TemporaryFolder whole, folder;
    const Ended expected = runWhole(model, whole.path());
    runWhole(model, folder.path(), 250); // checkpoints of steps 200 and 250
    const fs::path newest = folder.path() / checkpointFile;
    fs::resize_file(newest, fs::file_size(newest) / 2);
    const Ended found = goOn(model, folder.path());
    EXPECT_EQ(found.state, expected.state);
    EXPECT_NE(found.said.find("state.h5 is damaged or cut short"), std::string::npos) << found.said;
    EXPECT_NE(found.said.find("step 200"), std::string::npos) << found.said;
}

TEST(Restart, NoWholeCheckpointIsAnErrorThatTouchesNothing)
{
    const Model model = impact();
    const TemporaryFolder folder;
    runWhole(model, folder.path(), 100);
    std::string bytes = contentOf(folder.path() / checkpointFile);
    bytes[bytes.size() / 2] ^= 1;
    std::ofstream(folder.path() / checkpointFile, std::ios::binary) << bytes;
    const auto before = resultsIn(folder.path());
    try {
        goOn(model, folder.path());
        FAIL() << "a damaged checkpoint was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::checkpoint) << error.what();
    }
    EXPECT_EQ(resultsIn(folder.path()), before);
}

TEST(Restart, IsRefusedByAnotherModel)
{
    Model model = impact();
    const TemporaryFolder folder;
    runWhole(model, folder.path(), 10);
    model.contactPairs.clear();
    EXPECT_THROW(goOn(model, folder.path()), Error);
}

TEST(Restart, KeepsSoManyCheckpointsAndFindsThemByTheirTime)
{
    Model model = impact();
    model.control.checkpoint = {0, 50, 3};
    const TemporaryFolder folder;
    runWhole(model, folder.path(), 240);
    EXPECT_TRUE(fs::exists(folder.path() / "checkpoint/state.2.h5"));
    EXPECT_FALSE(fs::exists(folder.path() / "checkpoint/state.3.h5"));
    const auto label = checkpointLabel(folder.path() / "checkpoint/state.1.h5");
    ASSERT_TRUE(label);
    EXPECT_EQ(label->steps, 200);
    std::string said;
    Log log = Log::into(said);
    model.control.startTime = label->time;
    EXPECT_EQ(findCheckpoint(folder.path(), model.control, {}, log)->steps, 200);
    model.control.startTime = 2 * label->time;
    EXPECT_THROW(findCheckpoint(folder.path(), model.control, {}, log), Error);
    model.control.startTime = 0;
    EXPECT_FALSE(findCheckpoint(folder.path(), model.control, {}, log));
}

TEST(Restart, NoneIsWrittenOfAStateThatIsLost)
{
    Model model = impact();
    model.control.fixedTimeStep = 3e-7; // far beyond the bound
    model.control.beyondBound = true;
    const TemporaryFolder folder;
    EXPECT_THROW(runWhole(model, folder.path()), Error);
    EXPECT_FALSE(fs::exists(folder.path() / checkpointFile));
    EXPECT_TRUE(fs::exists(folder.path() / "failed/fields.vtkhdf"));
}

TEST(Restart, StopsAsStopAtSaysAndGoesOn)
{
    const TemporaryFolder whole;
    const Model model = impact();
    const Ended expected = runWhole(model, whole.path());
    const TemporaryFolder folder;
    Model stops = model;
    stops.control.stopAt = StopAt::nextWrite;
    try {
        runWhole(stops, folder.path());
        FAIL() << "it did not stop";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::stopped) << error.what();
    }
    EXPECT_EQ(readStatus(folder.path())->state, RunState::stopped);
    EXPECT_EQ(readStatus(folder.path())->time, 5e-6);
    EXPECT_EQ(goOn(model, folder.path()).state, expected.state);
    EXPECT_EQ(resultsIn(folder.path()), resultsIn(whole.path()));
}

TEST(Restart, MaxWallTimeEndsBeforeItIsOver)
{
    Model model = impact();
    model.control.maxWallTime = 1e-3;
    const TemporaryFolder folder;
    try {
        runWhole(model, folder.path());
        FAIL() << "it did not stop";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::stopped) << error.what();
    }
    EXPECT_TRUE(fs::exists(folder.path() / checkpointFile));
}

TEST(Restart, PurgeKeepsTheLatestFrames)
{
    Model model = impact();
    model.control.purgeWrite = 2;
    const TemporaryFolder folder;
    runWhole(model, folder.path());
    EXPECT_FALSE(fs::exists(folder.path() / "0"));
    EXPECT_FALSE(fs::exists(folder.path() / "1e-05"));
    EXPECT_TRUE(fs::exists(folder.path() / "1.5e-05/fields.vtkhdf"));
    EXPECT_TRUE(fs::exists(folder.path() / "2e-05/fields.vtkhdf"));
}

} // namespace
} // namespace fpm::test
