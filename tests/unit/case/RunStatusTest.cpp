#include "case/RunStatus.h"

#include "base/Machine.h"
#include "case/CaseLock.h"
#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>

#include <set>

namespace fpm {

namespace {

RunStatus example(RunState state)
{
    RunStatus status;
    status.state = state;
    status.runId = "20260131-120000-1a2b3c4d";
    status.time = 2.5e-5;
    status.steps = 1234;
    status.wallSeconds = 1.5;
    status.process = processNumber();
    status.host = hostName();
    status.started = "2026-01-31T12:00:00Z";
    return status;
}

} // namespace

TEST(RunStatus, ReadsBackWhatWasWritten)
{
    const TemporaryCase folder;
    for (const RunState state : {RunState::finished, RunState::stopped, RunState::failed}) {
        const RunStatus written = example(state);
        folder.write("status", written.text());

        const auto read = readStatus(folder.root());

        ASSERT_TRUE(read);
        EXPECT_EQ(read->state, state);
        EXPECT_EQ(read->text(), written.text());
    }
}

TEST(RunStatus, IsRunningOnlyWhileItsProcessHoldsTheCase)
{
    const TemporaryCase folder;
    RunStatus status = example(RunState::running);
    folder.write("status", status.text());
    EXPECT_EQ(readStatus(folder.root())->state, RunState::died) << "no lock at all";
    {
        const CaseLock lock(folder.root(), "fpmExplicit");
        EXPECT_EQ(readStatus(folder.root())->state, RunState::running);
        ++status.process;
        folder.write("status", status.text());
        EXPECT_EQ(readStatus(folder.root())->state, RunState::died) << "held by another process";
        folder.write(".lock", "");
        EXPECT_EQ(readStatus(folder.root())->state, RunState::running)
            << "by one that is not named";
    }
    EXPECT_EQ(readStatus(folder.root())->state, RunState::died) << "the lock has fallen";
}

TEST(RunStatus, OfAnOlderVersionHasNoRun)
{
    const TemporaryCase folder;
    folder.write("status", "state finished;\ntime 1e-4;\nsteps 10;\nwallSeconds 0.5;\n");

    const auto read = readStatus(folder.root());

    ASSERT_TRUE(read);
    EXPECT_EQ(read->runId, "");
    EXPECT_EQ(read->time, 1e-4);
    EXPECT_EQ(describe(*read, folder.root()), "run finished at time 0.0001");
}

TEST(RunStatus, IsNothingWhereTheFileIsMissingOrNotOurs)
{
    const TemporaryCase folder;
    EXPECT_FALSE(readStatus(folder.root()));
    for (const char* text :
         {"", "state", "state sleeping;", "all is well\n", "state finished; time x;"}) {
        folder.write("status", text);
        EXPECT_FALSE(readStatus(folder.root())) << text;
    }
}

TEST(RunStatus, TellsHowARunEnded)
{
    const TemporaryCase folder;
    const std::string run = "run 20260131-120000-1a2b3c4d ";
    folder.write("why.txt", "step 10: element 3 has\tno volume\nmore\n");

    EXPECT_EQ(describe(example(RunState::finished), folder.root()),
              run + "finished at time 2.5e-05");
    EXPECT_EQ(describe(example(RunState::stopped), folder.root()),
              run + "was stopped at time 2.5e-05");
    EXPECT_EQ(describe(example(RunState::failed), folder.root()),
              run + "failed at time 2.5e-05: step 10: element 3 has?no volume");
    RunStatus dead = example(RunState::died);
    dead.process = 12, dead.host = "there";
    EXPECT_EQ(describe(dead, folder.root()),
              run + "died after time 2.5e-05: process 12 on there is gone");
}

TEST(RunStatus, IdsAreUniqueAndSort)
{
    std::set<std::string> ids;
    for (int i = 0; i < 100; ++i) ids.insert(makeRunId());
    EXPECT_EQ(ids.size(), 100U);
    for (const std::string& id : ids) {
        EXPECT_EQ(id.size(), 24U) << id;
        EXPECT_EQ(id.find_first_not_of("0123456789abcdef-"), id.npos) << id;
    }
}

} // namespace fpm
