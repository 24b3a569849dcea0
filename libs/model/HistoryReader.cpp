#include "base/Format.h"
#include "model/BoundaryReader.h"
#include "model/ControlReader.h"
#include "model/Names.h"
#include "model/PointAlgebra.h"

#include <algorithm>
#include <limits>
#include <set>

namespace fpm {

namespace {

Index nearestNode(const Mesh& mesh, const std::vector<Index>& nodes, const Point& position)
{
    Index nearest = nodes.front();
    double best = std::numeric_limits<double>::infinity();
    for (const Index node : nodes) {
        const Point offset = difference(mesh.points[std::size_t(node)], position);
        if (const double square = dot(offset, offset); square < best) {
            best = square;
            nearest = node;
        }
    }
    return nearest;
}

/// The longest edge that meets the node.
double elementSizeAt(const Mesh& mesh, Index part, Index node)
{
    constexpr int edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                  {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
    const MeshPart& run = mesh.parts[std::size_t(part)];
    double longest = 0;
    for (Index element = run.firstElement; element < run.firstElement + run.elementCount;
         ++element) {
        const Hexahedron& corners = mesh.hexahedra[std::size_t(element)];
        if (std::find(corners.begin(), corners.end(), node) == corners.end()) continue;
        for (const auto& edge : edges) {
            const Index a = corners[std::size_t(edge[0])], b = corners[std::size_t(edge[1])];
            if (a == node || b == node)
                longest = std::max(longest, length(difference(mesh.points[std::size_t(a)],
                                                              mesh.points[std::size_t(b)])));
        }
    }
    return longest;
}

void readPoint(const Dictionary& entry, const Mesh& mesh, History& history, Log& log)
{
    const std::vector<Index> nodes = nodesOfNamedPart(entry, mesh);
    const Point position = entry.vector("position");
    history.node = nearestNode(mesh, nodes, position);
    const Point& chosen = mesh.points[std::size_t(history.node)];
    const double distance = length(difference(chosen, position));
    const double size = elementSizeAt(mesh, mesh.findPart(entry.word("part")), history.node);
    log.line(format("history {}: node {} at {}, {} from the requested position", history.name,
                    history.node, pointText(chosen), distance));
    if (distance > size)
        log.warning(
            format("history {}: the nearest node of part '{}' lies {} from {}, more than an "
                   "element ({})",
                   history.name, entry.word("part"), distance, pointText(position), size));

    if (!entry.has("fields")) return;
    const std::vector<std::string> valid{"displacement", "velocity", "acceleration"};
    history.fields = entry.words("fields");
    std::set<std::string> seen;
    for (const std::string& field : history.fields) {
        if (std::find(valid.begin(), valid.end(), field) == valid.end())
            entry.fail("fields", "unknown field '" + field + "' of a point",
                       nameAdvice(field, valid, "valid"));
        if (!seen.insert(field).second)
            entry.fail("fields", "field '" + field + "' is given twice");
    }
    if (history.fields.empty()) entry.fail("fields", "no field is given");
}

void readReactionOfSurface(const Dictionary& entry, const Model& model, History& history)
{
    const std::string name = entry.word("surface");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < model.rigidSurfaces.size(); ++i) {
        names.push_back(model.rigidSurfaces[i].name);
        if (names.back() == name) history.surface = Index(i);
    }
    if (history.surface < 0)
        entry.fail("surface", "no analytic surface '" + name + "'",
                   nameAdvice(name, names, "surfaces with a type in system/contactDict"));
}

void readReaction(const Dictionary& entry, const Model& model, History& history)
{
    history.factor = entry.numberOr("factor", 1.0, positive());
    const bool ofSurface = entry.has("surface");
    if (ofSurface && entry.has("condition"))
        entry.fail("surface", "both 'condition' and 'surface' are given",
                   "keep the one that is meant");
    if (ofSurface) return readReactionOfSurface(entry, model, history);
    const std::string name = entry.word("condition");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < model.boundaryConditions.size(); ++i) {
        const BoundaryCondition& condition = model.boundaryConditions[i];
        names.push_back(condition.name);
        if (condition.name != name) continue;
        if (condition.isLoad())
            entry.fail("condition",
                       "'" + name + "' is a load; only what is held or driven has a reaction");
        history.nodes = condition.nodes;
        history.condition = Index(i);
        return;
    }
    entry.fail("condition", "no boundary condition '" + name + "'",
               nameAdvice(name, names, "conditions in constant/boundaryConditions"));
}

void readBody(const Dictionary& entry, const Model& model, History& history)
{
    nodesOfNamedPart(entry, model.mesh); // refuses an unknown part
    const std::string name = entry.word("part");
    history.part = model.mesh.findPart(name);
    if (model.parts[std::size_t(history.part)].kind != PartKind::rigidFree)
        entry.fail("part", "part '" + name + "' is not rigidFree",
                   "a reaction or a point shows how other parts move");
}

void readPart(const Dictionary& entry, const Model& model, History& history)
{
    nodesOfNamedPart(entry, model.mesh); // refuses an unknown part
    const std::string name = entry.word("part");
    history.part = model.mesh.findPart(name);
    if (model.parts[std::size_t(history.part)].kind == PartKind::rigidPrescribed)
        entry.fail("part", "part '" + name + "' is rigidPrescribed: no momentum drives it",
                   "a reaction gives the force on it, a point its motion");
}

/// The energy balance is kept in every run.
void addEnergies(std::vector<History>& histories)
{
    History energies;
    energies.name = "energies";
    for (const History& history : histories)
        if (history.kind == energies.kind || history.name == energies.name) return;
    histories.push_back(energies);
}

} // namespace

std::vector<History> readHistories(const Dictionary& dictionary, const Model& model, Log& log)
{
    std::vector<History> histories;
    const Dictionary functions = dictionary.subOrEmpty("functions");
    for (const std::string& name : functions.keys()) {
        const Dictionary entry = functions.sub(name);
        if (!isFileName(name))
            functions.fail(name,
                           "'" + name + "' cannot be the name of a folder under postProcessing",
                           "use letters, digits and _ . + -, at most 64, no leading dot");
        History history;
        history.name = name;
        const std::string type = entry.choice(
            "type", {"energies", "contactForces", "point", "reaction", "rigidBody", "part"});
        if (type == "contactForces") history.kind = History::Kind::contactForces;
        if (type == "point") {
            history.kind = History::Kind::point;
            readPoint(entry, model.mesh, history, log);
        } else if (type == "reaction") {
            history.kind = History::Kind::reaction;
            readReaction(entry, model, history);
        } else if (type == "rigidBody") {
            history.kind = History::Kind::rigidBody;
            readBody(entry, model, history);
        } else if (type == "part") {
            history.kind = History::Kind::part;
            readPart(entry, model, history);
        }
        histories.push_back(history);
    }
    addEnergies(histories);
    return histories;
}

} // namespace fpm
