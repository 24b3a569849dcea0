#include "model/NodeSelection.h"

#include "mesh/Surface.h"
#include "model/Names.h"
#include "model/PointAlgebra.h"

#include <algorithm>

namespace fpm {

namespace {

std::vector<Index> nodesOfSet(const Dictionary& entry, const Mesh& mesh)
{
    const std::string name = entry.word("set");
    std::vector<Index> nodes;
    if (const auto found = mesh.nodeSets.find(name); found != mesh.nodeSets.end()) {
        nodes = found->second;
    } else if (const auto sides = mesh.sideSets.find(name); sides != mesh.sideSets.end()) {
        nodes = nodesOf(mesh, sides->second);
    } else {
        std::vector<std::string> names = keysOf(mesh.nodeSets);
        for (const std::string& side : keysOf(mesh.sideSets)) names.push_back(side);
        entry.fail("set", "the mesh has no set '" + name + "'",
                   nameAdvice(name, names, "sets of the mesh"));
    }
    if (nodes.empty())
        entry.fail("set", "set '" + name + "' is empty", "change it in system/meshDict");
    return nodes;
}

} // namespace

std::vector<Index> nodesOfPart(const Mesh& mesh, Index part)
{
    const MeshPart& run = mesh.parts[std::size_t(part)];
    std::vector<Index> nodes;
    nodes.reserve(std::size_t(run.elementCount) * 8);
    for (Index element = run.firstElement; element < run.firstElement + run.elementCount; ++element)
        for (const Index node : mesh.hexahedra[std::size_t(element)]) nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

std::vector<Index> nodesOfNamedPart(const Dictionary& entry, const Mesh& mesh)
{
    const std::string name = entry.word("part");
    const Index part = mesh.findPart(name);
    if (part >= 0) return nodesOfPart(mesh, part);
    std::vector<std::string> names;
    for (const MeshPart& candidate : mesh.parts) names.push_back(candidate.name);
    entry.fail("part", "the mesh has no part '" + name + "'",
               nameAdvice(name, names, "parts of the mesh"));
}

std::vector<Index> selectNodes(const Dictionary& entry, const Mesh& mesh)
{
    const bool bySet = entry.has("set");
    const bool byPart = entry.has("part");
    if (bySet && byPart)
        entry.fail("part", "both 'set' and 'part' are given", "keep the one that is meant");
    if (!bySet && !byPart)
        entry.fail("set", "no nodes are named", "add 'set <set of the mesh>;' or 'part <part>;'");
    return bySet ? nodesOfSet(entry, mesh) : nodesOfNamedPart(entry, mesh);
}

std::vector<ElementSide> selectSides(const Dictionary& entry, const Mesh& mesh)
{
    const std::string name = entry.word("set");
    const auto sides = mesh.sideSets.find(name);
    if (sides != mesh.sideSets.end()) return sides->second;
    entry.fail("set",
               mesh.nodeSets.count(name) ? "'" + name + "' is a set of nodes: it has no area"
                                         : "the mesh has no side set '" + name + "'",
               nameAdvice(name, keysOf(mesh.sideSets), "side sets of the mesh"));
}

void refuseInnerSides(const Dictionary& entry,
                      const std::string& key,
                      const Mesh& mesh,
                      const std::vector<ElementSide>& sides,
                      const std::string& use)
{
    const std::vector<ElementSide> inner = innerSides(mesh, sides);
    if (inner.empty()) return;
    entry.fail(
        key,
        format("{} of {} sides lie inside the material, such as that at {}: elements on "
               "both sides of it share its nodes, so it is no surface for {}",
               inner.size(), sides.size(), pointText(centre(mesh, inner.front())), use),
        "name a set on the outside; or, if two bodies shall meet there, give each nodes of "
        "its own when the mesh is made (in gmsh: no fragments, no merging of the interface)");
}

std::vector<Index> selectParts(const Dictionary& entry, const Mesh& mesh)
{
    std::vector<Index> parts;
    std::vector<std::string> names;
    for (const MeshPart& part : mesh.parts) names.push_back(part.name);
    for (const std::string& name : entry.has("parts") ? entry.words("parts") : names) {
        const Index part = mesh.findPart(name);
        if (part < 0)
            entry.fail("parts", "the mesh has no part '" + name + "'",
                       nameAdvice(name, names, "parts of the mesh"));
        if (std::find(parts.begin(), parts.end(), part) != parts.end())
            entry.fail("parts", "part '" + name + "' is given twice");
        parts.push_back(part);
    }
    if (parts.empty()) entry.fail("parts", "no part is given", "leave the entry out for all");
    return parts;
}

} // namespace fpm
