#include "io/Frames.h"

#include "base/Error.h"
#include "io/VtkHdf.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

using namespace fpm;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

namespace {

void add(const TemporaryFolder& folder,
         const std::string& name,
         double time,
         const std::string& runId,
         const std::string& mesh = "0123456789abcdef")
{
    Frame frame;
    frame.time = time;
    frame.meshChecksum = mesh;
    frame.runId = runId;
    frame.nodeFields.push_back({"U", 3, std::vector<double>(24, 0.5)});
    writeFrame(OutputFolder(folder.path()), name, frame, 8, 1);
}

} // namespace

TEST(Frames, AreListedInAscendingOrderWithRunAndMesh)
{
    const TemporaryFolder folder;
    for (const double time : {1e-3, 0.0, 5e-5, 1.5e-4}) add(folder, timeName(time), time, "one");
    add(folder, "2", 2, "two", "fedcba9876543210");
    add(folder, "3", 3, "");                                // of no run
    std::filesystem::create_directories(folder / "0.5");    // no frame
    std::filesystem::create_directories(folder / "0.orig"); // no time
    writeBytes(folder / "0.orig/fields.vtkhdf", "no frame of a time folder");

    const auto frames = listFrames(folder.path());

    ASSERT_EQ(frames.size(), 6U);
    EXPECT_EQ(frames[0].time, FrameTime("0", 0.0));
    EXPECT_EQ(frames[1].time, FrameTime("5e-05", 5e-5));
    EXPECT_EQ(frames[2].time, FrameTime("0.00015", 1.5e-4));
    EXPECT_EQ(frames[3].time, FrameTime("0.001", 1e-3));
    EXPECT_EQ(frames[3].runId, "one");
    EXPECT_EQ(frames[3].meshChecksum, "0123456789abcdef");
    EXPECT_EQ(frames[4].runId, "two");
    EXPECT_EQ(frames[4].meshChecksum, "fedcba9876543210");
    EXPECT_EQ(frames[5].runId, "");
    EXPECT_EQ(readFrame(folder / "2/fields.vtkhdf", {"fedcba9876543210", 8, 1}).runId, "two");
}

TEST(Frames, CutShortAreNamed)
{
    const TemporaryFolder folder;
    add(folder, "0", 0, "one");
    add(folder, "0.5", 0.5, "one");
    const auto file = folder / "0.5/fields.vtkhdf";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);

    try {
        listFrames(folder.path());
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::mesh);
        EXPECT_EQ(std::string(error.what()),
                  "frame '" + file.string() + "' is cut short or no frame of ours");
    }
}

TEST(Frames, AreRecognisedByWhatTheyHold)
{
    const TemporaryFolder folder;
    add(folder, "0.5", 0.5, "one");
    add(folder, "failed", 0.5, "");
    const auto root = folder.path();
    const auto whole = readBytes(folder / "0.5/fields.vtkhdf");
    for (const char* other : {"0.25", "0.5kept", "0.75", "1", "2"})
        std::filesystem::create_directories(folder / other);
    writeBytes(folder / "0.25/fields.vtkhdf", whole.substr(0, whole.size() / 2)); // cut short
    writeBytes(folder / "0.5kept/fields.vtkhdf", whole);                          // a copy
    writeBytes(folder / "0.75/fields.vtkhdf", "of a user");
    writeBytes(folder / "1/fields.vtkhdf", "\x89HDF\r\n\x1a\n of another program");
    std::filesystem::create_symlink("../0.5/fields.vtkhdf", folder / "2/fields.vtkhdf");

    EXPECT_TRUE(isFrame(root, "0.5/fields.vtkhdf"));
    EXPECT_TRUE(isFrame(root, "failed/fields.vtkhdf"));
    EXPECT_TRUE(isFrame(root, "0.25/fields.vtkhdf"));
    for (const char* other : {"0.5kept", "0.75", "1", "2", "3"})
        EXPECT_FALSE(isFrame(root, std::string(other) + "/fields.vtkhdf")) << other;
}

TEST(Frames, OfAnOlderVersionAreReadAndRecognised)
{
    const TemporaryFolder folder;
    Hdf5Image image;
    image.attribute("/VTKHDF", "Type", "UnstructuredGrid");
    image.attribute("/fpm", "meshChecksum", "0123456789abcdef");
    image.save(OutputFolder(folder.path()), "0.5/fields.vtkhdf");

    const auto frames = listFrames(folder.path());

    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].runId, "");
    EXPECT_EQ(frames[0].meshChecksum, "0123456789abcdef");
    EXPECT_TRUE(isFrame(folder.path(), "0.5/fields.vtkhdf"));
}

TEST(Frames, SeriesIsWrittenUnderBothNames)
{
    const TemporaryFolder folder;

    writeSeries(OutputFolder(folder.path()), "one", {"0", "5e-05"});

    const std::string series = readBytes(folder / "case.vtkhdf.series");
    EXPECT_EQ(series,
              "{\n  \"file-series-version\": \"1.0\",\n  \"runId\": \"one\",\n  \"files\": [\n"
              "    {\"name\": \"0/fields.vtkhdf\", \"time\": 0},\n"
              "    {\"name\": \"5e-05/fields.vtkhdf\", \"time\": 5e-05}\n  ]\n}\n");
    EXPECT_EQ(readBytes(folder / "case.hdf.series"), series);
}

TEST(Frames, TimesAreNamedWithoutRounding)
{
    EXPECT_EQ(timeName(0), "0");
    EXPECT_EQ(timeName(-0.0), "0");
    EXPECT_EQ(timeName(0.1 + 0.2), "0.3");
    EXPECT_EQ(timeName(1.5e-4), "0.00015");
    EXPECT_EQ(timeName(3 * 5e-5), "0.00015");
    EXPECT_EQ(timeName(4e-4), "0.0004");
    EXPECT_EQ(timeName(1), "1");
    double time = 0;
    for (int step = 0; step < 1000; ++step) time += 1e-7;
    EXPECT_EQ(timeName(time), "0.0001");
}
