#include "mesh/MeshFile.h"

#include "base/Error.h"
#include "io/Checksum.h"
#include "io/Frames.h"
#include "io/Hdf5File.h"
#include "io/Hdf5Seal.h"
#include "io/VtkHdf.h"
#include "mesh/Patches.h"
#include "mesh/Surface.h"
#include "support/TemporaryFolder.h"
#include "support/boxMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace fpm;
using test::TemporaryFolder;

namespace {

Mesh exampleMesh()
{
    Mesh mesh;
    test::addBox(mesh, "rod", {3, 2, 2});
    test::addBox(mesh, "a.plate", {2, 2, 1}, {0, 0, 2});
    mesh.sideSets["rodSkin"] = skin(mesh, 0);
    mesh.sideSets["none"] = {};
    mesh.nodeSets["tip"] = {3, 5};
    renumber(mesh);
    mesh.contact.push_back({"z.first", {1, 2}, {{0, 1}, {3, 5}}, {{12, 0}}});
    mesh.contact.push_back({"a.second", {}, {}, {{13, 4}}});
    mesh.contactKey = "key";
    return mesh;
}

void expectEqual(const Mesh& a, const Mesh& b)
{
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.hexahedra, b.hexahedra);
    EXPECT_EQ(a.patchStarts, b.patchStarts);
    EXPECT_EQ(a.nodeSets, b.nodeSets);
    EXPECT_EQ(a.sideSets, b.sideSets);
    EXPECT_EQ(a.contactKey, b.contactKey);
    ASSERT_EQ(a.parts.size(), b.parts.size());
    for (std::size_t part = 0; part < a.parts.size(); ++part) {
        EXPECT_EQ(a.parts[part].name, b.parts[part].name);
        EXPECT_EQ(a.parts[part].firstElement, b.parts[part].firstElement);
        EXPECT_EQ(a.parts[part].elementCount, b.parts[part].elementCount);
    }
    ASSERT_EQ(a.contact.size(), b.contact.size());
    for (std::size_t pair = 0; pair < a.contact.size(); ++pair) {
        EXPECT_EQ(a.contact[pair].pair, b.contact[pair].pair);
        EXPECT_EQ(a.contact[pair].contactorNodes, b.contact[pair].contactorNodes);
        EXPECT_EQ(a.contact[pair].contactorSides, b.contact[pair].contactorSides);
        EXPECT_EQ(a.contact[pair].targetSides, b.contact[pair].targetSides);
    }
}

/// Message of the refusal when `mesh` is written and read again; empty when it is accepted.
std::string refusal(const Mesh& mesh)
{
    const TemporaryFolder folder;
    writeMesh(OutputFolder(folder.path()), mesh);
    try {
        readMesh(folder / meshFile);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::mesh);
        return error.what();
    }
    return "";
}

template <class Change>
std::string refusalAfter(const Change& change)
{
    Mesh mesh = exampleMesh();
    change(mesh);
    return refusal(mesh);
}

} // namespace

TEST(MeshFile, ReadsBackWhatWasWritten)
{
    const TemporaryFolder folder;
    const Mesh mesh = exampleMesh();

    writeMesh(OutputFolder(folder.path()), mesh);

    expectEqual(readMesh(folder / meshFile), mesh);
}

TEST(MeshFile, ShowsPartAndPatchInParaView)
{
    const TemporaryFolder folder;
    writeMesh(OutputFolder(folder.path()), exampleMesh());

    const Hdf5Reader reader(folder / meshFile);

    const auto parts = reader.integers("/VTKHDF/CellData/Part");
    EXPECT_EQ(parts.size(), 16U);
    EXPECT_EQ(parts[11], 0);
    EXPECT_EQ(parts[12], 1);
    EXPECT_EQ(reader.integers("/VTKHDF/CellData/Patch"), parts);
}

TEST(MeshFile, ShowsTheNumbersOfMessagesInParaView)
{
    const TemporaryFolder folder;
    const Mesh mesh = exampleMesh();
    writeMesh(OutputFolder(folder.path()), mesh);

    const Hdf5Reader reader(folder / meshFile);

    const auto nodes = reader.integers("/VTKHDF/PointData/NodeId");
    const auto elements = reader.integers("/VTKHDF/CellData/ElementId");
    ASSERT_EQ(nodes.size(), mesh.points.size());
    ASSERT_EQ(elements.size(), mesh.hexahedra.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(nodes[i], std::int64_t(i));
    for (std::size_t i = 0; i < elements.size(); ++i) EXPECT_EQ(elements[i], std::int64_t(i));
    EXPECT_TRUE(meshHasIds(folder.path()));
    EXPECT_EQ(meshChecksumOf(folder.path()), meshChecksum(mesh));
}

TEST(MeshFile, AdvisesToMakeAMissingMesh)
{
    try {
        readMesh("/nowhere/mesh.vtkhdf");
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::mesh);
        EXPECT_NE(error.advice().find("fpmMesh"), std::string::npos);
    }
}

TEST(MeshFile, ChecksumCoversTheMeshButNotItsContactSurfaces)
{
    const Mesh mesh = exampleMesh();
    Mesh moved = mesh, renamed = mesh, contact = mesh, sets = mesh;
    moved.points[3][1] += 1e-15;
    renamed.parts[0].name = "rot";
    contact.contact.clear();
    sets.nodeSets["tip"].pop_back();

    EXPECT_NE(meshChecksum(moved), meshChecksum(mesh));
    EXPECT_NE(meshChecksum(renamed), meshChecksum(mesh));
    EXPECT_NE(meshChecksum(sets), meshChecksum(mesh));
    EXPECT_EQ(meshChecksum(contact), meshChecksum(mesh));
}

TEST(MeshFile, RefusesWhatPointsNowhere)
{
    EXPECT_NE(refusalAfter([](Mesh& mesh) { mesh.hexahedra[3][2] = 9999; }).find("[26] 9999"),
              std::string::npos);
    EXPECT_NE(refusalAfter([](Mesh& mesh) { mesh.hexahedra[0][0] = -1; }), "");
    EXPECT_NE(refusalAfter([](Mesh& mesh) { mesh.nodeSets["tip"][1] = 1000; }), "");
    EXPECT_NE(refusalAfter([](Mesh& mesh) { std::ranges::reverse(mesh.nodeSets["tip"]); }), "");
    EXPECT_NE(refusalAfter([](Mesh& mesh) { mesh.sideSets["rodSkin"].back() = {16, 0}; }), "");
    EXPECT_NE(refusalAfter([](Mesh& mesh) { mesh.sideSets["rodSkin"].back() = {15, 6}; }), "");
    EXPECT_NE(refusalAfter([](Mesh& mesh) { mesh.contact[0].contactorNodes[1] = 1000; }), "");
    EXPECT_NE(refusalAfter([](Mesh& mesh) { mesh.contact[0].targetSides[0] = {99, 0}; }), "");
}

TEST(MeshFile, RefusesBadCoordinates)
{
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity(), 2e15})
        EXPECT_NE(refusalAfter([&](Mesh& mesh) { mesh.points[4][2] = bad; }).find("node 4"),
                  std::string::npos);
}

/// A mesh file whose parts or arrays can be made to lie, which writeMesh would not do.
class LyingFile
{
public:
    explicit LyingFile(const Mesh& mesh) : mesh_(mesh)
    {
        writeGrid(image_, mesh.points, mesh.hexahedra);
    }
    std::string refusal(std::int64_t version,
                        const std::vector<Index>& part,
                        const std::vector<Index>& patchStarts,
                        const std::string& checksum)
    {
        const TemporaryFolder folder;
        image_.attribute("/fpm", "version", std::array<std::int64_t, 1>{version});
        image_.attribute("/fpm", "meshChecksum", checksum);
        image_.attribute("/fpm/contact", "key", "");
        image_.write("/fpm/parts/box", std::span<const Index>(part));
        image_.write("/fpm/patchStarts", std::span<const Index>(patchStarts));
        image_.save(OutputFolder(folder.path()), meshFile);
        try {
            readMesh(folder / meshFile);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

private:
    const Mesh& mesh_;
    Hdf5Image image_;
};

TEST(MeshFile, RefusesCountsVersionsAndChecksumsThatLie)
{
    Mesh mesh = test::boxMesh({2, 2, 2});
    renumber(mesh);
    const std::string sum = meshChecksum(mesh);
    const auto refused = [&](std::int64_t version, const std::vector<Index>& part,
                             const std::vector<Index>& starts, const std::string& checksum) {
        return LyingFile(mesh).refusal(version, part, starts, checksum);
    };

    EXPECT_EQ(refused(1, {0, 0, 8}, {0, 8}, sum), "");
    EXPECT_NE(refused(2, {0, 0, 8}, {0, 8}, sum).find("version"), std::string::npos);
    EXPECT_NE(refused(1, {0, 0, 7}, {0, 8}, sum).find("parts"), std::string::npos);
    EXPECT_NE(refused(1, {0, 1, 7}, {0, 8}, sum).find("parts"), std::string::npos);
    EXPECT_NE(refused(1, {1, 0, 8}, {0, 8}, sum), "");
    EXPECT_NE(refused(1, {0, 0, 8, 1}, {0, 8}, sum), "");
    EXPECT_NE(refused(1, {0, 0, 8}, {0, 7}, sum).find("patches"), std::string::npos);
    EXPECT_NE(refused(1, {0, 0, 8}, {0, 5, 5, 8}, sum).find("patch 1"), std::string::npos);
    EXPECT_NE(refused(1, {0, 0, 8}, {}, sum), "");
    EXPECT_NE(refused(1, {0, 0, 8}, {0, 8}, "0123456789abcdef").find("checksum"),
              std::string::npos);
}

TEST(MeshFile, RefusesEveryTruncation)
{
    const TemporaryFolder folder;
    const auto file = folder / meshFile;
    writeMesh(OutputFolder(folder.path()), exampleMesh());

    for (std::size_t length = std::filesystem::file_size(file); length-- > 0;) {
        std::filesystem::resize_file(file, length);
        EXPECT_THROW(readMesh(file), Error) << length;
    }
}

TEST(MeshFile, RefusesDamagedBytes)
{
    const TemporaryFolder folder;
    const auto file = folder / meshFile;
    writeMesh(OutputFolder(folder.path()), exampleMesh());
    const std::string bytes = test::readBytes(file);
    std::mt19937 random(11);

    for (int trial = 0; trial < 2000; ++trial) {
        const std::size_t place = random() % bytes.size();
        test::replaceByte(file, place, char(bytes[place] ^ (1 << (random() % 8))));
        EXPECT_THROW(readMesh(file), Error) << trial;
        test::replaceByte(file, place, bytes[place]);
    }
    EXPECT_EQ(meshChecksum(readMesh(file)), meshChecksum(exampleMesh()));
}

TEST(MeshFile, RefusesALabelOfAnotherChecksum)
{
    const TemporaryFolder folder;
    const auto file = folder / meshFile;
    writeMesh(OutputFolder(folder.path()), exampleMesh());
    std::string bytes = test::readBytes(file);
    bytes.resize(bytes.size() - sizeof(hdf5::Seal));
    bytes.back() = bytes.back() == '0' ? '1' : '0'; // the last digit of the label
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(bytes)));
    const std::size_t labelLength = hdf5Label(file)->size();
    for (const std::byte one : hdf5::makeSeal(checksum.value(), labelLength)) bytes += char(one);
    test::writeBytes(file, bytes);

    try {
        readMesh(file);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("its label"), std::string::npos) << error.what();
    }
}
