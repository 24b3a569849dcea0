#include "probe/Probe.h"

#include "case/PreviousRun.h"
#include "io/Table.h"
#include "io/VtkHdf.h"
#include "mesh/MeshFile.h"
#include "support/TemporaryFolder.h"
#include "support/boxMesh.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace fpm;
namespace fs = std::filesystem;

namespace {

/// A case of two cells with frames at 0 and 1e-4.
class ProbeCase : public testing::Test
{
protected:
    void SetUp() override
    {
        for (const char* name : {"system", "constant", "reference"})
            fs::create_directories(folder / name);
        test::writeBytes(folder / "system/controlDict", "endTime 1e-4;\n");
        test::addBox(mesh, "bar", {2, 1, 1}, {0, 0, 0}, {2, 1, 1});
        mesh.patchStarts = {0, 2};
        mesh.sideSets["end"] = {{1, 1}};
        writeMesh(OutputFolder(folder.path()), mesh);
    }

    void addFrame(const std::string& name, double time, const std::string& runId = "")
    {
        Frame frame;
        frame.time = time;
        frame.runId = runId;
        ResultField displacement{"U", 3, {}};
        for (std::size_t node = 0; node < mesh.points.size(); ++node)
            displacement.values.insert(displacement.values.end(), {0, 0, 2e3 * time});
        frame.nodeFields = {displacement};
        frame.elementFields = {{"Mises", 1, {100, 200}}};
        writeFrame(OutputFolder(folder.path()), name, frame, mesh.points.size(),
                   mesh.hexahedra.size());
    }

    std::vector<std::string> run(const std::string& text, const ProbeSelection& selection = {})
    {
        const Case theCase(folder.path());
        said.clear();
        Log log = Log::into(said);
        std::vector<std::string> names;
        for (const auto& file :
             runProbe(theCase, Dictionary::parse(text, "probeDict"), selection, log)) {
            EXPECT_TRUE(fs::is_regular_file(file)) << file;
            names.push_back(fs::relative(file, theCase.root()).string());
        }
        return names;
    }

    std::string failureOf(const std::string& text)
    {
        try {
            run(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }

    void setStatus(const std::string& state, const std::string& runId)
    {
        test::writeBytes(folder / "status",
                         "state " + state + "; runId \"" + runId + "\"; time 1e-4;\n");
    }

    test::TemporaryFolder folder;
    Mesh mesh;
    std::string said; ///< log of the last run
};

const std::string table = "tables { end { type section; set end; field U; } }\n";
const std::string picture = "pictures { mises { field Mises; times (1e-4 7e-4); } }\n";
const std::string plot = "plots { uz { series { a { file \"postProcessing/end/0/U.dat\"; x time; "
                         "y U_z; xScale 1e6; } } } }\n";

} // namespace

TEST_F(ProbeCase, MakesTablesPicturesAndPlotsOfThem)
{
    addFrame("0", 0);
    addFrame("0.0001", 1e-4);

    const auto files = run(plot + picture + table);

    EXPECT_EQ(files, (std::vector<std::string>{"postProcessing/end/0/U.dat",
                                               "postProcessing/pictures/mises_0.0001.svg",
                                               "postProcessing/pictures/mises_0.0001.png",
                                               "postProcessing/plots/uz.svg"}));
    const Table written = readTable(folder / "postProcessing/end/0/U.dat");
    EXPECT_EQ(written.columns, (std::vector<std::string>{"time", "U_x", "U_y", "U_z"}));
    EXPECT_NEAR(written.values("U_z")[1], 0.2, 1e-7);
}

TEST_F(ProbeCase, MakesOnlyTheGroupsAndTimesSelected)
{
    addFrame("0", 0);
    addFrame("0.0001", 1e-4);
    ProbeSelection selection;
    selection.tables = selection.plots = false;
    selection.times.times = {0};

    EXPECT_EQ(run(plot + picture + table, selection),
              (std::vector<std::string>{"postProcessing/pictures/mises_0.svg",
                                        "postProcessing/pictures/mises_0.png"}));
}

TEST_F(ProbeCase, PassesOverWhatHasNoResultsYet)
{
    EXPECT_TRUE(run(picture + table).empty());
}

TEST_F(ProbeCase, ShowsThePartsBeforeThereAreResults)
{
    EXPECT_EQ(run("pictures { mesh { field Part; } }").size(), 2u);
}

TEST_F(ProbeCase, NamesPlotAndFileWhenAFileIsMissingAfterMakingTheOthers)
{
    test::writeBytes(folder / "reference/x.csv", "t,u\n0,1\n1,2\n");
    const std::string plots =
        "plots { bad { series { ref { file \"reference/none.csv\"; x t; y u; } } }"
        "  good { series { ref { file \"reference/x.csv\"; x t; y u; } } } }";

    const std::string message = failureOf(plots);

    EXPECT_NE(message.find("plot 'bad', series 'ref': no file 'reference/none.csv'"),
              std::string::npos)
        << message;
    EXPECT_TRUE(fs::exists(folder / "postProcessing/plots/good.svg"));
    EXPECT_FALSE(fs::exists(folder / "postProcessing/plots/bad.svg"));
}

TEST_F(ProbeCase, NamesTheEntryWhoseFieldOrPartDoesNotExist)
{
    addFrame("0", 0);

    EXPECT_EQ(failureOf("pictures { p { field Misses; } }"),
              "picture 'p': field 'Misses' is not among the results of this case");
    EXPECT_EQ(failureOf("pictures { p { field Mises; parts (rod); } }"),
              "picture 'p': the mesh has no part 'rod'");
    EXPECT_EQ(failureOf("tables { t { type section; set ends; field U; } }"),
              "table 't': the mesh has no set 'ends'");
}

TEST_F(ProbeCase, TakesTheFramesOfTheRunInStatusAndMarksWhatItMakes)
{
    addFrame("0", 0, "one");
    addFrame("0.0001", 1e-4, "one");
    addFrame("0.0002", 2e-4, "two");
    setStatus("finished", "one");

    const auto files = run(plot + "pictures { last { field Mises; } }" + table);

    EXPECT_EQ(readTable(folder / "postProcessing/end/0/U.dat").values("time"),
              (std::vector<double>{0, 1e-4}));
    EXPECT_TRUE(fs::exists(folder / "postProcessing/pictures/last_0.0001.png"));
    EXPECT_NE(said.find("warning: left out: 1 frames of other runs, at times 0.0002\n"), said.npos)
        << said;
    // A new run knows them by their marks.
    const auto known = resultFiles(folder.path());
    ASSERT_EQ(files.size(), 4U);
    for (const std::string& file : files)
        EXPECT_NE(std::find(known.begin(), known.end(), file), known.end()) << file;
}

TEST_F(ProbeCase, DrawsNoFramesOfAnotherMesh)
{
    addFrame("0", 0, "one");
    setStatus("finished", "one");
    Mesh finer;
    test::addBox(finer, "bar", {4, 1, 1}, {0, 0, 0}, {2, 1, 1});
    finer.patchStarts = {0, 4};
    finer.sideSets["end"] = {{3, 1}};
    writeMesh(OutputFolder(folder.path()), finer);

    EXPECT_TRUE(run("pictures { last { field Mises; } }" + table).empty());
    EXPECT_NE(said.find("warning: left out: 1 frames of another mesh than constant/mesh.vtkhdf, at "
                        "times 0; run fpmExplicit with this mesh\n"),
              said.npos)
        << said;
}

TEST_F(ProbeCase, DrawsARunThatFailedAndSaysSo)
{
    addFrame("0", 0, "one");
    setStatus("failed", "one");
    test::writeBytes(folder / "why.txt", "step 7: element 3 has no positive volume any more\n");

    EXPECT_EQ(run("pictures { last { field Mises; } }").size(), 2U);
    EXPECT_EQ(
        said.substr(0, said.find('\n')),
        "warning: run one failed at time 0.0001: step 7: element 3 has no positive volume any "
        "more; its results end there");
}

TEST_F(ProbeCase, NamesAFrameThatIsCutShort)
{
    addFrame("0", 0, "one");
    addFrame("0.0001", 1e-4, "one");
    setStatus("finished", "one");
    const auto file = folder / "0.0001/fields.vtkhdf";
    fs::resize_file(file, fs::file_size(file) / 2);

    EXPECT_EQ(failureOf("pictures { last { field Mises; } }"),
              "frame '" + fs::canonical(file).string() + "' is cut short or no frame of ours");
}

TEST_F(ProbeCase, LeavesSeriesOfAnotherRunOutOfAPlot)
{
    setStatus("finished", "one");
    for (const std::string runId : {"one", "two"}) {
        const std::string file = "postProcessing/" + runId + "/0/U.dat";
        fs::create_directories((folder / file).parent_path());
        fs::create_directories(folder / "previous/postProcessing");
        for (const std::string& place : {file, "previous/postProcessing/" + runId + ".dat"})
            test::writeBytes(folder / place, "# fpm run " + runId + " " + file + "\n# t u\n0 1\n");
    }
    const auto series = [](const std::string& file) {
        return "a { file \"" + file + "\"; x t; y u; }";
    };

    EXPECT_EQ(
        run("plots { p { series { " + series("postProcessing/one/0/U.dat")
            + " } }"
              " q { series { "
            + series("postProcessing/two/0/U.dat")
            + " } }"
              " r { series { "
            + series("previous/postProcessing/two.dat") + " } } }"),
        (std::vector<std::string>{"postProcessing/plots/p.svg", "postProcessing/plots/r.svg"}));
    EXPECT_NE(
        said.find("warning: plot 'q': 'postProcessing/two/0/U.dat' is of run two, not of this "
                  "one: left out\nplot 'q': no series: skipped\n"),
        said.npos)
        << said;
}

TEST_F(ProbeCase, RefusesFilesOutsideTheCaseAndMisspeltKeys)
{
    EXPECT_NE(failureOf("plots { p { series { a { file \"../x.dat\"; x t; y u; } } } }"),
              "no error");
    EXPECT_NE(failureOf("pictures { p { field U; veiw (1 0 0); } }").find("view"),
              std::string::npos);
    EXPECT_NE(failureOf("pictures { p { field U; range (3 1); } }"), "no error");
    EXPECT_NE(failureOf("pictures { p { field U; view (0 0 0); } }"), "no error");
    EXPECT_NE(failureOf("pictures { p { field U; mirror (w); } }"), "no error");
    EXPECT_NE(failureOf("plots { p { series { } } }"), "no error");
}

TEST_F(ProbeCase, AcceptsEveryKeyOfTheAnnotatedDictionary)
{
    const std::string manual = std::string(FPM_SOURCE_DIR) + "/etc/caseDicts/probeDict";

    EXPECT_TRUE(run(test::readBytes(manual), {false, false, false, {}}).empty());
}
