#include "model/MotionCheck.h"

#include "base/Format.h"
#include "model/BoundaryReader.h"
#include "model/ImposedMotion.h"
#include "model/PointAlgebra.h"

#include <algorithm>

namespace fpm {

namespace {

using Kind = BoundaryCondition::Kind;

std::string placeOf(const Mesh& mesh, Index node)
{
    return format("node {} at {}", node, pointText(mesh.points[std::size_t(node)]));
}

/// "component x", or "direction (0.6 0.8 0)".
std::string directionText(const Point& direction)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (direction == globalAxes[axis]) return std::string("component ") + "xyz"[axis];
    return "direction " + pointText(direction);
}

void refuseClash(const ImposedMotion::Clash& clash,
                 const Model& model,
                 const Dictionary& dictionary)
{
    const BoundaryCondition& earlier = model.boundaryConditions[std::size_t(clash.earlier)];
    const BoundaryCondition& later = model.boundaryConditions[std::size_t(clash.later)];
    const auto verb = [&](const BoundaryCondition& condition) {
        return holds(condition, clash.direction) ? "held" : "driven";
    };
    if (clash.oblique)
        dictionary.fail(later.name,
                        format("{} of {} is neither along nor across what '{}' imposes there ({} "
                               "such nodes)",
                               directionText(clash.direction), placeOf(model.mesh, clash.node),
                               earlier.name, clash.nodes),
                        "take these nodes out of one of the sets, or choose axes that agree");
    dictionary.fail(later.name,
                    format("{} of {} is {} by '{}' but {} otherwise by '{}' ({} such nodes)",
                           directionText(clash.direction), placeOf(model.mesh, clash.node),
                           verb(earlier), earlier.name, verb(later), later.name, clash.nodes),
                    "take these nodes out of one of the sets, or limit its 'components'");
}

/// A prescribed part has no elements that could carry it: every node moves as its conditions say.
void checkPrescribedPart(const ImposedMotion& imposed,
                         const Model& model,
                         Index part,
                         const Dictionary& dictionary)
{
    const std::string& name = model.parts[std::size_t(part)].name;
    const std::vector<Index> nodes = nodesOfPart(model.mesh, part);
    const Axes& axes = imposed.axesOf(nodes.front());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Index first = imposed.ownerOf(nodes.front(), axis);
        for (const Index node : nodes) {
            const Index owner = imposed.ownerOf(node, axis);
            if (owner < 0)
                throw Error(ExitCode::dictionary,
                            format("{}: part '{}' is rigidPrescribed, but {} of its {} is neither "
                                   "held nor driven",
                                   dictionary.name(), name,
                                   directionText(imposed.axesOf(node)[axis]),
                                   placeOf(model.mesh, node)),
                            format("it moves only as prescribed: add a condition with 'part {};' "
                                   "for every component, or use model rigidFree or a deformable "
                                   "one",
                                   name));
            const auto& conditions = model.boundaryConditions;
            if (owner != first || imposed.axesOf(node) != axes)
                if (imposed.axesOf(node) != axes
                    || !sameMotion(conditions[std::size_t(first)], conditions[std::size_t(owner)],
                                   axes[axis]))
                    dictionary.fail(
                        conditions[std::size_t(owner)].name,
                        format("part '{}' is rigidPrescribed, but its nodes are moved differently "
                               "in {} by '{}' and '{}'",
                               name, directionText(axes[axis]), conditions[std::size_t(first)].name,
                               conditions[std::size_t(owner)].name),
                        format("use one condition with 'part {};'", name));
        }
    }
}

/// A rigidFree part moves as a whole: it can be held as a whole, and loaded anywhere.
void checkFreePart(const Model& model, Index part, const Dictionary& dictionary)
{
    const std::string& name = model.parts[std::size_t(part)].name;
    const std::vector<Index> nodes = nodesOfPart(model.mesh, part);
    const auto belongs = [&](Index node) {
        return std::binary_search(nodes.begin(), nodes.end(), node);
    };
    for (Index other = 0; other < Index(model.parts.size()); ++other)
        if (other != part)
            for (const Index node : nodesOfPart(model.mesh, other))
                if (belongs(node))
                    throw Error(ExitCode::mesh,
                                format("parts '{}' and '{}' share {}, but '{}' is rigidFree", name,
                                       model.parts[std::size_t(other)].name,
                                       placeOf(model.mesh, node), name),
                                "a rigidFree part needs nodes of its own: let contact join them");
    std::string last;
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        if (condition.isLoad()) continue;
        const auto node = std::find_if(condition.nodes.begin(), condition.nodes.end(), belongs);
        if (node == condition.nodes.end()) continue;
        if (condition.kind != Kind::fixed)
            dictionary.fail(
                condition.name,
                format("'{}' drives part '{}', which is rigidFree", condition.name, name),
                "use model rigidPrescribed to drive it; loads may act on it as it is");
        if (condition.part != part)
            dictionary.fail(
                condition.name,
                format("'{}' holds {} of part '{}', which is rigidFree and moves as a "
                       "whole",
                       condition.name, placeOf(model.mesh, *node), name),
                format("name it by 'part {};' and list its components and rotations", name));
        last = condition.name;
    }
    if (heldBody(model, part).turns == 2)
        dictionary.fail(last, format("one rotation of part '{}' is held and two are free", name),
                        "hold all rotations, all but one, or none");
    for (const InitialVelocity& initial : model.initialVelocities)
        if (initial.part != part
            && std::any_of(initial.nodes.begin(), initial.nodes.end(), belongs))
            throw Error(ExitCode::dictionary,
                        format("0/initialConditions: '{}' gives a velocity to single nodes of part "
                               "'{}', which is rigidFree and moves as a whole",
                               initial.name, name),
                        format("name it by 'part {};'", name));
}

/// 'rotations' mean something for a rigidFree part alone.
void checkTurns(const Model& model, const Dictionary& dictionary)
{
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        const std::array none{false, false, false}, all{true, true, true};
        const bool everything = condition.constrains == all && condition.turns == all;
        if (condition.turns == none || everything) continue;
        if (condition.part < 0
            || model.parts[std::size_t(condition.part)].kind != PartKind::rigidFree)
            dictionary.sub(condition.name)
                .fail("rotations",
                      format("'{}' holds rotations, but does not name a rigidFree part",
                             condition.name),
                      "remove 'rotations', or name such a part by 'part'");
    }
}

/// Reports a request that has no effect because the component is prescribed.
template <class Entry>
void reportOverruled(const ImposedMotion& imposed,
                     const Entry& entry,
                     const Point& value,
                     const std::string& what,
                     Log& log)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (value[axis] == 0) continue;
        std::size_t overruled = 0;
        for (const Index node : entry.nodes)
            overruled += imposed.axesOf(node) == globalAxes && imposed.ownerOf(node, axis) >= 0;
        if (overruled > 0)
            log.line(format("{} '{}': component {} has no effect at {} of its {} nodes, where a "
                            "boundary condition prescribes it",
                            what, entry.name, std::string(1, "xyz"[axis]), overruled,
                            entry.nodes.size()));
    }
}

} // namespace

void checkMotions(const Model& model, const Dictionary& dictionary, Log& log)
{
    checkTurns(model, dictionary);
    for (std::size_t part = 0; part < model.parts.size(); ++part)
        if (model.parts[part].kind == PartKind::rigidFree)
            checkFreePart(model, Index(part), dictionary);
    const ImposedMotion imposed = imposedMotion(model);
    if (!imposed.clashes.empty()) refuseClash(imposed.clashes.front(), model, dictionary);
    for (std::size_t part = 0; part < model.parts.size(); ++part)
        if (model.parts[part].kind == PartKind::rigidPrescribed)
            checkPrescribedPart(imposed, model, Index(part), dictionary);
    for (const InitialVelocity& initial : model.initialVelocities)
        reportOverruled(imposed, initial, initial.velocity, "initial velocity", log);
    for (const BoundaryCondition& condition : model.boundaryConditions)
        if (condition.kind == Kind::force)
            reportOverruled(imposed, condition, condition.globalValue(), "force", log);
}

} // namespace fpm
