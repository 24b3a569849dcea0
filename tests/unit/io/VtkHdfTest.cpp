#include "io/VtkHdf.h"

#include "base/Error.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <hdf5.h>

using namespace fpm;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

namespace {

const std::vector<Point> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                              {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<std::array<Index, 8>> oneCell{{0, 1, 2, 3, 4, 5, 6, 7}};

const FrameMesh meshOfFrames{"0123456789abcdef", 8, 1};

Frame exampleFrame(double time)
{
    Frame frame;
    frame.time = time;
    frame.nodeFields.push_back({"U", 3, std::vector<double>(24, 0.5)});
    frame.elementFields.push_back({"S", 6, {1, 2, 3, 4, 5, 6}});
    frame.elementFields.push_back({"PEEQ", 1, {0.25}});
    return frame;
}

void writeMeshOf(const std::filesystem::path& root, const std::string& label = "")
{
    Hdf5Image image;
    writeGrid(image, cube, oneCell);
    image.attribute("/fpm", "meshChecksum", "0123456789abcdef");
    image.save(OutputFolder(root), "constant/mesh.vtkhdf", label);
}

} // namespace

TEST(VtkHdf, WritesTheArraysVtkAsksFor)
{
    const TemporaryFolder folder;
    writeMeshOf(folder.path());

    const Hdf5Reader reader(folder / "constant/mesh.vtkhdf");

    EXPECT_EQ(reader.text("/VTKHDF", "Type"), "UnstructuredGrid");
    EXPECT_EQ(reader.integers("/VTKHDF", "Version"), (std::vector<std::int64_t>{1, 0}));
    EXPECT_EQ(reader.integers("/VTKHDF/NumberOfPoints"), (std::vector<std::int64_t>{8}));
    EXPECT_EQ(reader.integers("/VTKHDF/NumberOfCells"), (std::vector<std::int64_t>{1}));
    EXPECT_EQ(reader.integers("/VTKHDF/NumberOfConnectivityIds"), (std::vector<std::int64_t>{8}));
    EXPECT_EQ(reader.integers("/VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 8}));
    EXPECT_EQ(reader.integers("/VTKHDF/Types"), (std::vector<std::int64_t>{12}));
    EXPECT_EQ(reader.columns("/VTKHDF/Points"), 3U);
}

TEST(VtkHdf, WritesTheTypeAsFixedAsciiText)
{
    const TemporaryFolder folder;
    writeMeshOf(folder.path());

    const hid_t file =
        H5Fopen((folder / "constant/mesh.vtkhdf").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t attribute = H5Aopen_by_name(file, "/VTKHDF", "Type", H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);

    EXPECT_EQ(H5Tis_variable_str(type), 0);
    EXPECT_EQ(H5Tget_cset(type), H5T_CSET_ASCII);
    EXPECT_EQ(H5Tget_strpad(type), H5T_STR_NULLPAD);
    EXPECT_EQ(H5Tget_size(type), 16U);
    H5Tclose(type);
    H5Aclose(attribute);
    H5Fclose(file);
}

TEST(VtkHdf, ReadsBackAFrame)
{
    const TemporaryFolder folder;
    writeMeshOf(folder.path());

    writeFrame(OutputFolder(folder.path()), "0.00015", exampleFrame(1.5e-4), 8, 1);
    const Frame frame = readFrame(folder / "0.00015/fields.vtkhdf", meshOfFrames);

    EXPECT_EQ(frame.time, 1.5e-4);
    EXPECT_EQ(frame.meshChecksum, "0123456789abcdef");
    EXPECT_EQ(frame.runId, "");
    ASSERT_EQ(frame.nodeFields.size(), 1U);
    EXPECT_EQ(frame.nodeFields[0].name, "U");
    EXPECT_EQ(frame.nodeFields[0].columns, 3U);
    EXPECT_EQ(frame.nodeFields[0].values, std::vector<double>(24, 0.5));
    ASSERT_EQ(frame.elementFields.size(), 2U);
    EXPECT_EQ(frame.elementFields[0].name, "PEEQ");
    EXPECT_EQ(frame.elementFields[1].name, "S");
    EXPECT_EQ(frame.elementFields[1].columns, 6U);
    EXPECT_EQ(frame.elementFields[1].values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

/// Kind of the link at a path of a file, H5L_TYPE_ERROR where there is none.
static H5L_type_t linkAt(const std::filesystem::path& name, const char* path)
{
    const hid_t file = H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    H5L_info_t info;
    const bool found =
        H5Lexists(file, path, H5P_DEFAULT) > 0 && H5Lget_info(file, path, &info, H5P_DEFAULT) >= 0;
    H5Fclose(file);
    return found ? info.type : H5L_TYPE_ERROR;
}

TEST(VtkHdf, AFrameShowsTheNumbersOfTheMeshAndHoldsNoneItself)
{
    const TemporaryFolder folder;
    writeMeshOf(folder.path(), "ids mesh 0123456789abcdef");

    writeFrame(OutputFolder(folder.path()), "0", exampleFrame(0), 8, 1);

    const auto file = folder / "0/fields.vtkhdf";
    EXPECT_EQ(linkAt(file, "/VTKHDF/PointData/NodeId"), H5L_TYPE_EXTERNAL);
    EXPECT_EQ(linkAt(file, "/VTKHDF/CellData/ElementId"), H5L_TYPE_EXTERNAL);
    const Frame frame = readFrame(file, meshOfFrames);
    EXPECT_EQ(frame.meshChecksum, "0123456789abcdef");
    EXPECT_EQ(frame.nodeFields.size(), 1U);
    EXPECT_EQ(frame.elementFields.size(), 2U);
}

TEST(VtkHdf, AFrameOfAnOlderMeshWithoutNumbersHasNoLinksIntoTheVoid)
{
    const TemporaryFolder folder;
    writeMeshOf(folder.path()); // no label

    writeFrame(OutputFolder(folder.path()), "0", exampleFrame(0), 8, 1);

    EXPECT_EQ(linkAt(folder / "0/fields.vtkhdf", "/VTKHDF/PointData/NodeId"), H5L_TYPE_ERROR);
    EXPECT_EQ(linkAt(folder / "0/fields.vtkhdf", "/VTKHDF/CellData/ElementId"), H5L_TYPE_ERROR);
}

TEST(VtkHdf, RefusesFieldsOfTheWrongLength)
{
    const TemporaryFolder folder;
    Frame frame = exampleFrame(0);
    frame.nodeFields[0].values.pop_back();

    EXPECT_THROW(writeFrame(OutputFolder(folder.path()), "0", frame, 8, 1), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "0/fields.vtkhdf"));
}

TEST(VtkHdf, RefusesADamagedFrame)
{
    const TemporaryFolder folder;
    writeMeshOf(folder.path());
    writeFrame(OutputFolder(folder.path()), "0", exampleFrame(0), 8, 1);
    EXPECT_NO_THROW(readFrame(folder / "0/fields.vtkhdf", meshOfFrames));
    std::string bytes = readBytes(folder / "0/fields.vtkhdf");
    bytes[bytes.size() / 2] ^= 4;
    writeBytes(folder / "0/fields.vtkhdf", bytes);

    EXPECT_THROW(readFrame(folder / "0/fields.vtkhdf", meshOfFrames), Error);
}

TEST(VtkHdf, RefusesAFrameOfAnotherMesh)
{
    const TemporaryFolder folder;
    writeMeshOf(folder.path());
    writeFrame(OutputFolder(folder.path()), "0", exampleFrame(0), 8, 1);
    const auto file = folder / "0/fields.vtkhdf";

    EXPECT_NO_THROW(readFrame(file, meshOfFrames));
    EXPECT_THROW(readFrame(file, {"fedcba9876543210", 8, 1}), Error);
    EXPECT_THROW(readFrame(file, {"0123456789abcdef", 9, 1}), Error);
    EXPECT_THROW(readFrame(file, {"0123456789abcdef", 8, 2}), Error);
}

TEST(VtkHdf, RefusesAFrameWhoseLabelNamesAnotherRunOrMesh)
{
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& label) {
        Hdf5Image image;
        image.attribute("/fpm", "TimeValue", 0.5);
        image.attribute("/fpm", "nodeCount", std::array<std::int64_t, 1>{8});
        image.attribute("/fpm", "elementCount", std::array<std::int64_t, 1>{1});
        image.attribute("/fpm", "meshChecksum", "0123456789abcdef");
        image.attribute("/fpm", "runId", "one");
        image.save(OutputFolder(folder.path()), "frame", label);
        try {
            readFrame(folder / "frame", meshOfFrames);
        } catch (const Error& error) {
            return std::string(error.what()).find("another run or mesh") != std::string::npos;
        }
        return false;
    };

    EXPECT_FALSE(refused("fpm run one 0/fields.vtkhdf mesh 0123456789abcdef"));
    EXPECT_FALSE(refused("")); // of an older version
    EXPECT_TRUE(refused("fpm run two 0/fields.vtkhdf mesh 0123456789abcdef"));
    EXPECT_TRUE(refused("fpm run one 0/fields.vtkhdf mesh fedcba9876543210"));
    EXPECT_TRUE(refused("mesh 0123456789abcdef"));
}
