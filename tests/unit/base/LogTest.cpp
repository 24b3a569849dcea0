#include "base/Log.h"

#include "support/logFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace fpm {

namespace {

class LogFile : public testing::Test
{
protected:
    std::filesystem::path file_ = std::filesystem::path(testing::TempDir())
                                  / testing::UnitTest::GetInstance()->current_test_info()->name();

    std::string content() const
    {
        std::ostringstream text;
        text << std::ifstream(file_).rdbuf();
        return text.str();
    }
    ~LogFile() override { std::filesystem::remove(file_); }
};

} // namespace

TEST_F(LogFile, HoldsEveryLineAtOnce)
{
    Log log = test::logInto(file_);

    log.line("Time = 1e-05");
    log.line();
    log.line("End");

    EXPECT_EQ(content(), "Time = 1e-05\n\nEnd\n");
}

TEST_F(LogFile, StartsEmpty)
{
    test::logInto(file_).line("first run");

    test::logInto(file_).line("second run");

    EXPECT_EQ(content(), "second run\n");
}

TEST_F(LogFile, RepeatsAWarningTenTimesThenCounts)
{
    Log log = test::logInto(file_);

    for (int repeat = 0; repeat < 25; ++repeat) log.warning("thin element");
    log.finish();

    const auto text = content();
    std::size_t printed = 0;
    for (auto at = text.find("warning: thin"); at != text.npos;
         at = text.find("warning: thin", at + 1))
        ++printed;
    EXPECT_EQ(printed, 10u);
    EXPECT_NE(text.find("warning (25 times): thin element"), text.npos);
}

TEST_F(LogFile, HoldsProgressAsOrdinaryLines)
{
    Log log = test::logInto(file_);

    log.progress("10 %");
    log.progress("20 %");

    EXPECT_EQ(content(), "10 %\n20 %\n");
}

TEST_F(LogFile, NamesAnError)
{
    Log log = test::logInto(file_);

    log.error("no such part");

    EXPECT_EQ(content(), "error: no such part\n");
}

TEST_F(LogFile, HoldsNoControlCharacters)
{
    Log log = test::logInto(file_);

    log.line("case a\x1B[2Jb");
    log.warning("\xC2\x9B");
    log.progress("1\r2");
    log.error("x\x07\n  = y\tz");

    EXPECT_EQ(content(), "case a?[2Jb\nwarning: ?\n1?2\nerror: x?\n  = y\tz\n");
}

TEST_F(LogFile, GoesOnWhenMoved)
{
    Log first = test::logInto(file_);
    first.line("a");

    Log second = std::move(first);
    second.line("b");

    EXPECT_EQ(content(), "a\nb\n");
}

TEST(Log, SurvivesAFileThatCannotBeOpened)
{
    Log log = test::logInto("/nonexistent/folder/log.fpmMesh");

    EXPECT_NO_THROW(log.line("still here"));
    EXPECT_NO_THROW(log.finish());
}

TEST(Log, SurvivesAFullDisk)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
    Log log = test::logInto("/dev/full");

    EXPECT_NO_THROW(log.line("lost"));
    EXPECT_NO_THROW(log.finish());
}

TEST(Log, QuietWritesNothing)
{
    testing::internal::CaptureStdout();

    Log log = Log::quiet();
    log.line("text");
    log.warning("text");
    log.progress("text");
    log.error("text");
    log.finish();

    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Log, IntoATextWritesNowhereElse)
{
    testing::internal::CaptureStdout();

    std::string text;
    Log log = Log::into(text);
    log.line("first");
    log.warning("second");
    log.finish();

    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(text, "first\nwarning: second\n");
}

TEST(Log, WritesNoEscapeCodesToAPipe)
{
    testing::internal::CaptureStdout();

    Log log;
    log.warning("hot");
    log.progress("50 %");

    EXPECT_EQ(testing::internal::GetCapturedStdout(), "warning: hot\n50 %\n");
}

} // namespace fpm
