#include "case/StatusFile.h"

#include "base/Error.h"
#include "case/RunStatus.h"
#include "support/FileSizeLimit.h"
#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <thread>

namespace fpm {

namespace {

namespace fs = std::filesystem;

/// Text in the file of a case.
std::string textIn(const TemporaryCase& folder)
{
    return statusText(folder.read("status")).value_or("of another");
}

ino_t numberOf(const TemporaryCase& folder)
{
    struct stat status {};
    ::stat((folder.root() / "status").c_str(), &status);
    return status.st_ino;
}

std::string lines(int count)
{
    std::string text;
    for (int i = 0; i < count; ++i) text += "figure" + std::to_string(i) + " 1;\n";
    return text;
}

} // namespace

TEST(StatusFile, IsRewrittenWhereItLies)
{
    const TemporaryCase folder;
    StatusFile file(OutputFolder(folder.root()), "state running;\ntime 1;\n");
    const auto number = numberOf(folder);
    const auto size = fs::file_size(folder.root() / "status");
    EXPECT_EQ(textIn(folder), "state running;\ntime 1;\n");

    file.rewrite("state finished;\n", true);

    EXPECT_EQ(textIn(folder), "state finished;\n");
    EXPECT_EQ(numberOf(folder), number);
    EXPECT_EQ(fs::file_size(folder.root() / "status"), size);
}

TEST(StatusFile, IsMadeAgainForALongerTextOrWhenItIsGone)
{
    const TemporaryCase folder;
    StatusFile file(OutputFolder(folder.root()), "state running;\n");

    file.rewrite(lines(60), false);
    EXPECT_EQ(textIn(folder), lines(60));
    file.rewrite("state running;\n", false);
    EXPECT_EQ(textIn(folder), "state running;\n");
    fs::rename(folder.root() / "status", folder.root() / "moved");
    file.rewrite("state finished;\n", true);

    EXPECT_EQ(textIn(folder), "state finished;\n");
    EXPECT_EQ(statusText(folder.read("moved")), "state running;\n");
}

TEST(StatusFile, NeedsNoRoomOnAFullDisk)
{
    const TemporaryCase folder;
    StatusFile file(OutputFolder(folder.root()), "state running;\n");
    {
        // No file may be made longer, as on a full disk.
        const test::FileSizeLimit limit(fs::file_size(folder.root() / "status"));
        file.rewrite("state failed;\nfailedFile \"0.1/fields.vtkhdf\";\n" + lines(100), true);
    }
    const std::string text = textIn(folder);
    EXPECT_EQ(text.find("state failed;\nfailedFile \"0.1/fields.vtkhdf\";\nfigure0 1;\n"), 0u);
    EXPECT_EQ(text.back(), '\n');
    EXPECT_LT(text.size(), 512u);
}

TEST(StatusFile, LeavesOutLinesBeyondABlock)
{
    const TemporaryCase folder;
    StatusFile(OutputFolder(folder.root()), "state running;\n" + lines(1000));

    EXPECT_EQ(fs::file_size(folder.root() / "status"), 4096u);
    EXPECT_EQ(textIn(folder).find("state running;\nfigure0 1;\n"), 0u);
}

TEST(StatusFile, TextsThatWereMixedAreNone)
{
    const TemporaryCase folder;
    StatusFile file(OutputFolder(folder.root()), "state running;\ntime 1;\n");
    std::string mixed = folder.read("status");
    mixed.replace(mixed.find("time 1"), 6, "time 2");

    EXPECT_EQ(statusText(mixed), std::nullopt);
    EXPECT_EQ(statusText("state running;\n"), "state running;\n") << "of an older version";
    EXPECT_EQ(statusText(""), "");
}

TEST(StatusFile, IsNeverReadHalf)
{
    const TemporaryCase folder;
    RunStatus status;
    status.state = RunState::finished;
    status.runId = "0";
    StatusFile file(OutputFolder(folder.root()), status.text());
    std::atomic<bool> stop{false};
    std::thread writer([&] {
        for (std::int64_t step = 1; !stop; ++step) {
            status.steps = step;
            status.time = double(step);
            status.runId = std::string(1 + std::size_t(step % 200), char('a' + step % 26));
            file.rewrite(status.text(), false);
        }
    });
    int mixed = 0, none = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto read = readStatus(folder.root());
        none += !read;
        if (read
            && (read->time != double(read->steps)
                || (read->steps > 0 && read->runId.size() != std::size_t(1 + read->steps % 200))))
            ++mixed;
    }
    stop = true;
    writer.join();
    EXPECT_EQ(mixed, 0);
    EXPECT_EQ(none, 0);
}

} // namespace fpm
