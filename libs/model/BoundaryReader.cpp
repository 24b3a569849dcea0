#include "model/BoundaryReader.h"

#include "base/Format.h"
#include "mesh/Surface.h"
#include "model/Names.h"
#include "model/PointAlgebra.h"

#include <algorithm>

namespace fpm {

namespace {

const std::vector<std::string> axes{"x", "y", "z"};

std::size_t axisOf(const std::string& name)
{
    return std::size_t(std::find(axes.begin(), axes.end(), name) - axes.begin());
}

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

std::array<bool, 3> readComponents(const Dictionary& entry)
{
    if (!entry.has("components")) return {true, true, true};
    std::array<bool, 3> components{false, false, false};
    for (const std::string& word : entry.words("components")) {
        const std::size_t axis = axisOf(word);
        if (axis == 3)
            entry.fail("components", "unknown component '" + word + "'", "valid: x, y, z");
        if (components[axis]) entry.fail("components", "component '" + word + "' is given twice");
        components[axis] = true;
    }
    if (components == std::array{false, false, false})
        entry.fail("components", "no component is given", "leave the entry out for all three");
    return components;
}

BoundaryCondition::Kind kindOf(const std::string& type)
{
    using Kind = BoundaryCondition::Kind;
    if (type == "velocity") return Kind::velocity;
    if (type == "displacement") return Kind::displacement;
    if (type == "force") return Kind::force;
    return Kind::fixed; // also symmetry: its normal component held
}

BoundaryCondition readCondition(const Dictionary& entry, const std::string& name, const Mesh& mesh)
{
    const std::string type =
        entry.choice("type", {"fixed", "symmetry", "velocity", "displacement", "force"});
    BoundaryCondition condition;
    condition.name = name;
    condition.kind = kindOf(type);
    condition.nodes = selectNodes(entry, mesh);
    if (type == "symmetry") {
        condition.constrains[axisOf(entry.choice("normal", axes))] = true;
        return condition;
    }
    condition.constrains = readComponents(entry);
    if (type == "fixed") return condition;

    condition.value = entry.vector("value");
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!condition.constrains[axis] && condition.value[axis] != 0)
            entry.fail("value",
                       "component " + axes[axis] + " has the value "
                           + toText(condition.value[axis], 6) + " but is not in 'components'",
                       "add " + axes[axis] + " to components, or give it the value 0");
    condition.amplitude = readAmplitude(entry);
    if (condition.kind == BoundaryCondition::Kind::displacement)
        refuseJump(entry, "value", condition.amplitude(0) * length(condition.value));
    return condition;
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

Amplitude readAmplitude(const Dictionary& entry)
{
    Amplitude amplitude;
    if (!entry.has("amplitude")) return amplitude;
    const std::string word = entry.leadingWord("amplitude");
    if (word == "constant") return amplitude;
    if (word != "table" && word != "smooth")
        entry.fail("amplitude", "unknown amplitude '" + word + "'",
                   nameAdvice(word, {"constant", "table", "smooth"}, "valid"));

    amplitude.kind = word == "table" ? Amplitude::Kind::table : Amplitude::Kind::smooth;
    amplitude.rows.clear();
    for (const auto& row : entry.tailRows("amplitude", 2)) {
        if (!amplitude.rows.empty() && row[0] <= amplitude.rows.back()[0])
            entry.fail("amplitude", "times must ascend: " + toText(row[0], 6) + " follows "
                                        + toText(amplitude.rows.back()[0], 6));
        amplitude.rows.push_back({row[0], row[1]});
    }
    if (amplitude.rows.size() < 2)
        entry.fail("amplitude", word + " needs at least two rows (time factor)",
                   "such as: amplitude " + word + " ((0 0) (1e-3 1));");
    return amplitude;
}

void refuseJump(const Dictionary& entry, const std::string& key, double start)
{
    if (start != 0)
        entry.fail(entry.has("amplitude") ? "amplitude" : key,
                   "the displacement would jump by " + toText(start, 6) + " at time 0",
                   "let it grow from 0, such as: amplitude smooth ((0 0) (1e-3 1));");
}

std::vector<BoundaryCondition> readBoundaryConditions(const Dictionary& dictionary,
                                                      const Mesh& mesh)
{
    std::vector<BoundaryCondition> conditions;
    for (const std::string& name : dictionary.keys())
        conditions.push_back(readCondition(dictionary.sub(name), name, mesh));
    dictionary.requireAllUsed();
    return conditions;
}

std::vector<InitialVelocity> readInitialVelocities(const Dictionary& dictionary, const Mesh& mesh)
{
    std::vector<InitialVelocity> velocities;
    std::vector<int> giver(mesh.points.size(), -1);
    for (const std::string& name : dictionary.keys()) {
        const Dictionary entry = dictionary.sub(name);
        entry.choice("type", {"velocity"});
        const int number = int(velocities.size());
        velocities.push_back({name, selectNodes(entry, mesh), entry.vector("value")});
        for (const Index node : velocities.back().nodes) {
            int& earlier = giver[std::size_t(node)];
            if (earlier >= 0
                && velocities[std::size_t(earlier)].velocity != velocities.back().velocity)
                entry.fail("value",
                           format("node {} already has another velocity from '{}'", node,
                                  velocities[std::size_t(earlier)].name),
                           "let the two entries address different nodes");
            earlier = number;
        }
    }
    dictionary.requireAllUsed();
    return velocities;
}

} // namespace fpm
