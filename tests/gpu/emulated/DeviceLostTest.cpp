// A GPU that fails in the middle of a run: what the run says, what it leaves, and how it goes on.

#include "case/RunStatus.h"
#include "gpu/parityScenes.h"
#include "run/Checkpoints.h"
#include "run/TimeLoop.h"
#include "support/TemporaryFolder.h"
#include "support/cudaStandIn/Device.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace fpm::test {
namespace {

class DeviceLost : public testing::Test
{
protected:
    DeviceLost()
    {
        model.control.backend = "cuda";
        model.control.endTime = 4e-6;
        model.control.writeInterval = 1e-6;
        model.control.historyInterval = 2e-7;
        model.control.checkpoint = {0, 7, 2};
    }
    ~DeviceLost() override
    {
        unsetenv("CUDA_STAND_IN_LOST_AT");
        cudaStandIn::reset();
    }
    /// Loses the device at a launch after the solver's start; the error of the run.
    Error loseAt(const char* launch)
    {
        const auto solver = startedSolver(model);
        cudaStandIn::reset();
        setenv("CUDA_STAND_IN_LOST_AT", launch, 1);
        Log log = Log::quiet();
        try {
            runTimeLoop(*solver, model, folder.path(), {}, log);
        } catch (const Error& error) {
            return error;
        }
        return Error(ExitCode::internal, "no error");
    }
    /// The state at the end of a run in a folder, from its start or from its checkpoint.
    std::uint64_t stateOnTheProcessor(const TemporaryFolder& place, bool latest)
    {
        model.control.backend = "serial";
        model.control.latest = latest;
        Log log = Log::quiet();
        const auto from = findCheckpoint(place.path(), model.control, {}, log);
        EXPECT_EQ(from.has_value(), latest);
        const auto solver = makeSolver(model);
        from ? solver->restore(from->state) : solver->start();
        RunOptions options;
        options.from = from ? &*from : nullptr;
        runTimeLoop(*solver, model, place.path(), options, log);
        return stateChecksum(*solver);
    }

    Model model = plain();
    const TemporaryFolder folder, whole;
};

TEST_F(DeviceLost, TheRunNamesTheCommandThatGoesOnFromTheLastCheckpoint)
{
    const Error error = loseAt("400");
    EXPECT_EQ(error.code(), ExitCode::deviceLost) << error.what();
    EXPECT_EQ(int(error.code()), 9);
    EXPECT_NE(std::string(error.what()).find("CUDA: "), std::string::npos) << error.what();
    const auto label = checkpointLabel(folder.path() / checkpointFile);
    ASSERT_TRUE(label);
    EXPECT_GT(label->steps, 0);
    EXPECT_NE(error.advice().find("'fpmExplicit -continue' goes on from the checkpoint at step "
                                  + std::to_string(label->steps)),
              std::string::npos)
        << error.advice();
    EXPECT_EQ(readStatus(folder.path())->state, RunState::failed);

    EXPECT_EQ(stateOnTheProcessor(folder, true), stateOnTheProcessor(whole, false));
    EXPECT_EQ(readStatus(folder.path())->state, RunState::finished);
}

TEST_F(DeviceLost, BeforeTheFirstCheckpointTheRunStartsAgain)
{
    const Error error = loseAt("20");
    EXPECT_EQ(error.code(), ExitCode::deviceLost) << error.what();
    EXPECT_FALSE(std::filesystem::exists(folder.path() / checkpointFile));
    EXPECT_EQ(error.advice().find("-continue"), std::string::npos) << error.advice();
    EXPECT_NE(error.advice().find("start the run again"), std::string::npos) << error.advice();
}

} // namespace
} // namespace fpm::test
