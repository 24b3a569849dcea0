#include "application/Application.h"

#include "base/Format.h"
#include "base/Version.h"
#include "case/CaseLock.h"
#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>

#include <new>
#include <regex>

namespace fpm {

namespace {

namespace fs = std::filesystem;

/// Runs an application on a case of its own and keeps what it printed.
class Application : public testing::Test
{
protected:
    Application() { folder_.write("system/controlDict", "endTime 1;"); }

    int run(
        std::vector<std::string> arguments,
        const std::function<void(fpm::Run&)>& body = [](fpm::Run&) {})
    {
        arguments.insert(arguments.begin(), {"fpmTest", "-case", folder_.root().string()});
        std::vector<char*> argv;
        for (auto& argument : arguments) argv.push_back(argument.data());
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = runApplication(info_, int(argv.size()), argv.data(), body);
        output_ = testing::internal::GetCapturedStdout();
        errors_ = testing::internal::GetCapturedStderr();
        return code;
    }

    TemporaryCase folder_;
    ApplicationInfo info_{"fpmTest",
                          "Does nothing, for tests.",
                          "system/controlDict",
                          {{"threads", "<n>", "Threads"}},
                          true};
    std::string output_, errors_;
};

bool holds(const std::string& text, const std::string& part)
{
    return text.find(part) != text.npos;
}

} // namespace

TEST_F(Application, LogsBannerWorkTimesAndEnd)
{
    EXPECT_EQ(run({"-threads", "4"}, [](fpm::Run& run) { run.log.line("work"); }), 0);

    const auto text = folder_.read("log.fpmTest");
    EXPECT_EQ(text, output_);
    const std::regex form("Build  : .*\nExec   : fpmTest -case .* -threads 4\n"
                          "Date   : \\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ\n"
                          "Host   : .+\nPID    : \\d+\nCase   : /.+\n\nwork\n"
                          "ExecutionTime = [0-9.]+ s  ClockTime = \\d+ s\n\nEnd\n");
    EXPECT_TRUE(std::regex_match(text, form)) << text;
    EXPECT_EQ(errors_, "");
}

TEST_F(Application, KeepsThePreviousLog)
{
    run({}, [](fpm::Run& run) { run.log.line("first"); });
    run({}, [](fpm::Run& run) { run.log.line("second"); });

    EXPECT_TRUE(holds(folder_.read("log.fpmTest.1"), "first"));
    EXPECT_TRUE(holds(folder_.read("log.fpmTest"), "second"));
}

TEST_F(Application, WritesNoLogWhenAskedNotTo)
{
    EXPECT_EQ(run({"-noLog"}), 0);

    EXPECT_FALSE(folder_.has("log.fpmTest"));
}

TEST_F(Application, DoesNotLogThroughALink)
{
    folder_.write("victim", "precious");
    fs::create_symlink("victim", folder_.root() / "log.fpmTest");
    fs::create_directories(folder_.root() / "log.fpmTest.1");

    EXPECT_EQ(run({}), 0);

    EXPECT_EQ(folder_.read("victim"), "precious");
}

TEST_F(Application, GivesTheWorkItsOptionsAndDictionary)
{
    const auto body = [](fpm::Run& run) {
        EXPECT_EQ(run.integer("threads", 1, 8), 4);
        EXPECT_EQ(run.value("threads"), "4");
        EXPECT_FALSE(run.has("noLog"));
        EXPECT_EQ(run.integer("absent", 1, 8), std::nullopt);
        EXPECT_EQ(run.dictionary().number("endTime"), 1);
        EXPECT_THROW(run.integer("threads", 5, 8), Error);
    };

    EXPECT_EQ(run({"-threads", "4"}, body), 0);
}

TEST_F(Application, ReadsAnotherDictionary)
{
    folder_.write("system/other", "endTime 2;");
    const TemporaryCase outside;
    outside.write("far", "endTime 3;\n#include \"near\"\n");
    outside.write("near", "deltaT 1;");
    const auto endTime = [](double expected) {
        return [=](fpm::Run& run) { EXPECT_EQ(run.dictionary().number("endTime"), expected); };
    };

    EXPECT_EQ(run({"-dict", "system/other"}, endTime(2)), 0);
    EXPECT_EQ(run({"-dict", (outside.root() / "far").string()}, endTime(3)), 0);
    EXPECT_EQ(run({"-dict", "system/nowhere"}, endTime(0)), 3);
}

TEST_F(Application, AnswersErrorsWithTheirCode)
{
    EXPECT_EQ(run({}, [](fpm::Run&) { throw Error(ExitCode::mesh, "no cells", "raise cells"); }),
              4);
    EXPECT_EQ(errors_, "error: no cells\n  = raise cells\n");
    EXPECT_TRUE(folder_.read("log.fpmTest").ends_with(errors_));
    EXPECT_FALSE(holds(output_, "End"));

    EXPECT_EQ(run({}, [](fpm::Run& run) { run.dictionary().requireAllUsed(); }), 3);
    EXPECT_TRUE(
        errors_.starts_with("error: unknown keyword 'endTime'\n  --> system/controlDict:1:1"));
}

TEST_F(Application, AnswersEveryExceptionWithACode)
{
    EXPECT_EQ(run({}, [](fpm::Run&) { throw std::bad_alloc(); }), 12);
    EXPECT_EQ(run({}, [](fpm::Run&) { throw std::logic_error("index 7"); }), 70);
    EXPECT_TRUE(holds(errors_, "internal error: index 7"));
    EXPECT_EQ(run({}, [](fpm::Run&) { throw 1; }), 70);
    EXPECT_EQ(run({}, [](fpm::Run&) { fs::create_directory("/proc/x"); }), 6);
}

TEST_F(Application, TakesAStopForNoError)
{
    EXPECT_EQ(run({}, [](fpm::Run&) { throw Error(ExitCode::stopped, "stopped at 1e-05"); }), 75);

    EXPECT_EQ(errors_, "");
    EXPECT_TRUE(holds(output_, "stopped at 1e-05"));
}

TEST_F(Application, RefusesALockedCaseBeforeItTouchesTheLog)
{
    folder_.write("log.fpmTest", "of the run at work");
    const CaseLock lock(folder_.root(), "fpmExplicit");

    EXPECT_EQ(run({}), 7);

    EXPECT_TRUE(holds(errors_, "in use by fpmExplicit, process"));
    EXPECT_EQ(folder_.read("log.fpmTest"), "of the run at work");
    EXPECT_FALSE(folder_.has("log.fpmTest.1"));
}

TEST_F(Application, ReadsALockedCaseWhereItDoesNotWrite)
{
    const CaseLock lock(folder_.root(), "fpmExplicit");
    info_.locksCase = false;

    EXPECT_EQ(run({}), 0);
}

TEST_F(Application, RefusesAFolderThatIsNoCase)
{
    fs::remove_all(folder_.root() / "system");

    EXPECT_EQ(run({}), 2);
    EXPECT_TRUE(holds(errors_, "is not a case\n  = a case has system/controlDict"));
    EXPECT_FALSE(folder_.has(".lock"));
}

TEST_F(Application, AnswersQuestionsWithoutACase)
{
    fs::remove_all(folder_.root() / "system");

    EXPECT_EQ(run({"-help"}), 0);
    EXPECT_TRUE(holds(output_, "Usage: fpmTest [options]"));
    EXPECT_EQ(run({"-version"}), 0);
    EXPECT_EQ(output_, "fpmTest " + versionText() + "\n");
    EXPECT_FALSE(folder_.has("log.fpmTest"));
}

TEST_F(Application, AnswersAWrongOption)
{
    EXPECT_EQ(run({"-thread", "4"}), 2);
    EXPECT_EQ(errors_, "error: unknown option -thread\n  = did you mean -threads?\n");
}

TEST_F(Application, ListsTheKeysOfItsDictionary)
{
    if (!fs::exists(etcFolder() / "caseDicts/controlDict"))
        GTEST_SKIP() << "no annotated controlDict";

    EXPECT_EQ(run({"-listKeys"}), 0);
    EXPECT_TRUE(holds(output_, "endTime\n")) << output_;
}

TEST_F(Application, WritesTheAnnotatedDictionaryOnceOnly)
{
    const auto source = etcFolder() / "caseDicts/controlDict";
    if (!fs::exists(source)) GTEST_SKIP() << "no annotated controlDict";
    fs::remove_all(folder_.root() / "system");

    EXPECT_EQ(run({"-writeDefaults"}), 0);
    EXPECT_EQ(fs::file_size(folder_.root() / "system/controlDict"), fs::file_size(source));
    EXPECT_EQ(run({"-writeDefaults"}), 3);
    EXPECT_TRUE(holds(errors_, "exists already\n  = rename or delete it first"));
}

TEST_F(Application, WritesTheDefaultsOfTheDictionaryNamed)
{
    EXPECT_EQ(run({"-dict", "constant/partProperties", "-writeDefaults"}), 0);
    EXPECT_EQ(fs::file_size(folder_.root() / "constant/partProperties"),
              fs::file_size(etcFolder() / "caseDicts/partProperties"));
    EXPECT_EQ(run({"-dict", "system/other", "-writeDefaults"}), 0);
    EXPECT_EQ(fs::file_size(folder_.root() / "system/other"),
              fs::file_size(etcFolder() / "caseDicts/controlDict"));
}

TEST_F(Application, DoesNotWriteDefaultsThroughALink)
{
    if (!fs::exists(etcFolder() / "caseDicts/controlDict"))
        GTEST_SKIP() << "no annotated controlDict";
    const TemporaryCase outside;
    fs::remove_all(folder_.root() / "system");
    fs::create_directory_symlink(outside.root(), folder_.root() / "system");

    EXPECT_EQ(run({"-writeDefaults"}), 6);
    EXPECT_FALSE(outside.has("controlDict"));
}

} // namespace fpm
