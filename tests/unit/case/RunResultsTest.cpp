#include "case/RunResults.h"

#include "base/Error.h"
#include "case/RunRecord.h"
#include "unit/case/RunFiles.h"

#include <gtest/gtest.h>

namespace fpm {

namespace {

std::vector<std::string> timesOf(const RunResults& results)
{
    std::vector<std::string> names;
    for (const FrameTime& frame : results.frames()) names.push_back(frame.first);
    return names;
}

std::string reportOf(const RunResults& results)
{
    std::string text;
    Log log = Log::into(text);
    results.report(log);
    return text;
}

} // namespace

TEST(RunResults, AreThoseOfTheRunInStatus)
{
    const TemporaryCase folder;
    const RunFiles old(folder, "20260131-120000-00000001"),
        mine(folder, "20260131-120001-00000002");
    mine.mesh("0123456789abcdef");
    for (const char* time : {"0.1", "0.3", "0.5"}) old.frame(time);
    for (const char* time : {"0", "0.2", "0.4"}) mine.frame(time);
    mine.status(RunState::finished);

    const RunResults results(folder.root());

    EXPECT_EQ(results.runId(), "20260131-120001-00000002");
    EXPECT_EQ(timesOf(results), (std::vector<std::string>{"0", "0.2", "0.4"}));
    EXPECT_EQ(reportOf(results), "run 20260131-120001-00000002 finished at time 0\n"
                                 "warning: left out: 3 frames of other runs, at times 0.1, 0.3, "
                                 "0.5\n");
}

TEST(RunResults, LeaveOutFramesOfAnotherMesh)
{
    const TemporaryCase folder;
    const RunFiles mine(folder, "20260131-120001-00000002");
    mine.mesh("0123456789abcdef");
    for (const char* time : {"0", "1", "2", "3", "4", "5", "6"}) mine.frame(time);
    mine.mesh("fedcba9876543210");
    mine.status(RunState::finished);

    const RunResults results(folder.root());

    EXPECT_TRUE(results.frames().empty());
    EXPECT_NE(reportOf(results).find(
                  "warning: left out: 7 frames of another mesh than constant/mesh.vtkhdf, at times "
                  "0, 1, 2, 3, 4, ...; run fpmExplicit with this mesh\n"),
              std::string::npos)
        << reportOf(results);
}

TEST(RunResults, OfTheLatestRunAreTakenWithoutAStatus)
{
    const TemporaryCase folder;
    RunFiles(folder, "20260131-120000-00000001").frame("0.1");
    RunFiles(folder, "20260131-120001-00000002").frame("0.2");

    const RunResults results(folder.root());

    EXPECT_EQ(timesOf(results), std::vector<std::string>{"0.2"});
    EXPECT_NE(reportOf(results).find("there is no file status"), std::string::npos);
}

TEST(RunResults, WarnOfARunThatDidNotFinish)
{
    const TemporaryCase folder;
    const RunFiles mine(folder, "one");
    mine.frame("0");
    folder.write("why.txt", "the energy is not a number\n");
    mine.status(RunState::failed);
    EXPECT_EQ(reportOf(RunResults(folder.root())),
              "warning: run one failed at time 0: the energy is not a number; its results end "
              "there\n");
    mine.status(RunState::running);
    EXPECT_EQ(reportOf(RunResults(folder.root())).substr(0, 34),
              "warning: run one died after time 0");
}

TEST(RunResults, NameAFrameThatIsCutShort)
{
    const TemporaryCase folder;
    const RunFiles mine(folder, "one");
    mine.frame("0");
    mine.frame("1");
    const auto file = folder.root() / "1/fields.vtkhdf";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);

    EXPECT_THROW(RunResults(folder.root()), Error);
}

TEST(RunResults, TablesNameTheirRun)
{
    const Table table{{"time"}, {}, {"units: s", "fpm run one postProcessing/a/0/b.dat"}};

    EXPECT_EQ(otherRunOf(table, "one"), "");
    EXPECT_EQ(otherRunOf(table, "two"), "one");
    EXPECT_EQ(otherRunOf(table, ""), "");
    EXPECT_EQ(otherRunOf({{"time"}, {}}, "two"), "");
}

TEST(RunRecord, KeepsTheStatusOfItsRun)
{
    const TemporaryCase folder;
    folder.write("system/controlDict", "endTime 1;\n");
    RunFiles(folder, "old").frame("0.5");
    std::string text;
    Log log = Log::into(text);

    RunRecord record(OutputFolder(folder.root()), "keep", log);

    const std::string id = record.id();
    EXPECT_EQ(text,
              "moved into previous/ what an earlier run left: 1 frames, 0 tables, 0 pictures\n"
              "run "
                  + id + "\n");
    EXPECT_EQ(readStatus(folder.root())->runId, id);
    EXPECT_EQ(readStatus(folder.root())->state, RunState::died) << "this test holds no lock";
    record.renew(0.25, 7, log);
    EXPECT_EQ(readStatus(folder.root())->steps, 7);
    record.end(RunState::finished, 0.5, 9);
    EXPECT_EQ(describe(*readStatus(folder.root()), folder.root()),
              "run " + id + " finished at time 0.5");
    record.end(RunState::failed, 0.5, 9, "0.5/a \"frame\"");
    EXPECT_EQ(describe(*readStatus(folder.root()), folder.root()),
              "run " + id + " failed at time 0.5: it could not write 0.5/a ?frame?");
}

} // namespace fpm
