#include "case/Case.h"

#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>

#include <functional>

namespace fpm {

namespace {

namespace fs = std::filesystem;

ExitCode codeOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const Error& error) {
        return error.code();
    }
    return ExitCode::success;
}

} // namespace

TEST(Case, IsAFolderWithAControlOrMeshDictionary)
{
    const TemporaryCase folder;
    EXPECT_EQ(codeOf([&] { Case(folder.root()); }), ExitCode::commandLine);

    folder.write("system/meshDict", "");
    EXPECT_EQ(codeOf([&] { Case(folder.root()); }), ExitCode::success);
    EXPECT_EQ(codeOf([&] { Case(folder.root() / "nowhere"); }), ExitCode::commandLine);
    EXPECT_EQ(codeOf([&] { Case(folder.root() / "system/meshDict"); }), ExitCode::commandLine);
}

TEST(Case, ReadsItsDictionaries)
{
    const TemporaryCase folder;
    folder.write("system/controlDict", "endTime 2;");

    const Case theCase(folder.root());

    EXPECT_EQ(theCase.dictionary("system/controlDict").number("endTime"), 2);
    EXPECT_EQ(theCase.dictionary("system/controlDict").name(), "system/controlDict");
    EXPECT_EQ(codeOf([&] { theCase.dictionary("system/meshDict"); }), ExitCode::dictionary);
    EXPECT_TRUE(theCase.hasFile("system"));
    EXPECT_FALSE(theCase.hasFile("constant"));
}

TEST(Case, IsTheSameThroughALink)
{
    const TemporaryCase folder;
    folder.write("real/system/controlDict", "");
    fs::create_directory_symlink("real", folder.root() / "link");

    EXPECT_EQ(Case(folder.root() / "link").root(), fs::canonical(folder.root() / "real"));
}

TEST(Case, KeepsPathsInside)
{
    const TemporaryCase folder;
    folder.write("system/controlDict", "");
    folder.write("constant/part.msh", "");
    const Case theCase(folder.root());
    const auto& root = theCase.root();

    EXPECT_EQ(theCase.inside("constant/part.msh"), root / "constant/part.msh");
    EXPECT_EQ(theCase.inside("new/folder/file"), root / "new/folder/file");
    for (const auto* path : {"", "/etc/passwd", "../other", "constant/../../other", "constant/.."})
        EXPECT_EQ(codeOf([&] { theCase.inside(path); }), ExitCode::fileIo) << path;
}

TEST(Case, RefusesLinksThatLeadOut)
{
    const TemporaryCase folder;
    folder.write("case/system/controlDict", "");
    folder.write("outside", "");
    const auto root = folder.root() / "case";
    fs::create_symlink("../outside", root / "file");
    fs::create_directory_symlink("..", root / "folder");
    fs::create_symlink("../notThere", root / "dangling");
    fs::create_symlink("system/controlDict", root / "inner");
    const Case theCase(root);

    for (const auto* path : {"file", "folder/outside", "folder", "dangling"})
        EXPECT_EQ(codeOf([&] { theCase.inside(path); }), ExitCode::fileIo) << path;
    EXPECT_EQ(codeOf([&] { theCase.inside("inner"); }), ExitCode::success);
}

} // namespace fpm
