#include "io/AtomicFile.h"

#include "base/Error.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

using namespace fpm;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

namespace {

std::size_t entries(const std::filesystem::path& folder)
{
    using Iterator = std::filesystem::directory_iterator;
    return std::size_t(std::distance(Iterator(folder), Iterator()));
}

/// Lets no file of this process grow beyond `bytes`, as a full disk would, until it is destroyed.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    void (*handler_)(int);
    rlimit before_{};
};

} // namespace

TEST(AtomicFile, HoldsExactlyTheBytes)
{
    const TemporaryFolder folder;
    const std::string bytes("a\0b\n", 4);

    writeFileAtomically(folder / "file", bytes);

    EXPECT_EQ(readBytes(folder / "file"), bytes);
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFile, ReplacesALongerFile)
{
    const TemporaryFolder folder;

    writeFileAtomically(folder / "file", std::string(10000, 'x'));
    writeFileAtomically(folder / "file", "short");

    EXPECT_EQ(readBytes(folder / "file"), "short");
}

TEST(AtomicFile, WritesAnEmptyFile)
{
    const TemporaryFolder folder;

    writeFileAtomically(folder / "file", "");

    EXPECT_EQ(std::filesystem::file_size(folder / "file"), 0U);
}

TEST(AtomicFile, CreatesTheFolders)
{
    const TemporaryFolder folder;

    writeFileAtomically(folder / "a/b/c", "text");

    EXPECT_EQ(readBytes(folder / "a/b/c"), "text");
}

TEST(AtomicFile, ReplacesALinkInsteadOfWritingThroughIt)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "elsewhere", "kept");
    std::filesystem::create_symlink(folder / "elsewhere", folder / "file");

    writeFileAtomically(folder / "file", "new");

    EXPECT_EQ(readBytes(folder / "elsewhere"), "kept");
    EXPECT_FALSE(std::filesystem::is_symlink(folder / "file"));
}

TEST(AtomicFile, LeavesTheOldContentWhenTheDiskIsFull)
{
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old");
    const std::string large(1 << 20, 'x');

    try {
        const FileSizeLimit limit(4096);
        writeFileAtomically(folder / "file", large);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::fileIo);
        EXPECT_NE(std::string(error.what()).find("file"), std::string::npos);
    }

    EXPECT_EQ(readBytes(folder / "file"), "old");
    EXPECT_EQ(entries(folder.path()), 1U) << "the temporary file is still there";
}

TEST(AtomicFile, RefusesToReplaceAFolderAndCleansUp)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "file");

    EXPECT_THROW(writeFileAtomically(folder / "file", "text"), Error);

    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFile, RefusesAFolderThatIsAFile)
{
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "text");

    EXPECT_THROW(writeFileAtomically(folder / "file/inside", "text"), Error);
}

TEST(AtomicFile, IsRenewedWithoutALeftover)
{
    const TemporaryFolder folder;
    renewFile(folder / "status", "one");
    renewFile(folder / "status", "two");

    EXPECT_EQ(readBytes(folder / "status"), "two");
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFile, TemporariesOfKilledWritersAreRemoved)
{
    const TemporaryFolder folder;
    const std::string dead = "2147483646", alive = std::to_string(::getppid());
    const std::vector<std::string> names{".a.vtkhdf." + dead + ".tmp",
                                         ".b.svg." + alive + ".tmp",
                                         "notes." + dead + ".tmp",
                                         "." + dead + ".tmp",
                                         ".notes.tmp",
                                         ".x.12a.tmp"};
    for (const std::string& name : names) writeBytes(folder / name, "x");
    std::filesystem::create_directory(folder / (".folder." + dead + ".tmp"));

    EXPECT_EQ(removeTemporaries(folder.path(), true), 1);
    EXPECT_FALSE(std::filesystem::exists(folder / (".a.vtkhdf." + dead + ".tmp")));
    EXPECT_EQ(removeTemporaries(folder.path(), false), 1);
    EXPECT_EQ(entries(folder.path()), 5U);
    EXPECT_EQ(removeTemporaries(folder / "none", false), 0);
}
