#include "case/CaseLock.h"

#include "base/Error.h"
#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <optional>

namespace fpm {

namespace {

namespace fs = std::filesystem;

std::optional<Error> refusal(const fs::path& root)
{
    try {
        const CaseLock lock(root, "fpmMesh");
    } catch (const Error& error) {
        return error;
    }
    return std::nullopt;
}

} // namespace

TEST(CaseLock, KeepsASecondWriterOutAndNamesTheFirst)
{
    const TemporaryCase folder;
    const CaseLock first(folder.root(), "fpmExplicit");

    const auto second = refusal(folder.root());

    ASSERT_TRUE(second);
    EXPECT_EQ(second->code(), ExitCode::caseLocked);
    const auto expected = "fpmExplicit, process " + std::to_string(getpid()) + " on ";
    EXPECT_NE(std::string(second->what()).find(expected), std::string::npos) << second->what();
}

TEST(CaseLock, FallsWithItsHolder)
{
    const TemporaryCase folder;
    {
        const CaseLock lock(folder.root(), "fpmExplicit");
    }

    EXPECT_TRUE(folder.has(".lock"));
    EXPECT_FALSE(refusal(folder.root()));
}

TEST(CaseLock, FallsWhenItsProcessIsKilled)
{
    const TemporaryCase folder;
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        const CaseLock lock(folder.root(), "fpmExplicit");
        [[maybe_unused]] const auto written = write(ready[1], "x", 1);
        pause();
    }
    char byte = 0;
    ASSERT_EQ(read(ready[0], &byte, 1), 1);
    EXPECT_TRUE(refusal(folder.root()));

    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);

    EXPECT_FALSE(refusal(folder.root()));
    close(ready[0]);
    close(ready[1]);
}

TEST(CaseLock, IsNotTakenInByALeftoverFile)
{
    const TemporaryCase folder;
    folder.write(".lock", "fpmExplicit, process 1 on elsewhere, since yesterday\n");

    EXPECT_FALSE(refusal(folder.root()));
}

TEST(CaseLock, RefusesToWriteThroughALink)
{
    const TemporaryCase folder;
    folder.write("victim", "precious");
    fs::create_symlink("victim", folder.root() / ".lock");
    ASSERT_TRUE(refusal(folder.root()));
    EXPECT_EQ(refusal(folder.root())->code(), ExitCode::fileIo);

    fs::remove(folder.root() / ".lock");
    fs::create_hard_link(folder.root() / "victim", folder.root() / ".lock");
    ASSERT_TRUE(refusal(folder.root()));
    EXPECT_EQ(folder.read("victim"), "precious");
}

TEST(CaseLock, RefusesAPipeWithoutWaiting)
{
    const TemporaryCase folder;
    ASSERT_EQ(mkfifo((folder.root() / ".lock").c_str(), 0600), 0);

    ASSERT_TRUE(refusal(folder.root()));
    EXPECT_EQ(refusal(folder.root())->code(), ExitCode::fileIo);
}

TEST(CaseLock, PrintsAForeignNoteHarmlessly)
{
    const TemporaryCase folder;
    const CaseLock first(folder.root(), "fpmExplicit");
    folder.write(".lock", "\x1B[2Jgone\xFF\nmore");

    const auto second = refusal(folder.root());

    ASSERT_TRUE(second);
    EXPECT_NE(std::string(second->what()).find("in use by ?[2Jgone?"), std::string::npos);
}

TEST(CaseLock, SaysWhenTheFolderIsMissing)
{
    ASSERT_TRUE(refusal("/nonexistent/case"));
    EXPECT_EQ(refusal("/nonexistent/case")->code(), ExitCode::fileIo);
}

} // namespace fpm
