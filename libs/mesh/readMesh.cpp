#include "base/Error.h"
#include "base/Format.h"
#include "io/FrameLabel.h"
#include "io/Hdf5File.h"
#include "mesh/MeshFile.h"
#include "mesh/Patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fpm {
namespace {

constexpr std::int64_t newestVersion = 1;
constexpr double maxCoordinate = 1e15;

/// Turns the arrays of one file into a mesh in which every number points at something.
class MeshReader
{
public:
    explicit MeshReader(const std::filesystem::path& file) : reader_(file) {}

    Mesh read()
    {
        requireVersion();
        readGrid();
        readParts();
        readPatches();
        for (const auto& name : children("/fpm/nodeSets"))
            mesh_.nodeSets[name] = nodes("/fpm/nodeSets/" + name);
        for (const auto& name : children("/fpm/sideSets"))
            mesh_.sideSets[name] = sides("/fpm/sideSets/" + name);
        readContact();
        const std::string checksum = meshChecksum(mesh_);
        if (reader_.text("/fpm", "meshChecksum") != checksum)
            fail("the checksum of its arrays does not match");
        // Frames are compared with the label. Files of older versions have none.
        if (!reader_.label().empty() && parseFrameLabel(reader_.label()).mesh != checksum)
            fail("its label names another checksum than that of its arrays");
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const std::string& reason) const
    {
        throw Error(ExitCode::mesh,
                    "cannot use the mesh '" + reader_.file().string() + "': " + reason,
                    "make it again with fpmMesh");
    }

    void requireVersion() const
    {
        const auto version = reader_.integers("/fpm", "version");
        if (version.size() != 1 || version.front() < 1 || version.front() > newestVersion)
            fail(format("its format is not version {}", newestVersion));
    }

    std::vector<std::string> children(const std::string& group) const
    {
        return reader_.has(group) ? reader_.children(group) : std::vector<std::string>();
    }

    /// Whole numbers from 0 to limit - 1; throws naming the first 10 that are not.
    std::vector<Index>
    numbers(const std::string& path, std::size_t columns, std::int64_t limit) const
    {
        if (reader_.columns(path) != columns) fail(format("{} has not {} columns", path, columns));
        const auto values = reader_.integers(path);
        std::vector<Index> result;
        result.reserve(values.size());
        std::string offenders;
        int count = 0;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const bool good = values[k] >= 0 && values[k] < limit;
            if (!good && ++count <= 10) offenders += format(" [{}] {}", k, values[k]);
            result.push_back(good ? Index(values[k]) : 0);
        }
        if (count > 0)
            fail(format("{} numbers of {} are not below {}:{}", count, path, limit, offenders));
        return result;
    }

    void requireCount(const std::string& name, std::size_t count) const
    {
        const auto values = reader_.integers("/VTKHDF/" + name);
        if (values.size() != 1 || values.front() < 0 || std::size_t(values.front()) != count)
            fail(format("{} says something else than the {} there are", name, count));
    }

    void readGrid()
    {
        if (reader_.columns("/VTKHDF/Points") != 3) fail("Points has not 3 columns");
        const auto coordinates = reader_.doubles("/VTKHDF/Points");
        const std::size_t nodeCount = coordinates.size() / 3;
        requireCount("NumberOfPoints", nodeCount);
        if (nodeCount > std::size_t(std::numeric_limits<Index>::max())) fail("too many nodes");
        mesh_.points.resize(nodeCount);
        for (std::size_t node = 0; node < nodeCount; ++node)
            for (std::size_t k = 0; k < 3; ++k) {
                const double coordinate = coordinates[3 * node + k];
                if (!(std::abs(coordinate) <= maxCoordinate))
                    fail(format("node {} has the coordinate {}", node, coordinate));
                mesh_.points[node][k] = coordinate;
            }
        const auto corners = numbers("/VTKHDF/Connectivity", 1, std::int64_t(nodeCount));
        requireCount("NumberOfConnectivityIds", corners.size());
        requireCount("NumberOfCells", corners.size() / 8);
        if (corners.size() / 8 > maxElements)
            fail(
                format("{} elements; at most {} can be numbered", corners.size() / 8, maxElements));
        if (corners.size() % 8 != 0)
            fail(format("{} corners are not those of 8-node elements", corners.size()));
        mesh_.hexahedra.resize(corners.size() / 8);
        for (std::size_t k = 0; k < corners.size(); ++k) mesh_.hexahedra[k / 8][k % 8] = corners[k];
    }

    std::int64_t elementCount() const { return std::int64_t(mesh_.hexahedra.size()); }

    void readParts()
    {
        const auto names = children("/fpm/parts");
        mesh_.parts.resize(names.size());
        for (const auto& name : names) {
            const auto values = numbers("/fpm/parts/" + name, 1, elementCount() + 1);
            if (values.size() != 3 || std::size_t(values[0]) >= names.size())
                fail("part " + name + " is not described by number, first element and count");
            mesh_.parts[std::size_t(values[0])] = {name, values[1], values[2]};
        }
        std::int64_t next = 0;
        for (const auto& part : mesh_.parts) {
            if (part.name.empty() || part.firstElement != next)
                fail("its parts have gaps or overlap");
            next += part.elementCount;
        }
        if (next != elementCount()) fail("its parts do not hold all elements");
    }

    void readPatches()
    {
        mesh_.patchStarts = numbers("/fpm/patchStarts", 1, elementCount() + 1);
        const auto& starts = mesh_.patchStarts;
        if (starts.empty() || starts.front() != 0 || starts.back() != elementCount())
            fail("its patches do not hold all elements");
        for (std::size_t patch = 0; patch + 1 < starts.size(); ++patch) {
            const Index count = starts[patch + 1] - starts[patch];
            if (count < 1 || count > maxPatchElements
                || mesh_.partOf(starts[patch]) != mesh_.partOf(starts[patch + 1] - 1))
                fail(format("patch {} is not 1 to {} elements of one part", patch,
                            maxPatchElements));
        }
    }

    std::vector<Index> nodes(const std::string& path) const
    {
        auto list = numbers(path, 1, std::int64_t(mesh_.points.size()));
        if (std::ranges::adjacent_find(list, std::greater_equal()) != list.end())
            fail(path + " does not ascend");
        return list;
    }

    std::vector<ElementSide> sides(const std::string& path) const
    {
        const auto values = numbers(path, 2, std::max<std::int64_t>(elementCount(), 6));
        std::vector<ElementSide> list;
        for (std::size_t k = 0; k < values.size(); k += 2) {
            if (values[k] >= elementCount() || values[k + 1] >= 6)
                fail(format("{}: there is no side {} of element {}", path, values[k + 1],
                            values[k]));
            list.push_back({values[k], values[k + 1]});
        }
        if (std::ranges::adjacent_find(list, std::greater_equal()) != list.end())
            fail(path + " does not ascend");
        return list;
    }

    void readContact()
    {
        mesh_.contactKey = reader_.text("/fpm/contact", "key");
        const auto names = children("/fpm/contact");
        mesh_.contact.resize(names.size());
        for (const auto& name : names) {
            const std::string group = "/fpm/contact/" + name;
            const auto order = reader_.integers(group, "order");
            if (order.size() != 1 || order[0] < 0 || std::size_t(order[0]) >= names.size()
                || !mesh_.contact[std::size_t(order[0])].pair.empty())
                fail("the order of contact pair " + name + " is unclear");
            mesh_.contact[std::size_t(order[0])] = {name, nodes(group + "/contactorNodes"),
                                                    sides(group + "/contactorSides"),
                                                    sides(group + "/targetSides")};
        }
    }

    Hdf5Reader reader_;
    Mesh mesh_;
};

} // namespace

Mesh readMesh(const std::filesystem::path& file)
{
    if (!std::filesystem::exists(file))
        throw Error(ExitCode::mesh, "there is no mesh file '" + file.string() + "'",
                    "run fpmMesh first");
    return MeshReader(file).read();
}

} // namespace fpm
