#include "base/ReadObstacle.h"

#include "support/OrdinaryUser.h"
#include "support/TemporaryFolder.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <cerrno>

namespace fpm {

namespace {

namespace fs = std::filesystem;

std::string answer(const fs::path& path)
{
    const test::OrdinaryUser user;
    const int file = open(path.c_str(), O_RDONLY);
    const int error = file < 0 ? errno : EISDIR;
    if (file >= 0) close(file);
    const ReadObstacle obstacle = readObstacle(path, error);
    return obstacle.reason + " = " + obstacle.advice;
}

} // namespace

TEST(ReadObstacle, NamesWhatIsClosedAndWhose)
{
    const test::TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms(0755));
    fs::create_directories(folder / "open/closed/inner");
    test::writeBytes(folder / "open/file", "x");
    fs::permissions(folder / "open/file", fs::perms::none);
    fs::permissions(folder / "open/closed", fs::perms(0600));

    const std::string file = answer(folder / "open/file");
    const std::string inner = answer(folder / "open/closed/inner/file");
    fs::permissions(folder / "open/closed", fs::perms(0700));

    const std::string path = (folder / "open").string();
    EXPECT_EQ(file.find("permission denied: '" + path + "/file' belongs to "), 0u) << file;
    EXPECT_NE(file.find(", ---------- = "), file.npos) << file;
    EXPECT_EQ(inner.find("permission denied: '" + path + "/closed' belongs to "), 0u) << inner;
    EXPECT_NE(inner.find(", drw------- = "), inner.npos) << inner;
    const bool isOwn = getuid() != 0;
    EXPECT_NE(
        inner.find(isOwn ? "chmod u+rx '" + path + "/closed'" : "ask root to make it readable"),
        inner.npos)
        << inner;
}

TEST(ReadObstacle, SaysWhatElseItIs)
{
    const test::TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms(0755));

    EXPECT_EQ(answer(folder / "none"), "No such file or directory = ");
    EXPECT_EQ(answer(folder.path()), "it is a folder = name a file in it");
}

} // namespace fpm
