#include "mesher/Sets.h"

#include "base/Format.h"
#include "mesh/Surface.h"
#include "mesher/FileBody.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace fpm {

namespace {

Point readUnitVector(const Dictionary& entry, std::string_view key)
{
    Point vector = entry.vector(key);
    const double length = std::hypot(vector[0], vector[1], vector[2]);
    if (!(length > 0)) entry.fail(key, format("'{}' must be a direction, found (0 0 0)", key));
    for (double& component : vector) component /= length;
    return vector;
}

SetEntry readSet(const std::string& name, const Dictionary& entry)
{
    SetEntry set{SetEntry::Kind::plane, name, entry, {}, {}, {}, 0, {}, {}};
    const std::string type = entry.choice("type", {"plane", "box", "union", "point"});
    if (type == "union") {
        set.kind = SetEntry::Kind::unite;
        set.sets = entry.words("sets");
        if (set.sets.empty()) entry.fail("sets", "'sets' must hold at least one name");
        return set;
    }
    if (type == "point") {
        set.kind = SetEntry::Kind::point;
        set.point = entry.vector("position");
        set.body = entry.wordOr("body", "");
        return set;
    }
    if (entry.has("bodies")) {
        set.bodies = entry.words("bodies");
        if (set.bodies.empty()) entry.fail("bodies", "'bodies' must hold at least one name");
    }
    if (type == "plane") {
        set.point = entry.vector("point");
        set.second = readUnitVector(entry, "normal");
        set.tolerance = entry.numberOr("tolerance", 0, nonNegative());
        return set;
    }
    set.kind = SetEntry::Kind::box;
    set.point = entry.vector("min");
    set.second = entry.vector("max");
    for (int k = 0; k < 3; ++k)
        if (!(set.point[k] < set.second[k]))
            entry.fail("max",
                       format("'max' must be greater than 'min' in every direction, found {} to {}",
                              set.point[k], set.second[k]));
    return set;
}

std::string listOf(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t name = 0; name < std::min(most, names.size()); ++name)
        text += (name > 0 ? ", " : "") + names[name];
    return names.size() > most ? text + ", ..." : text;
}

/// Makes each set once, those a union names before it.
class SetMaker
{
public:
    SetMaker(const std::vector<SetEntry>& entries, MeshedBodies& bodies)
        : entries_(entries),
          bodies_(bodies),
          mesh_(bodies.mesh)
    {
    }

    void make(const SetEntry& entry)
    {
        if (made_.contains(entry.name)) return;
        if (!open_.insert(entry.name).second)
            entry.dictionary.fail("sets", format("set {} is a union of itself", entry.name));
        if (!isName(entry.name))
            entry.dictionary.fail(
                "type", format("'{}' cannot name a set: expected {}", entry.name, nameRule));
        if (mesh_.sideSets.contains(entry.name) || mesh_.nodeSets.contains(entry.name))
            entry.dictionary.fail("type", format("the mesh already has a set '{}'", entry.name),
                                  "choose another name");
        switch (entry.kind) {
        case SetEntry::Kind::plane:
            mesh_.sideSets[entry.name] = sidesInPlane(entry);
            break;
        case SetEntry::Kind::box:
            mesh_.sideSets[entry.name] = sidesInBox(entry);
            break;
        case SetEntry::Kind::unite:
            unite(entry);
            break;
        case SetEntry::Kind::point:
            mesh_.nodeSets[entry.name] = {nearestNode(entry)};
            break;
        }
        made_.insert(entry.name);
    }

private:
    const std::vector<SetEntry>& entries_;
    MeshedBodies& bodies_;
    Mesh& mesh_;
    std::map<Index, std::vector<ElementSide>> skins_;
    std::set<std::string> made_, open_;

    const std::vector<ElementSide>& skinOf(Index part)
    {
        const auto [place, isNew] = skins_.try_emplace(part);
        if (isNew) place->second = skin(mesh_, part);
        return place->second;
    }

    /// Parts that `names` stand for: an entry of `bodies` with all its parts, or a single part.
    std::vector<Index> partsOf(const SetEntry& entry,
                               const std::string& key,
                               const std::vector<std::string>& names) const
    {
        std::set<Index> parts;
        for (const auto& name : names) {
            const auto known = bodies_.partsOfEntry.find(name);
            if (known != bodies_.partsOfEntry.end())
                for (const auto& part : known->second) parts.insert(mesh_.findPart(part));
            else
                parts.insert(mesh_.findPart(name));
            if (parts.contains(-1)) {
                std::vector<std::string> all;
                for (const auto& part : mesh_.parts) all.push_back(part.name);
                entry.dictionary.fail(key, format("there is no body '{}'", name),
                                      "the bodies are: " + listOf(all));
            }
        }
        for (Index part = 0; names.empty() && part < Index(mesh_.parts.size()); ++part)
            parts.insert(part);
        return {parts.begin(), parts.end()};
    }

    template <class Condition>
    std::vector<ElementSide> outerSides(const SetEntry& entry, const Condition& isWanted)
    {
        std::vector<ElementSide> sides;
        for (const Index part : partsOf(entry, "bodies", entry.bodies))
            for (const ElementSide& side : skinOf(part))
                if (isWanted(side)) sides.push_back(side);
        return sides;
    }

    double extent() const
    {
        Point low = mesh_.points.front(), high = low;
        for (const Point& point : mesh_.points)
            for (int k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], point[k]);
                high[k] = std::max(high[k], point[k]);
            }
        return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    }

    std::vector<ElementSide> sidesInPlane(const SetEntry& entry)
    {
        const double tolerance = entry.tolerance > 0 ? entry.tolerance : 1e-6 * extent();
        const auto distance = [&](Index node) {
            double sum = 0;
            for (int k = 0; k < 3; ++k)
                sum += entry.second[k] * (mesh_.points[node][k] - entry.point[k]);
            return std::abs(sum);
        };
        auto sides = outerSides(entry, [&](const ElementSide& side) {
            const Quad nodes = mesh_.sideNodes(side);
            return std::all_of(nodes.begin(), nodes.end(),
                               [&](Index node) { return distance(node) <= tolerance; });
        });
        if (sides.empty())
            entry.dictionary.fail(
                "point",
                format("set {} is empty: no outer side of an element lies within {} "
                       "of this plane",
                       entry.name, tolerance),
                "check point, normal and bodies");
        return sides;
    }

    std::vector<ElementSide> sidesInBox(const SetEntry& entry)
    {
        auto sides = outerSides(entry, [&](const ElementSide& side) {
            const Point middle = centre(mesh_, side);
            bool isInside = true;
            for (int k = 0; k < 3; ++k)
                isInside = isInside && middle[k] >= entry.point[k] && middle[k] <= entry.second[k];
            return isInside;
        });
        if (sides.empty())
            entry.dictionary.fail(
                "min",
                format("set {} is empty: no outer side of an element has its centre in this box",
                       entry.name),
                "check min, max and bodies");
        return sides;
    }

    Index nearestNode(const SetEntry& entry) const
    {
        std::vector<std::string> names;
        if (!entry.body.empty()) names.push_back(entry.body);
        double least = std::numeric_limits<double>::infinity();
        Index nearest = -1;
        for (const Index part : partsOf(entry, "body", names)) {
            const auto& run = mesh_.parts[part];
            for (Index element = 0; element < run.elementCount; ++element)
                for (const Index node : mesh_.hexahedra[run.firstElement + element]) {
                    const Point& at = mesh_.points[node];
                    const double distance = std::hypot(
                        at[0] - entry.point[0], at[1] - entry.point[1], at[2] - entry.point[2]);
                    if (distance < least || (distance == least && node < nearest)) {
                        least = distance;
                        nearest = node;
                    }
                }
        }
        return nearest;
    }

    /// Sides where all are side sets, else nodes.
    void unite(const SetEntry& entry)
    {
        for (const auto& name : entry.sets) {
            for (const auto& other : entries_)
                if (other.name == name) make(other);
            if (!mesh_.sideSets.contains(name) && !mesh_.nodeSets.contains(name))
                entry.dictionary.fail("sets", format("there is no set '{}'", name),
                                      "the sets are: " + listOf(allSets(entry.name)));
        }
        const bool areSides =
            std::all_of(entry.sets.begin(), entry.sets.end(),
                        [&](const auto& name) { return mesh_.sideSets.contains(name); });
        std::set<ElementSide> sides;
        std::set<Index> nodes;
        for (const auto& name : entry.sets) {
            const auto found = mesh_.sideSets.find(name);
            if (areSides) {
                sides.insert(found->second.begin(), found->second.end());
                continue;
            }
            const auto added = found != mesh_.sideSets.end() ? nodesOf(mesh_, found->second)
                                                             : mesh_.nodeSets.at(name);
            nodes.insert(added.begin(), added.end());
        }
        if (areSides)
            mesh_.sideSets[entry.name].assign(sides.begin(), sides.end());
        else
            mesh_.nodeSets[entry.name].assign(nodes.begin(), nodes.end());
    }

    std::vector<std::string> allSets(const std::string& but) const
    {
        std::vector<std::string> names;
        for (const auto& entry : entries_)
            if (entry.name != but) names.push_back(entry.name);
        for (const auto& [name, sides] : mesh_.sideSets) names.push_back(name);
        for (const auto& [name, nodes] : mesh_.nodeSets) names.push_back(name);
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());
        return names;
    }
};

} // namespace

std::vector<SetEntry> readSets(const Dictionary& sets)
{
    std::vector<SetEntry> entries;
    for (const auto& name : sets.keys()) entries.push_back(readSet(name, sets.sub(name)));
    return entries;
}

void makeSets(const std::vector<SetEntry>& entries, MeshedBodies& bodies, Log& log)
{
    SetMaker maker(entries, bodies);
    for (const auto& entry : entries) maker.make(entry);
    const Mesh& mesh = bodies.mesh;
    for (const auto& entry : entries) {
        const auto sides = mesh.sideSets.find(entry.name);
        if (sides != mesh.sideSets.end())
            log.line(format("set {}: {} sides, {} nodes", entry.name, sides->second.size(),
                            nodesOf(mesh, sides->second).size()));
        else
            log.line(format("set {}: {} nodes", entry.name, mesh.nodeSets.at(entry.name).size()));
    }
}

} // namespace fpm
