#include "io/RunMark.h"

#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

using namespace fpm;
using test::TemporaryFolder;
using test::writeBytes;

TEST(RunMark, IsFoundAgainInEveryKindOfText)
{
    const RunMark mark{"20260131-120000-1a2b3c4d", "postProcessing/end/0/U.dat"};

    for (const std::string& text :
         {"# " + mark.text() + "\n# time ux\n", "<metadata>" + mark.text() + "</metadata>",
          "{ \"origin\": \"" + mark.text() + "\" }", mark.text() + "",
          std::string("tEXtComment\0", 12) + mark.text() + '\0'}) {
        const auto found = findMark(text);
        ASSERT_TRUE(found) << text;
        EXPECT_EQ(found->runId, mark.runId);
        EXPECT_EQ(found->file, mark.file);
    }
}

TEST(RunMark, MayNameNoRun)
{
    const auto found = findMark(RunMark{"", "0/fields.vtkhdf"}.text());

    ASSERT_TRUE(found);
    EXPECT_EQ(found->runId, "");
    EXPECT_EQ(found->file, "0/fields.vtkhdf");
}

TEST(RunMark, IsNotFoundWhereThereIsNone)
{
    for (const char* text :
         {"", "# time ux", "fpm run ", "fpm run id", "fpm run \n", "fpm running a b"})
        EXPECT_FALSE(findMark(text)) << text;
}

TEST(RunMark, IsReadFromTheHeadOfAFileThatIsNoLink)
{
    const TemporaryFolder folder;
    const RunMark mark{"one", "a.dat"};
    writeBytes(folder / "a.dat", "# " + mark.text() + "\n# t\n0\n");
    writeBytes(folder / "late.dat", std::string(2000, '#') + mark.text());
    std::filesystem::create_symlink("a.dat", folder / "link.dat");

    EXPECT_EQ(markOf(folder / "a.dat").value().runId, "one");
    EXPECT_FALSE(markOf(folder / "late.dat"));
    EXPECT_FALSE(markOf(folder / "link.dat"));
    EXPECT_FALSE(markOf(folder / "none.dat"));
    EXPECT_FALSE(markOf(folder.path()));
}
