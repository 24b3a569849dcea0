#include "io/FileError.h"
#include "io/HistoryFile.h"
#include "support/TemporaryFolder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>

#include <cerrno>

using namespace fpm;
using test::readBytes;
using test::TemporaryFolder;

namespace {

/// Calls that meet a full disk from now on: reservations, and writes of which half gets through.
int fullReservations = 0, fullWrites = 0;

} // namespace

// In place of the C library's, for this test program.
extern "C" int posix_fallocate(int, off_t, off_t)
{
    return fullReservations > 0 ? (--fullReservations, ENOSPC) : EOPNOTSUPP;
}

extern "C" ssize_t write(int file, const void* bytes, std::size_t count)
{
    if (fullWrites == 0 || file <= STDERR_FILENO) return syscall(SYS_write, file, bytes, count);
    if (count > 1) return syscall(SYS_write, file, bytes, count / 2);
    --fullWrites;
    errno = ENOSPC;
    return -1;
}

namespace {

class FullDiskTest : public testing::Test
{
protected:
    ~FullDiskTest() override { fullReservations = fullWrites = 0; }

    const TemporaryFolder folder;
    int stopAt = 1000;
    std::string said;
    const OutputFolder output{folder.path(),
                              {.waits = true,
                               .shouldStop = [this] { return --stopAt <= 0; },
                               .tell = [this](const std::string& line) { said += line + "\n"; },
                               .pause = std::chrono::milliseconds(1)}};
};

} // namespace

TEST_F(FullDiskTest, AFileIsWrittenOnceThereIsRoom)
{
    const std::string name = (folder / "file").string();
    output.write("file", "old");
    fullReservations = 3;
    output.write("file", "new");

    EXPECT_EQ(readBytes(folder / "file"), "new");
    EXPECT_EQ(said, "disk full: waiting for room for " + name + "\nthere is room again: wrote "
                        + name + "\n");
}

TEST_F(FullDiskTest, NothingIsLeftWhileAFileWaits)
{
    output.write("file", "old");
    fullWrites = 1000;
    stopAt = 3;
    EXPECT_THROW(output.write("file", "new text"), Error);

    EXPECT_EQ(readBytes(folder / "file"), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST_F(FullDiskTest, AHistoryGoesOnWithoutAHalfRow)
{
    HistoryFile history(output, "tip.dat", {"time", "ux"});
    fullWrites = 3;
    history.append({1.0, 2.5});

    EXPECT_EQ(readBytes(folder / "tip.dat"), "# time ux\n1 2.5\n");
    EXPECT_EQ(history.size(), readBytes(folder / "tip.dat").size());
    EXPECT_EQ(fullWrites, 0);
}

TEST_F(FullDiskTest, WithoutWaitingItIsAnError)
{
    const OutputFolder impatient(folder.path());
    fullReservations = 1;
    try {
        impatient.write("file", "text");
        ADD_FAILURE() << "no error";
    } catch (const FileError& error) {
        EXPECT_TRUE(error.isFullDisk());
        EXPECT_EQ(error.code(), ExitCode::fileIo);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}
