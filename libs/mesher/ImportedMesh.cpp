#include "mesher/ImportedMesh.h"

#include "base/Bytes.h"
#include "base/ChildProcess.h"
#include "base/Error.h"
#include "base/Format.h"
#include "mesher/MshText.h"

#include <gmsh.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace fpm {

namespace {

constexpr int quadrangleType = 3, quadrangleCorners = 4;

/// A file without name in memory. gmsh opens it by a path with neither extension nor neighbours: it
/// would otherwise also run "<file>.opt".
class MemoryFile
{
public:
    explicit MemoryFile(std::string_view content) : descriptor_(memfd_create("mesh", MFD_CLOEXEC))
    {
        for (std::size_t done = 0; descriptor_ >= 0 && done < content.size();) {
            const ssize_t count = write(descriptor_, content.data() + done, content.size() - done);
            if (count <= 0) throw Error(ExitCode::memory, "no memory for a copy of the mesh file");
            done += std::size_t(count);
        }
        if (descriptor_ < 0) throw Error(ExitCode::memory, "no memory file for the mesh");
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

std::string contentOf(const std::filesystem::path& file, const std::string& name)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        throw Error(ExitCode::mesh, format("{}: no such file", name));
    if (!std::filesystem::is_regular_file(file, error))
        throw Error(ExitCode::mesh, format("{}: is not a regular file", name));
    constexpr std::uintmax_t most = std::uintmax_t(1) << 33;
    if (const auto size = std::filesystem::file_size(file, error); error || size > most)
        throw Error(ExitCode::mesh,
                    format("{}: has {} bytes; at most {} are read", name, size, most));
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    if (!stream) throw Error(ExitCode::mesh, format("{}: cannot be read, or is empty", name));
    return content.str();
}

/// Without control characters and bytes beyond ASCII: the file must not write to the terminal.
std::string printable(std::string text)
{
    for (char& letter : text)
        if (letter < ' ' || letter > '~') letter = '?';
    return text;
}

/// Our numbers for the tags of the file called `name`.
struct Numbering {
    std::string name;
    TagMap nodes, cells;

    Index node(std::size_t tag, const PhysicalGroup& group) const
    {
        const Index number = nodes.find(tag);
        if (number < 0)
            throw Error(ExitCode::mesh,
                        format("{}: node {} of physical group {} '{}' belongs to no hexahedron",
                               name, tag, group.tag, group.name),
                        "are the nodes of the group and of the volume one and the same?");
        return number;
    }
};

void fetchQuads(PhysicalGroup& group, int entity, const Numbering& numbering)
{
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, corners;
    gmsh::model::mesh::getElements(types, elements, corners, 2, entity);
    for (std::size_t kind = 0; kind < types.size(); ++kind) {
        if (types[kind] != quadrangleType)
            throw Error(ExitCode::mesh,
                        format("{}: physical surface {} '{}' has faces other than 4-node "
                               "quadrangles",
                               numbering.name, group.tag, group.name),
                        "recombine the surface");
        for (std::size_t face = 0; face < elements[kind].size(); ++face) {
            Quad quad;
            for (int corner = 0; corner < quadrangleCorners; ++corner)
                quad[corner] =
                    numbering.node(corners[kind][quadrangleCorners * face + corner], group);
            group.quads.push_back(quad);
        }
    }
}

PhysicalGroup fetchGroup(int dimension, int tag, const Numbering& numbering)
{
    PhysicalGroup group{dimension, tag, {}, {}, {}, {}};
    gmsh::model::getPhysicalName(dimension, tag, group.name);
    group.name = printable(group.name);
    if (dimension < 2) {
        std::vector<std::size_t> tags;
        std::vector<double> coordinates;
        gmsh::model::mesh::getNodesForPhysicalGroup(dimension, tag, tags, coordinates);
        for (const auto node : tags) group.nodes.push_back(numbering.node(node, group));
        return group;
    }
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
    for (const int entity : entities) {
        if (dimension == 2) {
            fetchQuads(group, entity, numbering);
            continue;
        }
        std::vector<int> types;
        std::vector<std::vector<std::size_t>> elements, corners;
        gmsh::model::mesh::getElements(types, elements, corners, 3, entity);
        for (const auto& kind : elements)
            for (const auto element : kind) group.cells.push_back(numbering.cells.find(element));
    }
    return group;
}

/// In the child: everything of the current gmsh model that is wanted, as bytes.
void packModel(const std::string& name, ByteWriter& bytes)
{
    Numbering numbering{name, {}, {}};
    std::string foreign;
    const Hexahedra mesh = fetchHexahedra(numbering.nodes, numbering.cells, foreign);
    bytes.put(foreign);
    bytes.put(mesh.points);
    bytes.put(mesh.cells);
    std::vector<std::int64_t> tags;
    for (Index cell = 0; cell < Index(mesh.cells.size()); ++cell)
        tags.push_back(std::int64_t(numbering.cells.tag(cell)));
    bytes.put(tags);

    gmsh::vectorpair groups;
    if (foreign.empty() && !mesh.cells.empty()) gmsh::model::getPhysicalGroups(groups);
    bytes.put(std::int64_t(groups.size()));
    for (const auto& [dimension, tag] : groups) {
        const auto group = fetchGroup(dimension, tag, numbering);
        bytes.put(group.dimension);
        bytes.put(group.tag);
        bytes.put(group.name);
        bytes.put(group.cells);
        bytes.put(group.quads);
        bytes.put(group.nodes);
    }
}

/// In the child: reads `path`, meshing it first where it is a geometry. What gmsh says about a file
/// that a stranger wrote is made printable, and names the file by its own name.
std::string readInGmsh(const std::string& name, const std::string& path, bool isGeo)
{
    ByteWriter bytes;
    const auto cleaned = [&](std::string text) {
        for (auto at = text.find(path); at != std::string::npos; at = text.find(path, at))
            text.replace(at, path.size(), "the file");
        return printable(std::move(text));
    };
    try {
        const auto warnings = withGmsh(name, [&] {
            gmsh::open(path);
            if (isGeo) gmsh::model::mesh::generate(3);
            packModel(name, bytes);
        });
        bytes.put(std::int64_t(warnings.size()));
        for (const auto& line : warnings) bytes.put(cleaned(line));
    } catch (const Error& error) {
        throw Error(error.code(), cleaned(error.what()),
                    error.advice().empty() ? "export it again: gmsh -format msh41"
                                           : error.advice());
    }
    return bytes.take();
}

ImportedMesh unpack(const std::string& answer, const std::string& name)
{
    ByteReader bytes(answer, name);
    const std::string foreign = bytes.text();
    ImportedMesh mesh;
    mesh.hexahedra.points = bytes.vector<Point>();
    mesh.hexahedra.cells = bytes.vector<Hexahedron>();
    mesh.cellTags = bytes.vector<std::int64_t>();
    if (!foreign.empty())
        throw Error(
            ExitCode::mesh,
            format("{}: only 8-node hexahedra can be used, but it also has {}", name, foreign),
            "mesh the volumes with hexahedra only: transfinite, or extruded and recombined");
    if (mesh.hexahedra.cells.empty())
        throw Error(ExitCode::mesh, format("{}: has no hexahedra", name),
                    "if it has physical groups, the volumes must be in one, or they are not saved");
    for (auto left = bytes.number(); left > 0; --left) {
        PhysicalGroup group{bytes.number(), bytes.number(), bytes.text(), {}, {}, {}};
        group.cells = bytes.vector<Index>();
        group.quads = bytes.vector<Quad>();
        group.nodes = bytes.vector<Index>();
        mesh.groups.push_back(std::move(group));
    }
    for (auto left = bytes.number(); left > 0; --left) mesh.warnings.push_back(bytes.text());
    return mesh;
}

} // namespace

ImportedMesh importMesh(const std::filesystem::path& file, const std::string& name, bool allowGeo)
{
    const std::string content = contentOf(file, name);
    const bool isGeo = file.extension() == ".geo";
    if (isGeo && !allowGeo)
        throw Error(ExitCode::mesh, format("{}: a .geo file is a program and is not run", name),
                    "if you trust it, give option -allowGeo; or make the .msh: gmsh -3 " + name);
    if (!isGeo && file.extension() != ".msh")
        throw Error(ExitCode::mesh,
                    format("{}: expected a file with extension .msh (or .geo)", name));
    if (!isGeo) checkMshText(name, content);

    // Generous for an honest file: gmsh takes about 700 bytes and 3 microseconds a hexahedron.
    ChildTask task{name, ExitCode::mesh, "export the file again: gmsh -format msh41"};
    if (!isGeo) {
        task.memoryBytes = (std::uint64_t(2) << 30) + 64 * content.size();
        task.cpuSeconds = 60 + content.size() / 1'000'000;
    }
    const auto answer = inChild(task, [&] {
        const MemoryFile copy(isGeo ? "" : content);
        return readInGmsh(name, isGeo ? file.string() : copy.path(), isGeo);
    });
    return unpack(answer, name);
}

} // namespace fpm
