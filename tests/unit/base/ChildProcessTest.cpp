#include "base/ChildProcess.h"

#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>

#include <csignal>

using namespace fpm;

namespace {

const ChildTask task{"foreign.msh", ExitCode::mesh, "export it again"};

} // namespace

TEST(InChild, ReturnsTheBytesOfTheWork)
{
    int here = 0;
    const std::string bytes("\0e\n", 3);
    EXPECT_EQ(inChild(task,
                      [&] {
                          here = 1;
                          return bytes;
                      }),
              bytes);
    EXPECT_EQ(here, 0); // done by another process
}

TEST(InChild, ThrowsTheErrorOfTheWorkAgain)
{
    try {
        inChild(task, []() -> std::string { throw Error(ExitCode::memory, "too long", "cut it"); });
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::memory);
        EXPECT_STREQ(error.what(), "too long");
        EXPECT_EQ(error.advice(), "cut it");
    }
}

TEST(InChild, OutlivesAChildThatDies)
{
    try {
        inChild(task, []() -> std::string {
            std::raise(SIGKILL);
            return "";
        });
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::mesh);
        EXPECT_STREQ(error.what(),
                     "foreign.msh: rejected, the reader took too much time or memory");
        EXPECT_EQ(error.advice(), "export it again");
    }
}

class RunProcess : public testing::Test
{
protected:
    TemporaryCase case_;

    ProcessEnd run(const std::string& script, double limit = 1e9)
    {
        return runProcess({"/bin/sh", "-c", script}, case_.root(), case_.root() / "log", limit);
    }
};

TEST_F(RunProcess, TellsTheExitCodeAndKeepsTheOutput)
{
    const ProcessEnd end = run("pwd; echo said >&2; exit 7");
    EXPECT_EQ(end.exitCode, 7);
    EXPECT_FALSE(end.succeeded());
    EXPECT_GT(end.peakMemory, 0);
    EXPECT_EQ(case_.read("log"), std::filesystem::canonical(case_.root()).string() + "\nsaid\n");
}

TEST_F(RunProcess, TellsTheSignalAndTheTimeLimit)
{
    EXPECT_EQ(run("kill -TERM $$").signal, SIGTERM);
    const ProcessEnd late = run("exec sleep 60", 0.1);
    EXPECT_TRUE(late.timedOut);
    EXPECT_LT(late.wall, 30);
}

TEST_F(RunProcess, RefusesWhatIsNoProgram)
{
    EXPECT_THROW(runProcess({"/no/such/program"}, case_.root(), case_.root() / "log"), Error);
}
