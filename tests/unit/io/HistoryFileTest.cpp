#include "io/HistoryFile.h"

#include "base/Error.h"
#include "io/FileError.h"
#include "io/Table.h"
#include "support/FileSizeLimit.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

using namespace fpm;
namespace fs = std::filesystem;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

namespace {

class HistoryFileTest : public testing::Test
{
protected:
    HistoryFile resume(std::uint64_t size, const std::string& note = "fpm run one tip.dat") const
    {
        return HistoryFile::resume(output, "tip.dat", {"time", "ux"}, {note}, size);
    }
    std::string refusal(std::uint64_t size, const std::string& note = "fpm run one tip.dat") const
    {
        try {
            resume(size, note);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::checkpoint);
            return error.what();
        }
        return "no error";
    }

    const TemporaryFolder folder;
    const OutputFolder output{folder.path()};
};

} // namespace

TEST_F(HistoryFileTest, CanBeReadWhileItGrows)
{
    HistoryFile history(output, "a/b/displacement.dat", {"time", "ux"});

    history.append({0.0, 0.1});
    history.append(std::vector<double>{1e-6, -0.25});

    const std::string text = "# time ux\n0 0.1\n1e-06 -0.25\n";
    EXPECT_EQ(readBytes(folder / "a/b/displacement.dat"), text);
    EXPECT_EQ(history.size(), text.size());
    EXPECT_EQ(readTable(folder / "a/b/displacement.dat").rows.size(), 2U);
}

TEST_F(HistoryFileTest, RefusesRowsOfAnotherLengthAndMissingFolders)
{
    HistoryFile history(output, "a.dat", {"time", "ux"});
    writeBytes(folder / "file", "");

    EXPECT_THROW(history.append({1.0}), Error);
    EXPECT_THROW(HistoryFile(output, "file/b.dat", {"time"}), FileError);
}

TEST_F(HistoryFileTest, IsWrittenThroughNoLink)
{
    writeBytes(folder / "other", "kept");
    fs::create_symlink("other", folder / "tip.dat");
    fs::create_hard_link(folder / "other", folder / "second.dat");

    EXPECT_THROW(HistoryFile(output, "tip.dat", {"time"}), FileError);
    EXPECT_THROW(HistoryFile(output, "second.dat", {"time"}), FileError);

    EXPECT_EQ(readBytes(folder / "other"), "kept");
}

TEST_F(HistoryFileTest, GoesOnWhereACheckpointWasTaken)
{
    std::uint64_t size = 0;
    {
        HistoryFile history(output, "tip.dat", {"time", "ux"}, {"fpm run one tip.dat"});
        history.append({0.0, 0.5});
        history.synchronise();
        size = history.size();
        history.append({1.0, 1.5});
    }
    const std::string upToThere = readBytes(folder / "tip.dat").substr(0, size);

    HistoryFile history = resume(size);
    EXPECT_EQ(readBytes(folder / "tip.dat"), upToThere);
    history.append({1.0, 2.5});

    EXPECT_EQ(readBytes(folder / "tip.dat"), upToThere + "1 2.5\n");
    EXPECT_EQ(history.size(), size + 6);
}

TEST_F(HistoryFileTest, DoesNotGoOnWithAnotherFile)
{
    const std::string path = "cannot go on with '" + (folder / "tip.dat").string() + "': ";
    std::uint64_t size = 0;
    {
        HistoryFile history(output, "tip.dat", {"time", "ux"}, {"fpm run one tip.dat"});
        history.append({0.0, 0.5});
        size = history.size();
    }
    const std::string before = readBytes(folder / "tip.dat");

    EXPECT_EQ(refusal(size + 1), path + "it has 38 bytes, and 39 at the checkpoint");
    EXPECT_EQ(refusal(size, "fpm run two tip.dat"), path + "its head is not that of this run");
    EXPECT_EQ(refusal(3), path + "its head is not that of this run");
    EXPECT_THROW(HistoryFile::resume(output, "none.dat", {"time"}, {}, 0), FileError);

    EXPECT_EQ(readBytes(folder / "tip.dat"), before);
    EXPECT_EQ(refusal(size), "no error");
}

TEST_F(HistoryFileTest, HasNoHalfRowWhenTheDiskIsFull)
{
    HistoryFile history(output, "tip.dat", {"time", "ux"});
    history.append({0.0, 0.5});
    const std::string before = readBytes(folder / "tip.dat");
    {
        const test::FileSizeLimit limit(before.size() + 3);
        EXPECT_THROW(history.append({1.0, 1.5}), FileError);
    }
    EXPECT_EQ(readBytes(folder / "tip.dat"), before);

    history.append({1.0, 1.5});

    EXPECT_EQ(readBytes(folder / "tip.dat"), before + "1 1.5\n");
}
