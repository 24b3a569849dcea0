#include "io/OutputFolder.h"

#include "base/Error.h"
#include "base/Format.h"
#include "io/FileError.h"
#include "support/FileSizeLimit.h"
#include "support/TemporaryFolder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>

using namespace fpm;
namespace fs = std::filesystem;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

namespace {

std::size_t entries(const fs::path& folder)
{
    using Iterator = fs::directory_iterator;
    return std::size_t(std::distance(Iterator(folder), Iterator()));
}

/// A case, and beside it a folder that must stay as it is.
class OutputFolderTest : public testing::Test
{
protected:
    OutputFolderTest()
    {
        fs::create_directories(outside / "0");
        writeBytes(outside / "0/file", "kept");
        fs::create_directory(root);
    }
    ~OutputFolderTest() override
    {
        EXPECT_EQ(readBytes(outside / "0/file"), "kept");
        EXPECT_EQ(entries(outside), 1U);
        EXPECT_EQ(entries(outside / "0"), 1U);
    }
    /// Message of the refusal.
    template <class Action>
    std::string refusal(const Action& action) const
    {
        try {
            action();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::fileIo);
            return error.what();
        }
        return "no error";
    }
    std::string refusedLink(const std::string& link) const
    {
        return format("'{}' is a link: nothing is written through it", (root / link).string());
    }

    const TemporaryFolder folder;
    const fs::path root = folder / "case", outside = folder / "outside";
};

} // namespace

TEST_F(OutputFolderTest, WritesExactlyTheBytesAndCreatesFolders)
{
    const OutputFolder output(root);
    const std::string bytes("a\0b\n", 4);

    output.write("a/b/file", bytes);
    output.write("a/b/empty", "");

    EXPECT_EQ(readBytes(root / "a/b/file"), bytes);
    EXPECT_EQ(fs::file_size(root / "a/b/empty"), 0U);
    EXPECT_EQ(entries(root / "a/b"), 2U);
}

TEST_F(OutputFolderTest, ReplacesALongerFileAndKeepsItsPermissions)
{
    const OutputFolder output(root);
    output.write("file", std::string(10000, 'x'));
    fs::permissions(root / "file", fs::perms(0750));

    output.write("file", "short");
    EXPECT_EQ(readBytes(root / "file"), "short");
    output.renew("file", "again");

    EXPECT_EQ(readBytes(root / "file"), "again");
    EXPECT_EQ(fs::status(root / "file").permissions(), fs::perms(0750));
    EXPECT_EQ(entries(root), 1U);
}

TEST_F(OutputFolderTest, MayItselfBeReachedThroughALink)
{
    fs::create_directory_symlink("case", folder / "alias");

    OutputFolder(folder / "alias").write("0/file", "text");

    EXPECT_EQ(readBytes(root / "0/file"), "text");
}

TEST_F(OutputFolderTest, RefusesPathsThatLeadOut)
{
    const OutputFolder output(root);
    fs::create_directory(root / "a");
    const std::string absolute = (outside / "0/file").string();
    const std::array<std::string, 5> paths{"../outside/0/file", "a/../../outside/0/file", absolute,
                                           "..", std::string("a\0b", 3)};
    for (const std::string& path : paths) {
        EXPECT_NE(refusal([&] { output.write(path, "x"); }), "no error") << path;
        EXPECT_NE(refusal([&] { output.open(path, O_WRONLY | O_CREAT); }), "no error") << path;
        EXPECT_NE(refusal([&] { output.inner(path); }), "no error") << path;
        EXPECT_NE(refusal([&] { output.remove(path); }), "no error") << path;
        EXPECT_NE(refusal([&] { output.rename("a", path); }), "no error") << path;
        EXPECT_NE(refusal([&] { output.rename(path, "b"); }), "no error") << path;
    }
    EXPECT_EQ(refusal([&] { output.write("", "x"); }), "path '' names no file");
}

TEST_F(OutputFolderTest, NamesTheLinkOnTheWayAndWritesNothing)
{
    const OutputFolder output(root);
    fs::create_directories(root / "results");
    for (const fs::path& target : {outside, fs::path("../outside"), fs::path("results")}) {
        fs::create_directory_symlink(target, root / "link");
        writeBytes(root / "own", "mine");
        const auto refused = refusedLink("link");
        EXPECT_EQ(refusal([&] { output.write("link/0/file", "x"); }), refused);
        EXPECT_EQ(refusal([&] { output.renew("link/0/file", "x"); }), refused);
        EXPECT_EQ(refusal([&] { output.copy(root / "own", "link/0/file"); }), refused);
        EXPECT_EQ(refusal([&] { output.open("link/0/file", O_WRONLY); }), refused);
        EXPECT_EQ(refusal([&] { output.inner("link/0/new"); }), refused);
        EXPECT_EQ(refusal([&] { output.rename("own", "link/0/file"); }), refused);
        EXPECT_EQ(refusal([&] { output.rename("link/0/file", "stolen"); }), refused);
        EXPECT_EQ(refusal([&] { output.link("own", "link/0/second"); }), refused);
        EXPECT_EQ(refusal([&] { output.link("link/0/file", "second"); }), refused);
        EXPECT_EQ(refusal([&] { output.remove("link/0/file"); }), refused);
        EXPECT_TRUE(output.remove("link")) << "the link alone";
    }
}

TEST_F(OutputFolderTest, NamesALinkInTheMiddle)
{
    fs::create_directories(root / "a");
    fs::create_directory_symlink(outside, root / "a/link");

    EXPECT_EQ(refusal([&] { OutputFolder(root).write("a/link/0/file", "x"); }),
              refusedLink("a/link"));
}

TEST_F(OutputFolderTest, ReplacesALinkOfThisNameInsteadOfWritingThroughIt)
{
    fs::create_symlink(outside / "0/file", root / "file");

    OutputFolder(root).write("file", "new");

    EXPECT_EQ(readBytes(root / "file"), "new");
    EXPECT_FALSE(fs::is_symlink(root / "file"));
}

TEST_F(OutputFolderTest, OpensNothingButARegularFileOfOneName)
{
    const OutputFolder output(root);
    fs::create_symlink(outside / "0/file", root / "link");
    fs::create_hard_link(outside / "0/file", root / "second");
    fs::create_directory(root / "folder");
    ASSERT_EQ(::mkfifo((root / "pipe").c_str(), 0666), 0);
    const auto open = [&](const char* name) {
        return refusal([&] { output.open(name, O_WRONLY | O_CREAT | O_APPEND); });
    };

    EXPECT_EQ(open("link"), refusedLink("link"));
    EXPECT_NE(open("second").find("has 2 names (hard links)"), std::string::npos);
    EXPECT_NE(open("pipe").find("is neither a file nor a folder"), std::string::npos);
    EXPECT_NE(open("folder").find("Is a directory"), std::string::npos);
    EXPECT_TRUE(output.open("new/file", O_WRONLY | O_CREAT | O_APPEND).isOpen());
    EXPECT_EQ(refusal([&] { output.open("none", O_WRONLY); }),
              "cannot open '" + (root / "none").string() + "': No such file or directory");
}

TEST_F(OutputFolderTest, LeavesTheOldContentWhenTheDiskIsFull)
{
    const OutputFolder output(root);
    output.write("file", "old");
    const std::string large(1 << 20, 'x');

    try {
        const test::FileSizeLimit limit(4096);
        output.write("file", large);
        ADD_FAILURE() << "no error";
    } catch (const FileError& error) {
        EXPECT_EQ(error.code(), ExitCode::fileIo);
        EXPECT_EQ(error.file(), root / "file");
    }

    EXPECT_EQ(readBytes(root / "file"), "old");
    EXPECT_EQ(entries(root), 1U) << "the temporary file is still there";
}

TEST_F(OutputFolderTest, RefusesAFileForAFolderAndAFolderForAFile)
{
    const OutputFolder output(root);
    fs::create_directories(root / "folder");
    output.write("file", "text");

    EXPECT_NE(refusal([&] { output.write("folder", "text"); }).find("cannot replace"),
              std::string::npos);
    EXPECT_NE(refusal([&] { output.write("file/inside", "text"); }).find("Not a directory"),
              std::string::npos);
    EXPECT_EQ(entries(root), 2U);
}

TEST_F(OutputFolderTest, CopiesContentAndPermissionsFromAnywhere)
{
    fs::permissions(outside / "0/file", fs::perms(0755));

    OutputFolder(root).copy(outside / "0/file", "a/copy");

    EXPECT_EQ(readBytes(root / "a/copy"), "kept");
    EXPECT_EQ(fs::status(root / "a/copy").permissions(), fs::perms(0755));
    EXPECT_NE(refusal([&] { OutputFolder(root).copy(outside, "b"); }), "no error");
}

TEST_F(OutputFolderTest, RenamesAndLinksWithinItself)
{
    const OutputFolder output(root);
    output.write("0/file", "text");

    EXPECT_TRUE(output.link("0/file", "a/second"));
    output.rename("0/file", "b/c/file");

    EXPECT_EQ(fs::hard_link_count(root / "b/c/file"), 2U);
    EXPECT_TRUE(fs::equivalent(root / "b/c/file", root / "a/second"));
    EXPECT_FALSE(fs::exists(root / "0/file"));
}

TEST_F(OutputFolderTest, RemovesFilesLinksAndEmptyFolders)
{
    const OutputFolder output(root);
    output.write("a/file", "text");
    fs::create_directory_symlink(outside, root / "link");

    EXPECT_FALSE(output.remove("a"));
    EXPECT_FALSE(output.remove("none"));
    EXPECT_TRUE(output.remove("link"));
    EXPECT_TRUE(output.remove("a/file"));
    EXPECT_TRUE(output.remove("a"));
    EXPECT_EQ(entries(root), 0U);
}

TEST_F(OutputFolderTest, AnInnerOneReachesNoFurther)
{
    const OutputFolder inner = OutputFolder(root).inner("a/b");
    inner.write("file", "text");

    EXPECT_EQ(readBytes(root / "a/b/file"), "text");
    EXPECT_EQ(inner.path("file"), root / "a/b/file");
    EXPECT_NE(refusal([&] { inner.write("../file", "x"); }), "no error");
}
