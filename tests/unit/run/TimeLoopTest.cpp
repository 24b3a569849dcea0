#include "run/TimeLoop.h"

#include "case/PerformanceRecord.h"
#include "case/RunResults.h"
#include "dictionary/Dictionary.h"
#include "support/TemporaryFolder.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// A block thrown as a whole, made in memory: nothing of a case but the folder it is run in.
Model thrownBlock()
{
    Model model =
        boxModel({2, 2, 2}, {2, 2, 2}, aluminium(PartKind::elastic, HourglassForm::physical));
    std::vector<Index> all(model.mesh.points.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = Index(i);
    model.initialVelocities.push_back({"thrown", all, {1000, 0, 0}});
    model.control.endTime = 4e-6;
    model.control.writeInterval = 2e-6;
    model.control.historyInterval = 1e-6;
    model.control.histories.resize(1);
    model.control.histories[0].name = "energies";
    return model;
}

TEST(TimeLoop, LeavesFramesHistoriesAndRecordsOfOneRun)
{
    const TemporaryFolder folder;
    const Model model = thrownBlock();
    const auto solver = startedSolver(model);
    std::string said;
    Log log = Log::into(said);

    runTimeLoop(*solver, model, folder.path(), {}, log);

    EXPECT_NE(said.find("finished, healthy"), said.npos) << said;
    const auto status = readStatus(folder.path());
    ASSERT_TRUE(status);
    EXPECT_EQ(status->state, RunState::finished);
    EXPECT_EQ(status->time, 4e-6);
    EXPECT_EQ(RunResults(folder.path()).frames().size(), 3u);
    const auto performance = readPerformance(folder.path());
    ASSERT_TRUE(performance);
    EXPECT_EQ(performance->runId, status->runId);
    EXPECT_EQ(performance->steps, solver->clock().steps);
    EXPECT_EQ(performance->elements, 8);
    const auto health = Dictionary::read(folder / "postProcessing/health/0/health", folder.path());
    EXPECT_EQ(health.word("runId"), status->runId);
    const Table energies = readTable(folder / "postProcessing/energies/0/energies.dat");
    EXPECT_EQ(otherRunOf(energies, status->runId), "");
    EXPECT_EQ(energies.rows.size(), 5u);
}

TEST(TimeLoop, EndsAfterItsMostStepsAndIsStrictWhereAsked)
{
    const TemporaryFolder folder;
    Model model = thrownBlock();
    model.parts[0].massFactor = 2; // mass that is added to a body in flight is a finding
    Log log = Log::quiet();
    const auto solver = startedSolver(model);
    try {
        runTimeLoop(*solver, model, folder.path(), {.maxSteps = 3, .strict = true}, log);
        FAIL() << "no finding";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unhealthy) << error.what();
    }
    EXPECT_EQ(solver->clock().steps, 3);
    EXPECT_EQ(readStatus(folder.path())->state, RunState::finished);
}

} // namespace
} // namespace fpm::test
