#include "base/Error.h"

#include <gtest/gtest.h>

namespace fpm {

TEST(Error, CarriesMessageCodeAndAdvice)
{
    const Error error(ExitCode::mesh, "body 'rod' has no elements", "raise 'axial'");

    EXPECT_STREQ(error.what(), "body 'rod' has no elements");
    EXPECT_EQ(error.code(), ExitCode::mesh);
    EXPECT_EQ(error.advice(), "raise 'axial'");
}

TEST(Error, KeepsThePublishedExitCodes)
{
    EXPECT_EQ(int(ExitCode::commandLine), 2);
    EXPECT_EQ(int(ExitCode::dictionary), 3);
    EXPECT_EQ(int(ExitCode::fileIo), 6);
    EXPECT_EQ(int(ExitCode::caseLocked), 7);
    EXPECT_EQ(int(ExitCode::memory), 12);
    EXPECT_EQ(int(ExitCode::internal), 70);
    EXPECT_EQ(int(ExitCode::stopped), 75);
}

} // namespace fpm
