#include "advise/SymmetryEdits.h"

#include "advise/SymmetryNames.h"
#include "base/Format.h"
#include "mesh/Surface.h"
#include "model/NodeSelection.h"

#include <algorithm>

namespace fpm {

namespace {

using Kind = BoundaryCondition::Kind;

constexpr const char* conditions = "constant/boundaryConditions";
const std::string otherSide = "lay on the side of a mirror plane that was cut off";

/// One cut of one case, before it is written to its dictionaries.
class SymmetryEditor
{
public:
    SymmetryEditor(const Model& model, const Case& theCase, const Cut& cut, Mesh& mesh)
        : model_(model),
          case_(theCase),
          cut_(cut),
          mesh_(mesh)
    {
    }

    CaseEdits edits()
    {
        for (const BoundaryCondition& condition : model_.boundaryConditions) edit(condition);
        for (const InitialVelocity& initial : model_.initialVelocities)
            if (!keepsAny(initial.nodes)) {
                edits_.remove("0/initialConditions", initial.name,
                              format("{} {}", initial.name, otherSide));
                edits_.notes.push_back(format("initial velocity '{}' {}", initial.name, otherSide));
            }
        for (std::size_t plane = 0; plane < cut_.planes().size(); ++plane) holdPlane(plane);
        addContact();
        addHistories();
        if (case_.hasFile("system/probeDict")) addProbes(case_.dictionary("system/probeDict"));
        return std::move(edits_);
    }

private:
    bool keeps(Index node) const { return cut_.keeps(model_.mesh.points[std::size_t(node)]); }
    bool keepsAny(const std::vector<Index>& nodes) const
    {
        return std::any_of(nodes.begin(), nodes.end(), [&](Index n) { return keeps(n); });
    }

    void edit(const BoundaryCondition& condition)
    {
        const bool sides = condition.isLoad() && !condition.sides.empty();
        const bool left = sides ? std::any_of(condition.sides.begin(), condition.sides.end(),
                                              [&](const ElementSide& side) {
                                                  return cut_.keeps(model_.mesh, side.element);
                                              })
                                : keepsAny(condition.nodes);
        if (!left) {
            edits_.remove(conditions, condition.name, format("{} {}", condition.name, otherSide));
            edits_.notes.push_back(format("condition '{}' {}", condition.name, otherSide));
        } else if (condition.kind == Kind::force && sides)
            shareArea(condition);
        else if (condition.kind == Kind::force)
            shareNodes(condition);
    }

    void setValue(const BoundaryCondition& condition, double share)
    {
        edits_.set(conditions, condition.name + ".value", vectorText(condition.value, share));
        edits_.notes.push_back(format("the force '{}' is {} of what it was: as much of the loaded "
                                      "surface is left",
                                      condition.name, toText(share, 6)));
    }

    void shareArea(const BoundaryCondition& condition)
    {
        double whole = 0, left = 0;
        for (const ElementSide& side : condition.sides) {
            const double a = area(model_.mesh, side);
            whole += a;
            if (cut_.keeps(model_.mesh, side.element)) left += a;
        }
        setValue(condition, left / whole);
    }

    /// A force in equal shares: nodes on a plane are halved by it, and so are their shares.
    void shareNodes(const BoundaryCondition& condition)
    {
        std::vector<std::vector<Index>> byPlanes(cut_.planes().size() + 1);
        for (const Index node : condition.nodes)
            if (keeps(node))
                byPlanes[cut_.planesAt(model_.mesh.points[std::size_t(node)])].push_back(node);
        const auto shareOf = [&](std::size_t planes) {
            return double(byPlanes[planes].size()) / double(condition.nodes.size())
                   / double(1U << planes);
        };
        const auto filled = [](const std::vector<Index>& nodes) { return !nodes.empty(); };
        if (std::count_if(byPlanes.begin(), byPlanes.end(), filled) == 1) {
            const auto only = std::find_if(byPlanes.begin(), byPlanes.end(), filled);
            return setValue(condition, shareOf(std::size_t(only - byPlanes.begin())));
        }
        edits_.remove(
            conditions, condition.name,
            format("{} is shared out below: nodes on mirror planes bear half", condition.name));
        for (std::size_t planes = 0; planes < byPlanes.size(); ++planes) {
            if (byPlanes[planes].empty()) continue;
            const std::string name =
                names_.free(format("{}{}", condition.name, planes), model_, mesh_);
            mesh_.nodeSets[name] = byPlanes[planes];
            edits_.additions[conditions] += forceText(condition, name, shareOf(planes));
        }
        edits_.notes.push_back(
            format("the force '{}' is distributed again: nodes on a mirror plane are half nodes",
                   condition.name));
    }

    void holdPlane(std::size_t plane)
    {
        const std::size_t number = cut_.planes()[plane].axis;
        const std::string axis(1, "xyz"[number]), upper(1, "XYZ"[number]);
        std::vector<bool> free(model_.mesh.points.size(), false);
        std::string text;
        for (std::size_t part = 0; part < model_.parts.size(); ++part) {
            if (model_.parts[part].kind != PartKind::rigidFree) continue;
            const std::string& name = model_.parts[part].name;
            for (const Index node : nodesOfPart(model_.mesh, Index(part)))
                free[std::size_t(node)] = true;
            text +=
                format("{} { type symmetry; part {}; normal {}; }\n",
                       names_.free(format("mirror{}_{}", upper, name), model_, mesh_), name, axis);
        }
        std::vector<Index> nodes;
        for (Index node = 0; node < Index(free.size()); ++node) {
            const Point& point = model_.mesh.points[std::size_t(node)];
            if (!free[std::size_t(node)] && cut_.isOn(plane, point) && cut_.keeps(point))
                nodes.push_back(node);
        }
        if (!nodes.empty()) {
            const std::string name = names_.free("mirror" + upper, model_, mesh_);
            mesh_.nodeSets[name] = nodes;
            text += format("{} { type symmetry; set {}; normal {}; }\n", name, name, axis);
        }
        edits_.additions[conditions] +=
            format("\n// The mirror plane {} that the model was cut at.\n",
                   cut_.planes()[plane].text())
            + text;
    }

    /// The skin of a cut part would have the sides of the cut; sets have those of the whole only.
    void addContact()
    {
        if (!case_.hasFile("system/contactDict")) return;
        const ContactEntries entries = readContactEntries(case_.dictionary("system/contactDict"));
        for (const PairEntry& entry : entries.pairs)
            for (const ContactSurfaces& surfaces : model_.mesh.contact) {
                if (surfaces.pair != entry.name) continue;
                const std::string first = useSet(entries, entry.name, "contactor", entry.contactor,
                                                 surfaces.contactorSides);
                if (entries.rigidSurface(entry.target) >= 0) continue;
                if (entry.target == entry.contactor)
                    edits_.set("system/contactDict", "pairs." + entry.name + ".target", first);
                else
                    useSet(entries, entry.name, "target", entry.target, surfaces.targetSides);
            }
    }

    std::string useSet(const ContactEntries& entries,
                       const std::string& pair,
                       const std::string& role,
                       const std::string& surface,
                       const std::vector<ElementSide>& sides)
    {
        const bool isMade = std::any_of(entries.surfaces.begin(), entries.surfaces.end(),
                                        [&](const SurfaceEntry& s) { return s.name == surface; });
        if (!isMade && mesh_.findPart(surface) < 0) return surface;
        const std::string name = names_.free(pair + "." + role, model_, mesh_);
        mesh_.sideSets[name] = sides;
        edits_.set("system/contactDict", "pairs." + pair + "." + role, name);
        return name;
    }

    void addHistories()
    {
        const Dictionary functions = case_.dictionary("system/controlDict").subOrEmpty("functions");
        for (const History& history : model_.control.histories) {
            const std::string path = "functions." + history.name;
            if (history.kind == History::Kind::point) {
                const Point& node = model_.mesh.points[std::size_t(history.node)];
                move("system/controlDict", path, functions.sub(history.name).vector("position"),
                     node);
            } else if (history.kind == History::Kind::reaction) {
                if (history.condition >= 0 && !keepsAny(history.nodes)) {
                    edits_.remove("system/controlDict", path,
                                  format("{}: its condition {}", history.name, otherSide));
                    edits_.notes.push_back(
                        format("history '{}' is gone: its condition {}", history.name, otherSide));
                } else
                    edits_.set("system/controlDict", path + ".factor",
                               toText(history.factor * cut_.factor()));
            }
        }
    }

    /// Puts a position at `point`, or its image on the side that is kept.
    void
    move(const std::string& file, const std::string& path, const Point& old, const Point& point)
    {
        const Point kept = cut_.kept(point);
        if (kept == old) return;
        edits_.set(file, path + ".position", vectorText(kept, 1));
        std::string turned;
        for (const MirrorPlane& plane : cut_.planes())
            if (kept[plane.axis] != point[plane.axis])
                turned += format(" {}", std::string(1, "xyz"[plane.axis]));
        if (!turned.empty())
            edits_.notes.push_back(format("{} is recorded at its mirror image: components{} have "
                                          "the opposite sign",
                                          path, turned));
    }

    bool emptied(const std::string& set) const
    {
        const Mesh& mesh = model_.mesh;
        if (const auto nodes = mesh.nodeSets.find(set); nodes != mesh.nodeSets.end())
            return !keepsAny(nodes->second);
        const auto sides = mesh.sideSets.find(set);
        return sides != mesh.sideSets.end()
               && std::none_of(sides->second.begin(), sides->second.end(),
                               [&](const ElementSide& s) { return cut_.keeps(mesh, s.element); });
    }

    void addProbes(const Dictionary& probes)
    {
        const Dictionary tables = probes.subOrEmpty("tables");
        for (const std::string& name : tables.keys()) {
            const Dictionary table = tables.sub(name);
            const std::string path = "tables." + name;
            if (table.has("position")) {
                const Point position = table.vector("position");
                move("system/probeDict", path, position, position);
            }
            if (table.has("set") && emptied(table.word("set"))) {
                edits_.remove("system/probeDict", path, format("{}: its set {}", name, otherSide));
                edits_.notes.push_back(format("table '{}' is gone: its set {}", name, otherSide));
            }
        }
        std::string axes;
        Point origin{0, 0, 0};
        for (const MirrorPlane& plane : cut_.planes()) {
            axes += std::string(axes.empty() ? "" : " ") + "xyz"[plane.axis];
            origin[plane.axis] = plane.place;
        }
        const Dictionary pictures = probes.subOrEmpty("pictures");
        for (const std::string& name : pictures.keys()) {
            if (pictures.sub(name).has("mirror")) continue;
            edits_.set("system/probeDict", "pictures." + name + ".mirror", format("({})", axes));
            edits_.set("system/probeDict", "pictures." + name + ".mirrorOrigin",
                       vectorText(origin, 1));
        }
    }

    const Model& model_;
    const Case& case_;
    const Cut& cut_;
    Mesh& mesh_;
    FreeNames names_;
    CaseEdits edits_;
};

} // namespace

Cut chooseCut(const Model& model, const std::vector<MirrorPlane>& planes)
{
    std::vector<int> sides;
    for (const MirrorPlane& plane : planes) {
        double sum = 0;
        for (const History& history : model.control.histories)
            if (history.kind == History::Kind::point) {
                const Point& p = model.mesh.points[std::size_t(history.node)];
                sum += p[plane.axis] > plane.place ? 1 : p[plane.axis] < plane.place ? -1 : 0;
            }
        sides.push_back(sum < 0 ? -1 : 1);
    }
    return {model.mesh, planes, sides};
}

CaseEdits symmetryEdits(const Model& model, const Case& theCase, const Cut& cut, Mesh& mesh)
{
    return SymmetryEditor(model, theCase, cut, mesh).edits();
}

} // namespace fpm
