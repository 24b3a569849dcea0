#include "io/VtkHdf.h"

#include "base/Error.h"
#include "base/Format.h"
#include "io/FrameLabel.h"
#include "io/Frames.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace fpm {
namespace {

constexpr std::uint8_t vtkHexahedron = 12;
constexpr std::size_t cornerCount = 8;
const std::string nodeIds = "/VTKHDF/PointData/NodeId", elementIds = "/VTKHDF/CellData/ElementId";
const std::string meshFile = "../constant/mesh.vtkhdf"; // seen from a time folder

void writeHeader(Hdf5Image& image)
{
    // VTK accepts neither variable-length nor UTF-8 text here, and no scalar counts.
    image.attribute("/VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
    image.attribute("/VTKHDF", "Type", "UnstructuredGrid");
}

template <class Number>
void writeTopology(Hdf5Image& image, std::span<const std::array<Index, 8>> hexahedra)
{
    std::vector<Number> connectivity, offsets{0};
    connectivity.reserve(cornerCount * hexahedra.size());
    offsets.reserve(hexahedra.size() + 1);
    for (const auto& hexahedron : hexahedra) {
        connectivity.insert(connectivity.end(), hexahedron.begin(), hexahedron.end());
        offsets.push_back(Number(connectivity.size()));
    }
    image.write("/VTKHDF/Connectivity", std::span<const Number>(connectivity));
    image.write("/VTKHDF/Offsets", std::span<const Number>(offsets));
}

void writeCount(Hdf5Image& image, const std::string& name, std::size_t count)
{
    image.write("/VTKHDF/" + name, std::array<std::int64_t, 1>{std::int64_t(count)});
}

void writeIds(Hdf5Image& image, const std::string& path, std::size_t count)
{
    std::vector<Index> ids(count);
    std::iota(ids.begin(), ids.end(), Index(0));
    image.write(path, std::span<const Index>(ids));
}

void writeFields(Hdf5Image& image,
                 const std::string& group,
                 const std::vector<ResultField>& fields,
                 std::size_t rows)
{
    for (const auto& field : fields) {
        if (field.values.size() != rows * field.columns)
            throw Error(ExitCode::internal,
                        format("result field {} has {} values, not {} rows of {}", field.name,
                               field.values.size(), rows, field.columns));
        const std::vector<float> values(field.values.begin(), field.values.end());
        image.write(group + "/" + field.name, std::span<const float>(values), field.columns);
    }
}

std::vector<ResultField>
readFields(const Hdf5Reader& reader, const std::string& group, std::size_t rows)
{
    std::vector<ResultField> fields;
    if (!reader.has(group)) return fields;
    for (const auto& name : reader.children(group)) {
        const std::string path = group + "/" + name;
        ResultField field{name, reader.columns(path), reader.doubles(path)};
        if (field.columns == 0 || field.values.size() / field.columns != rows
            || field.values.size() % field.columns != 0)
            throw Error(
                ExitCode::mesh,
                format("'{}': {} does not have {} rows", reader.file().string(), path, rows),
                "the frame is damaged; run the solver again for this time");
        fields.push_back(std::move(field));
    }
    return fields;
}

[[noreturn]] void refuseFrame(const Hdf5Reader& reader, const std::string& reason)
{
    throw Error(ExitCode::mesh, format("frame '{}' {}", reader.file().string(), reason),
                "run fpmExplicit again");
}

/// The label is what decides which frames are of a run and its mesh.
void requireLabel(const Hdf5Reader& reader, const Frame& frame)
{
    if (reader.label().empty()) return; // of an older version
    const FrameLabel label = parseFrameLabel(reader.label());
    if (!label.mark || label.mark->runId != frame.runId || label.mesh != frame.meshChecksum)
        refuseFrame(reader, "names another run or mesh behind its content than in it");
}

void requireMesh(const Hdf5Reader& reader, const Frame& frame, const FrameMesh& mesh)
{
    const auto counts = [&](const std::string& name, std::size_t expected) {
        const auto values = reader.integers("/fpm", name);
        return values.size() == 1 && values.front() >= 0 && std::size_t(values.front()) == expected;
    };
    if (frame.meshChecksum != mesh.checksum || !counts("nodeCount", mesh.nodeCount)
        || !counts("elementCount", mesh.elementCount))
        refuseFrame(reader, "belongs to another mesh than this case has");
}

} // namespace

void writeGrid(Hdf5Image& image,
               std::span<const Point> points,
               std::span<const std::array<Index, 8>> hexahedra)
{
    writeHeader(image);
    writeCount(image, "NumberOfPoints", points.size());
    writeCount(image, "NumberOfCells", hexahedra.size());
    writeCount(image, "NumberOfConnectivityIds", cornerCount * hexahedra.size());
    const double* coordinates = points.empty() ? nullptr : points.front().data();
    image.write("/VTKHDF/Points", std::span(coordinates, 3 * points.size()), 3);
    if (cornerCount * hexahedra.size() <= std::size_t(std::numeric_limits<std::int32_t>::max()))
        writeTopology<std::int32_t>(image, hexahedra);
    else
        writeTopology<std::int64_t>(image, hexahedra);
    const std::vector<std::uint8_t> types(hexahedra.size(), vtkHexahedron);
    image.write("/VTKHDF/Types", std::span<const std::uint8_t>(types));
    writeIds(image, nodeIds, points.size());
    writeIds(image, elementIds, hexahedra.size());
}

void writeFrame(const OutputFolder& theCase,
                const std::string& timeName,
                const Frame& frame,
                std::size_t nodeCount,
                std::size_t elementCount)
{
    Hdf5Image image;
    writeHeader(image);
    for (const std::string name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds",
                                   "Points", "Connectivity", "Offsets", "Types"})
        image.link("/VTKHDF/" + name, meshFile, "/VTKHDF/" + name);
    writeFields(image, "/VTKHDF/PointData", frame.nodeFields, nodeCount);
    writeFields(image, "/VTKHDF/CellData", frame.elementFields, elementCount);
    if (meshHasIds(theCase.path()))
        for (const std::string& path : {nodeIds, elementIds}) image.link(path, meshFile, path);
    image.write("/VTKHDF/FieldData/TimeValue", std::array<double, 1>{frame.time});
    image.attribute("/fpm", "TimeValue", frame.time);
    image.attribute("/fpm", "nodeCount", std::array<std::int64_t, 1>{std::int64_t(nodeCount)});
    image.attribute("/fpm", "elementCount",
                    std::array<std::int64_t, 1>{std::int64_t(elementCount)});
    const std::string file = timeName + "/fields.vtkhdf";
    const FrameLabel label{
        RunMark{frame.runId, file},
        frame.meshChecksum.empty() ? meshChecksumOf(theCase.path()) : frame.meshChecksum, false};
    image.attribute("/fpm", "meshChecksum", label.mesh);
    image.attribute("/fpm", "runId", frame.runId);
    image.save(theCase, file, label.text());
}

Frame readFrame(const std::filesystem::path& file, const FrameMesh& mesh)
{
    const Hdf5Reader reader(file);
    Frame frame;
    frame.time = reader.number("/fpm", "TimeValue");
    frame.meshChecksum = reader.text("/fpm", "meshChecksum");
    if (reader.hasAttribute("/fpm", "runId")) frame.runId = reader.text("/fpm", "runId");
    requireLabel(reader, frame);
    requireMesh(reader, frame, mesh);
    frame.nodeFields = readFields(reader, "/VTKHDF/PointData", mesh.nodeCount);
    frame.elementFields = readFields(reader, "/VTKHDF/CellData", mesh.elementCount);
    return frame;
}

} // namespace fpm
