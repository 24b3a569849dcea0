#include "mesher/Bodies.h"

#include "base/Error.h"
#include "base/Format.h"
#include "mesh/Patches.h"
#include "mesh/Quality.h"
#include "mesher/FileBody.h"
#include "mesher/MeshReport.h"

#include <unistd.h>

#include <algorithm>

namespace fpm {

namespace {

Bodies::Entry readEntry(const std::string& name, const Dictionary& entry, int refinement)
{
    const std::string type =
        entry.choice("type", {"box", "layers", "cylinder", "hollowCylinder", "file"});
    if (type == "box") return {name, {readBox(name, entry, refinement)}, ""};
    if (type == "layers") return {name, readLayers(name, entry, refinement), ""};
    if (type == "cylinder") return {name, {readCylinder(name, entry, refinement)}, ""};
    if (type == "hollowCylinder") return {name, {readHollowCylinder(name, entry, refinement)}, ""};
    const std::string file = entry.word("file");
    if (file.empty()) entry.fail("file", "'file' must name a .msh file, found \"\"");
    if (refinement > 1)
        entry.fail("file",
                   format("a mesh file cannot be refined, and 'refinement' is {}", refinement),
                   "make a finer file, or leave out 'refinement'");
    return {name, {}, file};
}

/// Refuses what cannot fit before gmsh starts, with the figures.
void requireMemory(const Bodies& bodies)
{
    constexpr double bytesPerElement = 800; // gmsh 560, our mesh and its numbering the rest
    std::int64_t elements = 0;
    for (const auto& entry : bodies.entries)
        for (const auto& shape : entry.shapes) elements += shape.cellCount;
    if (elements > std::int64_t(maxElements))
        throw Error(ExitCode::mesh,
                    format("{} elements in all; at most {} can be numbered", elements, maxElements),
                    "use fewer cells");
    const double machine = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
    const double needed = bytesPerElement * double(elements);
    if (needed > machine)
        throw Error(ExitCode::memory,
                    format("{} elements need about {} GB to mesh; this machine has {} GB", elements,
                           needed / 1e9, machine / 1e9),
                    "use fewer cells");
}

template <class Set>
void moveSets(std::map<std::string, Set>& from, Mesh& total, std::map<std::string, Set>& to)
{
    for (auto& [name, set] : from) {
        if (total.nodeSets.contains(name) || total.sideSets.contains(name))
            throw Error(ExitCode::mesh, format("two sets are called '{}'", name),
                        "rename the body or the physical group");
        to[name] = std::move(set);
    }
}

/// Adds a body behind the others; it keeps its own nodes.
void append(Mesh& total, Mesh body)
{
    const auto firstNode = Index(total.points.size());
    const auto firstElement = Index(total.hexahedra.size());
    for (auto& part : body.parts) {
        if (total.findPart(part.name) >= 0)
            throw Error(ExitCode::mesh, format("two parts are called '{}'", part.name),
                        "rename the body, or the physical volume of the file");
        part.firstElement += firstElement;
        total.parts.push_back(part);
    }
    for (auto& cell : body.hexahedra)
        for (Index& node : cell) node += firstNode;
    for (auto& [name, nodes] : body.nodeSets)
        for (Index& node : nodes) node += firstNode;
    for (auto& [name, sides] : body.sideSets)
        for (ElementSide& side : sides) side.element += firstElement;
    total.points.insert(total.points.end(), body.points.begin(), body.points.end());
    total.hexahedra.insert(total.hexahedra.end(), body.hexahedra.begin(), body.hexahedra.end());
    moveSets(body.nodeSets, total, total.nodeSets);
    moveSets(body.sideSets, total, total.sideSets);
}

Mesh readFile(const Bodies::Entry& entry, const Case& theCase, bool allowGeo, Log& log)
{
    const auto imported = importMesh(theCase.inside(entry.file), entry.file, allowGeo);
    for (const auto& line : imported.warnings)
        log.warning(format("{}: gmsh: {}", entry.file, line));
    return fileBody(entry.name, entry.file, imported);
}

} // namespace

Bodies Bodies::read(const Dictionary& bodies, int refinement)
{
    Bodies read;
    for (const auto& name : bodies.keys()) {
        if (!isName(name))
            bodies.fail(name, format("'{}' cannot name a part: expected {}", name, nameRule));
        read.entries.push_back(readEntry(name, bodies.sub(name), refinement));
    }
    return read;
}

MeshedBodies meshBodies(const Bodies& bodies, const Case& theCase, bool allowGeo, Log& log)
{
    requireMemory(bodies);
    MeshedBodies result;
    MeshReport report(log);
    const auto add = [&](const std::string& entry, const std::string& source, Mesh body,
                         double roundVolume) {
        checkMesh(body, source, log);
        report.add(body, roundVolume);
        for (const auto& part : body.parts) result.partsOfEntry[entry].push_back(part.name);
        append(result.mesh, std::move(body));
    };
    for (const auto& entry : bodies.entries) {
        for (const auto& shape : entry.shapes)
            add(entry.name, shape.subject, meshShape(shape, log), shape.roundVolume);
        if (!entry.file.empty())
            add(entry.name, entry.file, readFile(entry, theCase, allowGeo, log), 0);
    }
    report.total();
    return result;
}

} // namespace fpm
