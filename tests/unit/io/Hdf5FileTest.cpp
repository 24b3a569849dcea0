#include "io/Hdf5File.h"

#include "base/Error.h"
#include "io/Checksum.h"
#include "io/Hdf5Handle.h"
#include "io/Hdf5Seal.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <thread>

using namespace fpm;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

namespace {

const std::vector<double> numbers{1, 2.5, -3, 1e300, 0, 7};

Hdf5Image exampleImage()
{
    Hdf5Image image;
    image.write("/a/b/doubles", std::span<const double>(numbers), 3);
    image.write("/a/floats", std::vector<float>{0.5F, 2});
    image.write("/a/integers", std::vector<std::int32_t>{1, -2, 3});
    image.write("/a/bytes", std::vector<std::uint8_t>{12, 255});
    image.write("/a/empty", std::vector<std::int32_t>{});
    image.attribute("/a", "text", "hello");
    image.attribute("/", "nothing", "");
    image.attribute("/new/group", "list", std::vector<std::int64_t>{1, 2, 1LL << 40});
    image.attribute("/a", "number", 0.1);
    return image;
}

/// The message of the Error(mesh) that reading ends with; empty when there is none.
template <class Action>
std::string refusal(const Action& action)
{
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::mesh);
        return error.what();
    }
    return "";
}

/// Gives a file made by plain HDF5 calls the checksum that lets it past the first gate.
void seal(const std::filesystem::path& file)
{
    std::string bytes = readBytes(file);
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(bytes)));
    for (const std::byte one : hdf5::makeSeal(checksum.value())) bytes += char(one);
    writeBytes(file, bytes);
}

/// A file whose content `fill(file id)` makes with plain HDF5 calls, sealed.
template <class Fill>
std::filesystem::path craftedFile(const TemporaryFolder& folder, const Fill& fill)
{
    const auto path = folder / "crafted.h5";
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    fill(file);
    H5Fclose(file);
    seal(path);
    return path;
}

void writeDataset(hid_t file,
                  hid_t type,
                  std::vector<hsize_t> shape,
                  hid_t properties = H5P_DEFAULT)
{
    const hid_t space = H5Screate_simple(int(shape.size()), shape.data(), nullptr);
    const hid_t data = H5Dcreate2(file, "data", type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    ASSERT_GE(data, 0);
    H5Dclose(data);
    H5Sclose(space);
}

} // namespace

TEST(Hdf5File, ReadsBackWhatWasWritten)
{
    const TemporaryFolder folder;
    exampleImage().save(OutputFolder(folder.path()), "file.h5");

    const Hdf5Reader reader(folder / "file.h5");

    EXPECT_EQ(reader.doubles("/a/b/doubles"), numbers);
    EXPECT_EQ(reader.columns("/a/b/doubles"), 3U);
    EXPECT_EQ(reader.doubles("/a/floats"), (std::vector<double>{0.5, 2}));
    EXPECT_EQ(reader.columns("/a/floats"), 1U);
    EXPECT_EQ(reader.integers("/a/integers"), (std::vector<std::int64_t>{1, -2, 3}));
    EXPECT_EQ(reader.integers("/a/bytes"), (std::vector<std::int64_t>{12, 255}));
    EXPECT_TRUE(reader.integers("/a/empty").empty());
    EXPECT_EQ(reader.text("/a", "text"), "hello");
    EXPECT_EQ(reader.text("/", "nothing"), "");
    EXPECT_EQ(reader.integers("/new/group", "list"), (std::vector<std::int64_t>{1, 2, 1LL << 40}));
    EXPECT_EQ(reader.number("/a", "number"), 0.1);
    EXPECT_EQ(reader.children("/a"),
              (std::vector<std::string>{"b", "bytes", "empty", "floats", "integers"}));
    EXPECT_TRUE(reader.has("/a/b/doubles"));
    EXPECT_FALSE(reader.has("/a/c"));
    EXPECT_FALSE(reader.has("/c/d/e"));
}

TEST(Hdf5File, IsByteIdenticalForEqualContent)
{
    const TemporaryFolder folder;

    exampleImage().save(OutputFolder(folder.path()), "first.h5");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // HDF5 stores whole seconds
    exampleImage().save(OutputFolder(folder.path()), "second.h5");

    EXPECT_EQ(readBytes(folder / "first.h5"), readBytes(folder / "second.h5"));
}

TEST(Hdf5File, OpensInOtherProgramsDespiteItsChecksum)
{
    const TemporaryFolder folder;
    exampleImage().save(OutputFolder(folder.path()), "file.h5");

    const hid_t file = H5Fopen((folder / "file.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);

    ASSERT_GE(file, 0);
    EXPECT_GT(H5Lexists(file, "/a/b/doubles", H5P_DEFAULT), 0);
    H5Fclose(file);
}

TEST(Hdf5File, RefusesRowsThatDoNotFill)
{
    Hdf5Image image;

    EXPECT_THROW(image.write("/a", std::span<const double>(numbers), 4), Error);
}

TEST(Hdf5File, NamesTheFileThatIsNotThere)
{
    EXPECT_NE(refusal([] { Hdf5Reader("/nowhere/file.h5"); }).find("/nowhere/file.h5"),
              std::string::npos);
}

TEST(Hdf5File, RefusesWhatIsNoFileOfOurs)
{
    const TemporaryFolder folder;
    writeBytes(folder / "empty", "");
    writeBytes(folder / "text", "this is a text that somebody has renamed to look like a mesh");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);

    for (const std::string name : {"empty", "text", "pipe", "."})
        EXPECT_NE(refusal([&] { Hdf5Reader{folder / name}; }), "") << name;
}

TEST(Hdf5File, RefusesEveryTruncation)
{
    const TemporaryFolder folder;
    const auto file = folder / "file.h5";
    exampleImage().save(OutputFolder(file.parent_path()), file.filename().string());
    EXPECT_TRUE(hdf5Label(file));

    for (std::size_t length = std::filesystem::file_size(file); length-- > 0;) {
        std::filesystem::resize_file(file, length);
        EXPECT_NE(refusal([&] { Hdf5Reader{file}; }), "") << length;
        EXPECT_FALSE(hdf5Label(file)) << length;
    }
}

TEST(Hdf5File, RefusesAChangeOfAnyByte)
{
    const TemporaryFolder folder;
    const auto file = folder / "file.h5";
    exampleImage().save(OutputFolder(file.parent_path()), file.filename().string());
    const std::string bytes = readBytes(file);

    for (std::size_t place = 0; place < bytes.size(); ++place) {
        test::replaceByte(file, place, char(bytes[place] ^ (1 << (place % 8))));
        EXPECT_NE(refusal([&] { Hdf5Reader{file}; }), "") << place;
        test::replaceByte(file, place, bytes[place]);
    }
    EXPECT_EQ(refusal([&] { Hdf5Reader{file}; }), "");
}

TEST(Hdf5File, TakesNoIntegersFromNumbers)
{
    const TemporaryFolder folder;
    exampleImage().save(OutputFolder(folder.path()), "file.h5");
    const Hdf5Reader reader(folder / "file.h5");

    EXPECT_NE(refusal([&] { reader.integers("/a/b/doubles"); }), "");
    EXPECT_NE(refusal([&] { reader.integers("/a", "number"); }), "");
    EXPECT_NE(refusal([&] { reader.number("/a", "text"); }), "");
    EXPECT_NE(refusal([&] { reader.text("/a", "number"); }), "");
    EXPECT_NE(refusal([&] { reader.doubles("/a/b"); }), "");
    EXPECT_NE(refusal([&] { reader.children("/a/floats"); }), "");
}

TEST(Hdf5File, DoesNotFollowLinks)
{
    const TemporaryFolder folder;
    exampleImage().save(OutputFolder(folder.path()), "target.h5");
    Hdf5Image image;
    image.link("/outside", "target.h5", "/a");
    image.link("/group/doubles", "target.h5", "/a/b/doubles");
    image.save(OutputFolder(folder.path()), "file.h5");
    const auto soft = craftedFile(folder, [](hid_t file) {
        writeDataset(file, H5T_IEEE_F64LE, {0});
        H5Lcreate_soft("/data", file, "/soft", H5P_DEFAULT, H5P_DEFAULT);
    });

    const Hdf5Reader reader(folder / "file.h5");

    EXPECT_FALSE(reader.has("/outside"));
    EXPECT_FALSE(reader.has("/outside/b/doubles"));
    EXPECT_NE(refusal([&] { reader.doubles("/outside/b/doubles"); }), "");
    EXPECT_NE(refusal([&] { reader.doubles("/group/doubles"); }), "");
    EXPECT_NE(refusal([&] { reader.text("/outside", "text"); }), "");
    EXPECT_EQ(refusal([&] { Hdf5Reader(soft).doubles("/data"); }), "");
    EXPECT_NE(refusal([&] { Hdf5Reader(soft).doubles("/soft"); }), "");
}

TEST(Hdf5File, RefusesSizesBeyondTheFile)
{
    const TemporaryFolder folder;
    const std::vector<std::vector<hsize_t>> shapes{
        {hsize_t(1) << 50}, {hsize_t(1) << 30, hsize_t(1) << 20}, {1, hsize_t(1) << 40}, {1000, 3}};
    for (const auto& shape : shapes) {
        const auto file =
            craftedFile(folder, [&](hid_t id) { writeDataset(id, H5T_IEEE_F64LE, shape); });
        EXPECT_NE(refusal([&] { Hdf5Reader(file).doubles("/data"); }).find("can hold"),
                  std::string::npos)
            << shape[0];
    }
}

TEST(Hdf5File, RefusesOtherTypesAndStorage)
{
    const TemporaryFolder folder;
    const hid_t text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, H5T_VARIABLE);
    const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = 16;
    H5Pset_chunk(chunked, 1, &chunk);
    H5Pset_deflate(chunked, 1);
    const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(external, "/etc/hostname", 0, 64);

    const auto read = [&](hid_t type, std::vector<hsize_t> shape, hid_t properties) {
        const auto file =
            craftedFile(folder, [&](hid_t id) { writeDataset(id, type, shape, properties); });
        return refusal([&] { Hdf5Reader(file).doubles("/data"); });
    };

    EXPECT_NE(read(text, {2}, H5P_DEFAULT), "");
    EXPECT_NE(read(H5T_IEEE_F64BE, {2}, H5P_DEFAULT), "");
    EXPECT_NE(read(H5T_STD_REF_OBJ, {2}, H5P_DEFAULT), "");
    EXPECT_NE(read(H5T_IEEE_F64LE, {2, 2, 2}, H5P_DEFAULT), "");
    EXPECT_NE(read(H5T_IEEE_F64LE, {16}, chunked), "");
    EXPECT_NE(read(H5T_IEEE_F64LE, {8}, external).find("outside of the file"), std::string::npos);
    EXPECT_NE(read(H5T_STD_U64LE, {2}, H5P_DEFAULT), "");
    H5Pclose(external);
    H5Pclose(chunked);
    H5Tclose(text);
}

TEST(Hdf5File, RefusesVirtualAndCompactStorage)
{
    const TemporaryFolder folder;
    exampleImage().save(OutputFolder(folder.path()), "source.h5");
    const hsize_t length = 2;
    const hid_t space = H5Screate_simple(1, &length, nullptr);
    const hid_t elsewhere = H5Pcreate(H5P_DATASET_CREATE), compact = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_virtual(elsewhere, space, (folder / "source.h5").c_str(), "/a/floats", space);
    H5Pset_layout(compact, H5D_COMPACT);

    for (const hid_t properties : {elsewhere, compact}) {
        const auto file = craftedFile(
            folder, [&](hid_t id) { writeDataset(id, H5T_IEEE_F64LE, {2}, properties); });
        EXPECT_NE(refusal([&] { Hdf5Reader{file}; }).find("/data is stored"), std::string::npos);
    }
    H5Pclose(compact);
    H5Pclose(elsewhere);
    H5Sclose(space);
}

TEST(Hdf5File, RefusesWhatItDoesNotWrite)
{
    const TemporaryFolder folder;
    const auto read = [&](const auto& fill) {
        const auto file = craftedFile(folder, fill);
        return refusal([&] { Hdf5Reader{file}; });
    };
    const auto addGroup = [](hid_t above, const std::string& name, hid_t properties = H5P_DEFAULT) {
        const hid_t group = H5Gcreate2(above, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT);
        ASSERT_GE(group, 0);
        H5Gclose(group);
    };
    const auto has = [](const std::string& text, const char* words) {
        return text.find(words) != std::string::npos;
    };

    const hid_t filtered = H5Pcreate(H5P_GROUP_CREATE);
    H5Pset_deflate(filtered, 1);
    EXPECT_TRUE(has(read([&](hid_t file) { addGroup(file, "g", filtered); }), "/g has filters"));
    H5Pclose(filtered);
    EXPECT_TRUE(has(read([](hid_t file) { writeDataset(file, H5T_IEEE_F64LE, {2}); }),
                    "/data lies outside")); // no values were written
    EXPECT_TRUE(has(read([](hid_t file) {
                        const hid_t type = H5Tcopy(H5T_IEEE_F64LE);
                        H5Tcommit2(file, "t", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
                        H5Tclose(type);
                    }),
                    "/t is neither a group nor an array"));
    EXPECT_TRUE(has(read([&](hid_t file) { addGroup(file, "line\nbreak"); }), "cannot be used"));
    EXPECT_TRUE(has(read([&](hid_t file) {
                        addGroup(file, "g");
                        H5Lcreate_hard(file, "/", file, "/g/up", H5P_DEFAULT, H5P_DEFAULT);
                    }),
                    "deeper in each other"));
}

TEST(Hdf5File, LoadsNoPlugins)
{
    hdf5::initialise();
    unsigned state = 1;

    EXPECT_GE(H5PLget_loading_state(&state), 0);

    EXPECT_EQ(state, 0U);
}

TEST(Hdf5File, ReadsNumbersOfEveryWidth)
{
    const TemporaryFolder folder;
    const auto file = craftedFile(folder, [](hid_t id) {
        const hsize_t length = 3;
        const std::int64_t values[]{1, -2, 100};
        const hid_t space = H5Screate_simple(1, &length, nullptr);
        int number = 0;
        for (const hid_t type : {H5T_STD_I8LE, H5T_STD_I16LE, H5T_STD_I32LE, H5T_STD_I64LE}) {
            const hid_t data = H5Dcreate2(id, std::to_string(number++).c_str(), type, space,
                                          H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
            H5Dwrite(data, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
            H5Dclose(data);
        }
        H5Sclose(space);
    });
    const Hdf5Reader reader(file);

    for (const std::string path : {"/0", "/1", "/2", "/3"}) {
        EXPECT_EQ(reader.integers(path), (std::vector<std::int64_t>{1, -2, 100})) << path;
        EXPECT_EQ(reader.doubles(path), (std::vector<double>{1, -2, 100})) << path;
    }
}

TEST(Hdf5File, ReadsArraysLongerThanABlock)
{
    const TemporaryFolder folder;
    std::vector<float> values(200001);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i);
    Hdf5Image image;
    image.write("/a", std::span<const float>(values));
    image.save(OutputFolder(folder.path()), "file.h5");

    const auto read = Hdf5Reader(folder / "file.h5").doubles("/a");

    EXPECT_TRUE(std::ranges::equal(read, values));
}

TEST(Hdf5File, CarriesALabelThatIsReadWithoutOpeningIt)
{
    const TemporaryFolder folder;
    Hdf5Image image;
    image.write("/a", std::array<double, 1>{2.5});
    image.save(OutputFolder(folder.path()), "plain");
    image.save(OutputFolder(folder.path()), "labelled", "fpm run one a mesh 0");

    EXPECT_EQ(hdf5Label(folder / "plain"), "");
    EXPECT_EQ(hdf5Label(folder / "labelled"), "fpm run one a mesh 0");
    EXPECT_EQ(Hdf5Reader(folder / "labelled").doubles("/a"), std::vector<double>{2.5});
    EXPECT_FALSE(hdf5Label(folder / "none"));
    EXPECT_THROW(image.save(OutputFolder(folder.path()), "long", std::string(256, 'x')), Error);

    std::string bytes = readBytes(folder / "labelled");
    bytes[bytes.size() - 20] ^= 1; // in the label
    writeBytes(folder / "labelled", bytes);
    EXPECT_THROW(Hdf5Reader(folder / "labelled"), Error);
    writeBytes(folder / "short", std::string("fpmsum2\xff") + "12345678"); // longer than the file
    EXPECT_FALSE(hdf5Label(folder / "short"));
}
