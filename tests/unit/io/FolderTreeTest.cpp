#include "io/FolderTree.h"

#include "base/Error.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

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

} // namespace

TEST(FolderTree, IsRemovedWithoutWhatItsLinksLeadTo)
{
    const TemporaryFolder folder;
    fs::create_directories(folder / "outside");
    writeBytes(folder / "outside/file", "kept");
    fs::create_directories(folder / "case/tree/a/b");
    writeBytes(folder / "case/tree/a/b/file", "x");
    writeBytes(folder / "case/other", "x");
    fs::create_directory_symlink("../../../outside", folder / "case/tree/a/link");
    fs::create_symlink("../../outside/file", folder / "case/tree/link");
    fs::create_hard_link(folder / "outside/file", folder / "case/tree/second");
    const OutputFolder output(folder / "case");

    removeTree(output, "tree");
    removeTree(output, "tree");

    EXPECT_EQ(entries(folder / "case"), 1U);
    EXPECT_EQ(readBytes(folder / "outside/file"), "kept");
}

TEST(FolderTree, IsNotRemovedWhereItIsALinkOrOutside)
{
    const TemporaryFolder folder;
    fs::create_directories(folder / "outside/inner");
    fs::create_directories(folder / "case/a");
    fs::create_directory_symlink("../outside", folder / "case/link");
    writeBytes(folder / "case/file", "x");
    const OutputFolder output(folder / "case");

    for (const char* name :
         {"link", "link/inner", "..", "../outside", "a/../../outside", "file", "", ".", "a/."})
        EXPECT_THROW(removeTree(output, name), Error) << name;

    EXPECT_TRUE(fs::exists(folder / "outside/inner"));
    EXPECT_EQ(entries(folder / "case"), 3U);
}

TEST(FolderTree, TemporariesOfKilledWritersAreRemoved)
{
    const TemporaryFolder folder;
    const OutputFolder output(folder.path());
    const std::string dead = "2147483646", alive = std::to_string(::getppid());
    const std::vector<std::string> names{".a.vtkhdf." + dead + ".tmp",
                                         ".b.svg." + alive + ".tmp",
                                         "notes." + dead + ".tmp",
                                         "." + dead + ".tmp",
                                         ".notes.tmp",
                                         ".x.12a.tmp"};
    for (const std::string& name : names) writeBytes(folder / name, "x");
    fs::create_directory(folder / (".folder." + dead + ".tmp"));

    EXPECT_EQ(removeTemporaries(output, "", true), 1);
    EXPECT_FALSE(fs::exists(folder / (".a.vtkhdf." + dead + ".tmp")));
    EXPECT_EQ(removeTemporaries(output, "", false), 1);
    EXPECT_EQ(entries(folder.path()), 5U);
    EXPECT_EQ(removeTemporaries(output, "none", false), 0);
}
