#include "base/Version.h"

#include <gtest/gtest.h>

#include <regex>

namespace fpm {

TEST(Version, HasThreeNumbersAndARevision)
{
    const std::regex form("\\d+\\.\\d+\\.\\d+( \\([0-9a-f]{7,40}(-dirty)?\\))?");
    EXPECT_TRUE(std::regex_match(versionText(), form)) << versionText();
}

TEST(Version, ProgramsThatDifferInTheirRevisionAloneAreEqualWithoutIt)
{
    const auto program = [](std::string revision, const std::string& code) {
        revision.resize(50);
        return "begin" + std::string("fpm revision: ") + revision + code;
    };
    const std::string first = program("1a2b3c4", "code");
    EXPECT_EQ(withoutRevision(first), withoutRevision(program("1a2b3c4-dirty", "code")));
    EXPECT_EQ(withoutRevision(first).size(), first.size());
    EXPECT_NE(withoutRevision(first), withoutRevision(program("1a2b3c4", "Code")));
    EXPECT_EQ(withoutRevision("cut short, fpm revision: 1a"),
              withoutRevision("cut short, fpm revision: 2b"));
}

} // namespace fpm
