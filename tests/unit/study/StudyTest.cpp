#include "study/Study.h"

#include "case/CheckpointLabel.h"
#include "io/Hdf5File.h"
#include "unit/case/TemporaryCase.h"
#include "unit/study/fakePrograms.h"

#include <gtest/gtest.h>

#include <csignal>

using namespace fpm;
namespace fs = std::filesystem;

namespace {

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
    return found;
}

class StudyTest : public testing::Test
{
protected:
    StudyTest()
    {
        folder_.write("system/controlDict", "n 1;\nfunctions { tip { type point; } }\n");
        folder_.write("system/meshDict", "bodies { a { type box; cells (1 1 1); } }\n");
        folder_.write("constant/partProperties", "parts { a { density 1; } }\n");
        folder_.write("0.5/fields.vtkhdf", "result");
        folder_.write("log.fpmMesh", "result");
        folder_.write("postProcessing/tip/0/displacement.dat", "result");
    }
    Study study(const std::vector<std::string>& values, const StudySettings& settings = {}) const
    {
        std::vector<StudyRun> runs;
        for (const auto& value : values)
            runs.push_back({"n_" + value, {{"system/controlDict", "n", value, ""}}});
        return Study(case_(), "postProcessing/chart/c", runs, settings, pipeline_);
    }
    Case case_() const { return Case(folder_.root()); }
    std::string explicitCalls() const
    {
        return std::to_string(count(programs_.calls(), "fpmExplicit"));
    }
    void run(Study& study) const
    {
        Log log = Log::quiet();
        study.run(log);
    }

    TemporaryCase folder_;
    test::FakePrograms programs_;
    Pipeline pipeline_{programs_.path()};
};

} // namespace

TEST_F(StudyTest, RunsEveryVariationInACopyOfItsOwn)
{
    auto three = study({"2", "4"});
    run(three);

    const auto first = folder_.root() / "postProcessing/chart/c/runs/n_2";
    EXPECT_EQ(test::readBytes(first / "system/controlDict").substr(0, 4), "n 2;");
    EXPECT_TRUE(fs::exists(first / "postProcessing/tip/0/displacement.dat"));
    EXPECT_FALSE(fs::exists(first / "0.5"));
    EXPECT_FALSE(fs::exists(first / "1e-3")) << "frames are removed unless asked for";
    EXPECT_EQ(count(programs_.calls(), "fpmMesh"), 2u);
    EXPECT_EQ(count(programs_.calls(), "fpmSetContact"), 0u) << "there is no contactDict";
    const auto rows = three.rows(1);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].elements, 64);
    EXPECT_EQ(rows[0].steps, 40);
    EXPECT_EQ(rows[0].nsPerElementStep, 12.5);
    EXPECT_GT(rows[0].wall, 0);
    EXPECT_GT(rows[0].memory, 0);
    EXPECT_EQ(folder_.read("system/controlDict").substr(0, 4), "n 1;") << "the case is not touched";
}

TEST_F(StudyTest, RunsNothingTwice)
{
    auto before = study({"2", "4"});
    run(before);
    programs_.forgetCalls();

    auto after = study({"2", "3", "4"});
    EXPECT_EQ(after.toDo(), 1u);
    run(after);

    EXPECT_EQ(explicitCalls(), "1");
    EXPECT_EQ(after.rows(0)[0].wall, before.rows(0)[0].wall) << "the row of the earlier start";
}

TEST_F(StudyTest, RepeatsWhatHasChangedAndNotWhatSaysTheSame)
{
    auto before = study({"2", "4"});
    run(before);

    folder_.write("constant/partProperties", "parts // the same\n{ a { density   1; } }\n");
    folder_.write("README.md", "new");
    EXPECT_EQ(study({"2", "4"}).toDo(), 0u);

    folder_.write("constant/partProperties", "parts { a { density 2; } }\n");
    EXPECT_EQ(study({"2", "4"}).toDo(), 2u);

    folder_.write("constant/partProperties", "parts { a { density 1; } }\n");
    EXPECT_EQ(study({"2", "4"}).toDo(), 0u) << "back again";

    programs_.write("fpmMesh", "#!/bin/sh\n# another build\n");
    const Pipeline other(programs_.path());
    EXPECT_NE(other.key(), pipeline_.key());

    const std::string head = "#!/bin/sh\n# fpm revision: ", rest(43, '.');
    programs_.write("fpmMesh", head + "1a2b3c4" + rest + "\n");
    const std::string commit = Pipeline(programs_.path()).key();
    programs_.write("fpmMesh", head + "5d6e7f8" + rest + "\n");
    EXPECT_EQ(Pipeline(programs_.path()).key(), commit) << "another commit of the same program";
}

TEST_F(StudyTest, ForgetsTheRunWhoseFolderIsUsedAgain)
{
    auto before = study({"2"});
    run(before);
    folder_.write("constant/partProperties", "parts { a { density 2; } }\n");
    auto changed = study({"2"});
    run(changed);

    folder_.write("constant/partProperties", "parts { a { density 1; } }\n");
    EXPECT_EQ(study({"2"}).toDo(), 1u) << "its results were overwritten";
}

TEST_F(StudyTest, TakesAFailingRunForAResult)
{
    auto failing = study({"2", "110", "4"}, {.repeats = 2});
    run(failing);

    EXPECT_EQ(failing.rows(1)[0].state, "fpmExplicit:10");
    EXPECT_EQ(causeOf(failing.rows(1)[0].state), "numerical stop (fpmExplicit, status 10)");
    EXPECT_EQ(failing.rows(1).size(), 1u) << "what fails once is not repeated";
    EXPECT_EQ(failing.rows(2).size(), 2u);
    EXPECT_EQ(study({"2", "110", "4"}, {.repeats = 2}).toDo(), 0u);
    EXPECT_EQ(study({"2", "110", "4"}, {.repeats = 2, .retry = true}).toDo(), 2u);
}

TEST_F(StudyTest, InterleavesRepeats)
{
    auto twice = study({"2", "4"}, {.repeats = 2});
    run(twice);

    std::string order;
    const RunTable table(OutputFolder(folder_.root()), "postProcessing/chart/c/runs.dat");
    for (const auto& row : table.rows()) order += row.run + "/" + std::to_string(row.repeat) + " ";
    EXPECT_EQ(order, "n_2/1 n_4/1 n_2/2 n_4/2 ");
}

TEST_F(StudyTest, RunsEqualVariationsOnce)
{
    const std::vector<StudyRun> runs{{"a", {{"system/controlDict", "n", "3", ""}}},
                                     {"b", {{"system/controlDict", "n", "3", ""}}}};
    Study study(case_(), "postProcessing/chart/c", runs, {}, pipeline_);
    run(study);

    EXPECT_EQ(explicitCalls(), "1");
    EXPECT_EQ(study.folder(1), study.folder(0));
    EXPECT_EQ(study.rows(1)[0].elements, 27);
}

TEST_F(StudyTest, LaysTheFilesOfAFolderOverTheCase)
{
    folder_.write("variants/fine/system/controlDict", "n 5;\n");
    const std::vector<StudyRun> runs{{"fine", {{"", "", "", "variants/fine"}}}};
    Study study(case_(), "postProcessing/chart/c", runs, {}, pipeline_);
    run(study);

    EXPECT_EQ(study.rows(0)[0].elements, 125);
}

TEST_F(StudyTest, KeepsFinishedRunsWhenTheDiskIsFullOrSomebodyStopsIt)
{
    for (const std::string code : {"6", "7", "75"}) {
        folder_.write("constant/partProperties", "parts { a { density " + code + "; } }\n");
        auto stopped = study({"2", std::to_string(100 + std::stoi(code)), "4"});
        try {
            run(stopped);
            ADD_FAILURE() << code;
        } catch (const Error& error) {
            EXPECT_EQ(int(error.code()), std::stoi(code));
        }
        EXPECT_EQ(stopped.toDo(), 2u) << code;
    }
}

TEST_F(StudyTest, EndsItsChildWhenInterrupted)
{
    programs_.write("fpmExplicit", "#!/bin/sh\nkill -TERM $PPID\nexec sleep 60\n");
    auto stopped = study({"2", "4"});

    try {
        run(stopped);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::stopped);
    }
    EXPECT_EQ(stopped.toDo(), 2u);
}

TEST_F(StudyTest, RefusesATableItCannotRead)
{
    folder_.write("postProcessing/chart/c/runs.dat", "# run\nn_2 half a line\n");

    try {
        study({"2"});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("runs.dat:2"), std::string::npos) << error.what();
    }
}

TEST_F(StudyTest, RemovesNoFolderOfAPerson)
{
    for (const std::string name : {".trial", "n_2"}) {
        const std::string file = "postProcessing/chart/c/runs/" + name + "/notes";
        folder_.write(file, "kept");
        try {
            auto one = study({"2"});
            run(one);
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::fileIo);
            EXPECT_NE(std::string(error.what()).find(name + "' is in the way"), std::string::npos)
                << error.what();
        }
        EXPECT_EQ(folder_.read(file), "kept");
        EXPECT_FALSE(folder_.has("postProcessing/chart/c/runs/" + name + "/.lock"));
        fs::remove_all(folder_.root() / "postProcessing/chart/c/runs" / name);
    }
}

TEST_F(StudyTest, RefusesAnEntryThatIsADictionaryBeforeAnythingRuns)
{
    const std::vector<StudyRun> runs{{"a", {{"system/controlDict", "functions.tip", "3", ""}}}};
    EXPECT_THROW(Study(case_(), "postProcessing/chart/c", runs, {}, pipeline_), InputError);
    EXPECT_EQ(programs_.calls(), "");
}

TEST_F(StudyTest, EndsARunAtItsTimeLimit)
{
    // n 4 hangs; the others end at once.
    programs_.write("fpmExplicit",
                    "#!/bin/sh\necho \"fpmExplicit\" >> \"$(dirname \"$0\")/called\"\n"
                    "grep -q '^n 4;' system/controlDict && exec sleep 60\n"
                    "mkdir -p postProcessing/tip/0\n");
    auto limited = study({"2", "4", "3"}, {.repeats = 2, .timeLimit = 2});
    run(limited);

    ASSERT_EQ(limited.rows(1).size(), 1u) << "not repeated";
    EXPECT_EQ(limited.rows(1)[0].state, "fpmExplicit:timeLimit2");
    EXPECT_EQ(causeOf(limited.rows(1)[0].state), "time limit of 2 s (fpmExplicit)");
    EXPECT_LT(limited.rows(1)[0].wall, 30) << "killed, not waited for";
    EXPECT_TRUE(limited.rows(2)[0].succeeded());
    EXPECT_EQ(study({"2", "4", "3"}, {.repeats = 2, .timeLimit = 2}).toDo(), 0u);
    EXPECT_EQ(study({"2", "4", "3"}, {.repeats = 2, .timeLimit = 1}).toDo(), 0u);
    EXPECT_EQ(study({"2", "4", "3"}, {.repeats = 2, .timeLimit = 5}).toDo(), 2u) << "more time now";
    EXPECT_EQ(study({"2", "4", "3"}, {.repeats = 2}).toDo(), 2u);
}

namespace {

/// fpmExplicit that is stopped once it has begun, until there is a file `again` beside it, and ends
/// with `code` when it goes on.
std::string stopped(int code)
{
    return R"(#!/bin/sh
echo "${0##*/} $*" >> "$(dirname "$0")/called"
mkdir -p constant
touch constant/mesh.vtkhdf
printf 'state stopped;\nrunId "one";\n' > status
[ "$2" != -continue ] || exit )"
           + std::to_string(code) + R"(
[ -e "$(dirname "$0")/again" ] || exit 75
)";
}

class StoppedStudy : public StudyTest
{
protected:
    /// Stops the run of n_2 at time 0.5, after 1000 seconds.
    void stop(int codeAfterwards)
    {
        folder_.write("system/controlDict",
                      "n 1;\nendTime 1;\nfunctions { tip { type point; } }\n");
        programs_.write("fpmExplicit", stopped(codeAfterwards));
        pipeline_ = Pipeline(programs_.path());
        EXPECT_THROW(start(), Error);
        const OutputFolder copy(folder_.root() / "postProcessing/chart/c/runs/n_2");
        Hdf5Image().save(copy, checkpointFile,
                         CheckpointLabel{"one", 0.5, 7, 1e-6, 1000, 2000}.text());
        programs_.forgetCalls();
    }
    RunRow start()
    {
        auto one = study({"2"}, settings_);
        said_.clear();
        Log log = Log::into(said_);
        one.run(log);
        return one.rows(0).at(0);
    }

    StudySettings settings_;
    std::string said_;
};

} // namespace

TEST_F(StoppedStudy, GoesOnFromItsCheckpoint)
{
    stop(0);
    folder_.write("constant/partProperties", "parts // a remark\n{ a { density 1; } }\n");
    const RunRow row = start();

    EXPECT_EQ(programs_.calls(), "fpmExplicit -noLog -continue\n") << "it has its mesh";
    EXPECT_NE(said_.find("n_2 goes on from its checkpoint at time 0.5\n"), said_.npos) << said_;
    EXPECT_TRUE(row.succeeded());
    EXPECT_GT(row.wall, 1000) << "what it took before is part of it";
    EXPECT_GE(row.cpu, 2000);
}

TEST_F(StoppedStudy, WhatItTookBeforeCountsAtItsTimeLimit)
{
    stop(0);
    settings_.timeLimit = 900;
    EXPECT_EQ(start().state, "fpmExplicit:timeLimit900");
    settings_.timeLimit = 1100;
    EXPECT_TRUE(start().succeeded());
}

TEST_F(StoppedStudy, BeginsAgainWhereItsInputsAreOthersAndSaysSo)
{
    stop(0);
    folder_.write("constant/partProperties", "parts { a { density 2; } }\n");
    EXPECT_THROW(start(), Error) << "stopped once more";
    EXPECT_EQ(programs_.calls(), "fpmMesh -noLog\nfpmExplicit -noLog\n");
    EXPECT_NE(said_.find("n_2 begins again: its dictionaries, mesh or programs are others now\n"),
              said_.npos)
        << said_;
}

TEST_F(StoppedStudy, BeginsAgainWhereItsCheckpointCannotBeUsed)
{
    stop(5);
    test::writeBytes(programs_.path() / "again", "");
    EXPECT_TRUE(start().succeeded());
    EXPECT_EQ(programs_.calls(), "fpmExplicit -noLog -continue\nfpmMesh -noLog\n"
                                 "fpmExplicit -noLog\n");
    EXPECT_NE(said_.find("n_2 begins again: its checkpoints cannot be used\n"), said_.npos)
        << said_;
}

TEST_F(StoppedStudy, BeginsAgainWhereItsCopyCannotBeRead)
{
    stop(0);
    folder_.write("postProcessing/chart/c/runs/n_2/system/controlDict", "n 2;\nendTime soon;\n");
    EXPECT_THROW(start(), Error) << "stopped once more";
    EXPECT_NE(said_.find("n_2 begins again: what is left of it cannot be read: "), said_.npos)
        << said_;
    EXPECT_EQ(programs_.calls(), "fpmMesh -noLog\nfpmExplicit -noLog\n");
}
