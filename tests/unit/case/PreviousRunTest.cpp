#include "case/PreviousRun.h"

#include "base/Error.h"
#include "base/Format.h"
#include "unit/case/RunFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace fpm {

namespace {

namespace fs = std::filesystem;

/// Every file below a folder but hidden ones at its top, relative to it.
std::set<std::string> filesIn(const fs::path& root)
{
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (entry.is_symlink() || !entry.is_directory())
            names.insert(entry.path().lexically_relative(root).string());
    return names;
}

const std::set<std::string> resultsOfRun{"0/fields.vtkhdf",
                                         "5e-05/fields.vtkhdf",
                                         "case.hdf.series",
                                         "case.vtkhdf.series",
                                         "checkpoint/state.1.h5",
                                         "checkpoint/state.h5",
                                         "later/7e-05/fields.vtkhdf",
                                         "later/why.txt",
                                         "postProcessing/end/0/U.dat",
                                         "postProcessing/performance/0/performance",
                                         "postProcessing/performance/0/performance.json",
                                         "postProcessing/pictures/mises_0.svg",
                                         "postProcessing/plots/tip.svg",
                                         "postProcessing/tip/0/displacement.dat",
                                         "status"};

/// A case with a finished run and what a person wrote.
class PreviousRun : public testing::Test
{
protected:
    PreviousRun()
        : first(folder, "20260131-120000-00000001"),
          second(folder, "20260131-120001-00000002")
    {
        for (const std::string& file : own) folder.write(file, "of a person");
        first.mesh("0123456789abcdef");
        first.all({"0", "5e-05"});
    }

    std::string clear(const std::string& mode = "keep")
    {
        std::string text;
        Log log = Log::into(text);
        clearForRun(OutputFolder(folder.root()), mode, log);
        return text;
    }
    std::string refusal(const std::string& mode = "keep")
    {
        try {
            clear(mode);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::fileIo);
            return error.what();
        }
        return "no error";
    }
    std::set<std::string> ownAnd(std::set<std::string> more) const
    {
        more.insert(own.begin(), own.end());
        more.insert("constant/mesh.vtkhdf");
        return more;
    }
    std::set<std::string> previous() const
    {
        auto files = filesIn(folder.root() / "previous");
        EXPECT_EQ(files.erase(".fpmPrevious"), 1U);
        return files;
    }
    std::set<std::string> outsidePrevious() const
    {
        auto files = filesIn(folder.root());
        std::erase_if(files, [](const std::string& file) { return file.starts_with("previous/"); });
        return files;
    }

    const std::set<std::string> own{"0/initialConditions",
                                    "0.5/notes.txt",
                                    "5e-05/mine.dat",
                                    "postProcessing/mine.csv",
                                    "postProcessing/chart/c/runs.dat",
                                    "system/controlDict"};
    TemporaryCase folder;
    RunFiles first, second;
};

std::set<std::string> with(std::set<std::string> files, const std::string& file)
{
    files.insert(file);
    return files;
}

} // namespace

TEST_F(PreviousRun, IsMovedAsideWithItsMeshAndLeavesWhatAPersonWrote)
{
    const std::string said = clear();

    EXPECT_EQ(said, "moved into previous/ what run 20260131-120000-00000001 left: 3 frames, 2 "
                    "tables, 2 pictures\n");
    EXPECT_EQ(outsidePrevious(), ownAnd({}));
    EXPECT_EQ(previous(), with(resultsOfRun, "constant/mesh.vtkhdf"));
    EXPECT_EQ(listFrames(folder.root() / "previous").size(), 2U);
}

TEST_F(PreviousRun, NothingIsSaidWhereThereIsNone)
{
    clear();

    EXPECT_EQ(clear(), "");
    EXPECT_EQ(clear("remove"), "");
    EXPECT_EQ(clear("refuse"), "");
    EXPECT_EQ(previous(), with(resultsOfRun, "constant/mesh.vtkhdf"));
}

TEST_F(PreviousRun, IsReplacedByTheNextOne)
{
    clear();
    folder.write("previous/notes.txt", "of a person");
    second.frame("0.25");
    second.status(RunState::failed);
    folder.write("why.txt", "unstable");

    clear();

    EXPECT_EQ(previous(), (std::set<std::string>{"0.25/fields.vtkhdf", "constant/mesh.vtkhdf",
                                                 "notes.txt", "status", "why.txt"}));
    EXPECT_EQ(listFrames(folder.root() / "previous").at(0).runId, "20260131-120001-00000002");
    EXPECT_EQ(outsidePrevious(), ownAnd({}));
}

TEST_F(PreviousRun, IsNotReplacedByARunThatOnlyStarted)
{
    clear();
    const auto before = previous();
    second.frame("0");
    second.marked("postProcessing/tip/0/displacement.dat");
    folder.write("status", "state running; runId \"two\"; steps 0;\n");

    EXPECT_EQ(clear(), "removed what run two left at its start; previous/ is kept\n");
    EXPECT_EQ(previous(), before);
    EXPECT_EQ(outsidePrevious(), ownAnd({}));
}

TEST_F(PreviousRun, GoesWithItsMeshWhereThereIsAnotherNow)
{
    keepMeshOfFrames(folder.root());
    first.mesh("fedcba9876543210");
    keepMeshOfFrames(folder.root()); // twice meshed again
    folder.write("constant/mesh.vtkhdf", "damaged");
    keepMeshOfFrames(folder.root());

    clear();

    EXPECT_EQ(previous(), with(resultsOfRun, "constant/mesh.vtkhdf"));
    EXPECT_EQ(meshChecksumOf(folder.root() / "previous"), "0123456789abcdef");
    EXPECT_EQ(outsidePrevious(), ownAnd({}));
}

TEST_F(PreviousRun, GoesWithoutTheMeshOfAnother)
{
    first.mesh("fedcba9876543210"); // so that the old one is not kept

    clear();

    EXPECT_EQ(previous(), resultsOfRun);
}

TEST_F(PreviousRun, KilledAfterAnyNumberOfMovesIsCompleted)
{
    const auto files = resultFiles(folder.root());
    ASSERT_EQ(files.size(), resultsOfRun.size());
    EXPECT_EQ(files.front(), "status") << "a run half moved must not look whole";
    for (std::size_t moved = 0; moved <= files.size(); ++moved) {
        const TemporaryCase copy;
        fs::copy(folder.root(), copy.root(), fs::copy_options::recursive);
        copy.write("previous/.fpmPrevious", "state moving;\n");
        for (std::size_t i = 0; i < moved; ++i) {
            const auto target = copy.root() / "previous" / files[i];
            fs::create_directories(target.parent_path());
            fs::rename(copy.root() / files[i], target);
        }
        std::string text;
        Log log = Log::into(text);

        clearForRun(OutputFolder(copy.root()), "keep", log);

        EXPECT_EQ(text, "moved into previous/ what run 20260131-120000-00000001 left: 3 frames, 2 "
                        "tables, 2 pictures\n");
        auto kept = filesIn(copy.root() / "previous");
        kept.erase(".fpmPrevious");
        EXPECT_EQ(kept, with(resultsOfRun, "constant/mesh.vtkhdf")) << moved;
        EXPECT_TRUE(resultFiles(copy.root()).empty()) << moved;
    }
}

TEST_F(PreviousRun, KilledWhileTheOneBeforeIsRemovedIsCompleted)
{
    clear();
    fs::remove(folder.root() / "previous/status");
    second.all({"0"});

    clear();

    EXPECT_EQ(listFrames(folder.root() / "previous").size(), 1U);
    EXPECT_EQ(listFrames(folder.root() / "previous").at(0).runId, "20260131-120001-00000002");
}

TEST_F(PreviousRun, IsRemovedOrRefusedWhereThatIsWanted)
{
    EXPECT_EQ(refusal("refuse"),
              "the case holds results of run 20260131-120000-00000001: 3 frames, "
              "2 tables, 2 pictures");
    EXPECT_EQ(resultFiles(folder.root()).size(), resultsOfRun.size());

    EXPECT_EQ(clear("remove"),
              "removed what run 20260131-120000-00000001 left: 3 frames, 2 tables, 2 pictures\n");
    EXPECT_EQ(outsidePrevious(), ownAnd({}));
    EXPECT_FALSE(folder.has("previous"));
}

TEST_F(PreviousRun, OfAPersonIsNeverUsed)
{
    folder.write("previous/notes.txt", "of a person");

    const std::string path = (folder.root() / "previous").string();
    EXPECT_EQ(refusal(), format("'{}' was not made by fpmExplicit", path));
    EXPECT_EQ(filesIn(folder.root() / "previous"), std::set<std::string>{"notes.txt"});
    EXPECT_EQ(resultFiles(folder.root()).size(), resultsOfRun.size());
    EXPECT_EQ(clear("remove").substr(0, 7), "removed");
    EXPECT_EQ(filesIn(folder.root() / "previous"), std::set<std::string>{"notes.txt"});
}

TEST_F(PreviousRun, CopiesAndLinksOfResultsStay)
{
    fs::copy(folder.root() / "5e-05", folder.root() / "kept");
    fs::copy(folder.root() / "postProcessing/plots", folder.root() / "postProcessing/plotsKept");
    fs::create_directory_symlink("5e-05", folder.root() / "0.75");
    const std::set<std::string> copies{"kept/fields.vtkhdf", "postProcessing/plotsKept/tip.svg",
                                       "0.75"};

    clear();

    auto left = ownAnd(copies);
    left.insert("kept/mine.dat");
    EXPECT_EQ(outsidePrevious(), left);
}

TEST_F(PreviousRun, BehindALinkIsRefusedBeforeAnythingIsMoved)
{
    for (const std::string name : {"postProcessing", "previous"}) {
        const TemporaryCase other;
        other.write("postProcessing/tip/0/displacement.dat", "of another");
        const auto link = folder.root() / name, kept = folder.root() / "kept";
        if (fs::exists(link)) fs::rename(link, kept);
        fs::create_directory_symlink(other.root() / "postProcessing", link);
        for (const std::string mode : {"keep", "remove"})
            EXPECT_EQ(refusal(mode),
                      format("'{}' is a link: nothing is written through it", link.string()));
        fs::remove(link);
        if (fs::exists(kept)) fs::rename(kept, link);

        EXPECT_EQ(other.read("postProcessing/tip/0/displacement.dat"), "of another");
    }
    EXPECT_EQ(outsidePrevious(), with(ownAnd(resultsOfRun), "constant/mesh.vtkhdf"));
}

TEST_F(PreviousRun, TemporariesOfKilledProgramsAreSwept)
{
    const std::string dead = ".2147483646.tmp";
    const std::vector<std::string> left{
        ".status" + dead, "5e-05/.fields.vtkhdf" + dead, "constant/.mesh.vtkhdf" + dead,
        "postProcessing/plots/.tip.svg" + dead, "postProcessing/end/0/.U.dat" + dead};
    const std::vector<std::string> kept{"postProcessing/plots/.tip.svg."
                                            + std::to_string(::getppid()) + ".tmp",
                                        "nested/.status" + dead, "nested/system/controlDict"};
    for (const auto& files : {left, kept})
        for (const std::string& file : files) folder.write(file, "x");

    sweepTemporaries(folder.root());

    for (const std::string& file : left) EXPECT_FALSE(folder.has(file)) << file;
    for (const std::string& file : kept) EXPECT_TRUE(folder.has(file)) << file;
}

} // namespace fpm
