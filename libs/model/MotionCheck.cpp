#include "model/MotionCheck.h"

#include "base/Format.h"
#include "model/BoundaryReader.h"
#include "model/PointAlgebra.h"

namespace fpm {

namespace {

constexpr const char* axisNames = "xyz";

std::string placeOf(const Mesh& mesh, Index node)
{
    return format("node {} at {}", node, pointText(mesh.points[std::size_t(node)]));
}

/// Number of the condition that prescribes a component of a node; -1 where it is free.
class Prescriptions
{
public:
    explicit Prescriptions(const Model& model)
        : conditions_(model.boundaryConditions),
          owner_(3 * model.mesh.points.size(), -1)
    {
    }
    Index& owner(Index node, std::size_t axis) { return owner_[3 * std::size_t(node) + axis]; }
    const BoundaryCondition& condition(Index number) const
    {
        return conditions_[std::size_t(number)];
    }

    bool agree(Index first, Index second, std::size_t axis) const
    {
        if (first == second) return true;
        const BoundaryCondition &a = condition(first), &b = condition(second);
        if (holds(a, axis) && holds(b, axis)) return true;
        return a.kind == b.kind && a.value[axis] == b.value[axis] && a.amplitude == b.amplitude;
    }
    static bool holds(const BoundaryCondition& condition, std::size_t axis)
    {
        return condition.kind == BoundaryCondition::Kind::fixed || condition.value[axis] == 0;
    }

private:
    const std::vector<BoundaryCondition>& conditions_;
    std::vector<Index> owner_;
};

struct Conflict {
    Index earlier = -1, node = -1;
    std::size_t axis = 0;
    int nodes = 0;
};

void refuseConflict(const Conflict& conflict,
                    const Prescriptions& prescribed,
                    const BoundaryCondition& later,
                    const Model& model,
                    const Dictionary& dictionary)
{
    const BoundaryCondition& earlier = prescribed.condition(conflict.earlier);
    const auto verb = [&](const BoundaryCondition& condition) {
        return Prescriptions::holds(condition, conflict.axis) ? "held" : "driven";
    };
    dictionary.fail(
        later.name,
        format("component {} of {} is {} by '{}' but {} otherwise by '{}' ({} such nodes)",
               std::string(1, axisNames[conflict.axis]), placeOf(model.mesh, conflict.node),
               verb(earlier), earlier.name, verb(later), later.name, conflict.nodes),
        "take these nodes out of one of the sets, or limit its 'components'");
}

void prescribe(Prescriptions& prescribed, const Model& model, const Dictionary& dictionary)
{
    for (std::size_t number = 0; number < model.boundaryConditions.size(); ++number) {
        const BoundaryCondition& condition = model.boundaryConditions[number];
        if (condition.kind == BoundaryCondition::Kind::force) continue;
        Conflict conflict;
        for (const Index node : condition.nodes) {
            bool agrees = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (!condition.constrains[axis]) continue;
                Index& owner = prescribed.owner(node, axis);
                if (owner >= 0 && !prescribed.agree(owner, Index(number), axis)) {
                    agrees = false;
                    if (conflict.nodes == 0) conflict = {owner, node, axis, 0};
                } else {
                    owner = Index(number);
                }
            }
            conflict.nodes += !agrees;
        }
        if (conflict.nodes > 0) refuseConflict(conflict, prescribed, condition, model, dictionary);
    }
}

/// A rigid part has no elements that could carry it: every node moves as its conditions say.
void checkRigidPart(Prescriptions& prescribed,
                    const Model& model,
                    Index part,
                    const Dictionary& dictionary)
{
    const std::string& name = model.parts[std::size_t(part)].name;
    const std::vector<Index> nodes = nodesOfPart(model.mesh, part);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Index first = prescribed.owner(nodes.front(), axis);
        for (const Index node : nodes) {
            const Index owner = prescribed.owner(node, axis);
            if (owner < 0)
                throw Error(ExitCode::dictionary,
                            format("{}: part '{}' is rigid, but component {} of its {} is neither "
                                   "held nor driven",
                                   dictionary.name(), name, std::string(1, axisNames[axis]),
                                   placeOf(model.mesh, node)),
                            format("a rigid part moves only as prescribed: add a condition with "
                                   "'part {};' for every component, or make the part deformable",
                                   name));
            if (!prescribed.agree(first, owner, axis))
                dictionary.fail(
                    prescribed.condition(owner).name,
                    format("part '{}' is rigid, but its nodes are moved differently in {} "
                           "by '{}' and '{}'",
                           name, std::string(1, axisNames[axis]), prescribed.condition(first).name,
                           prescribed.condition(owner).name),
                    format("use one condition with 'part {};'", name));
        }
    }
}

/// Says where something asked for has no effect because the component is prescribed.
template <class Entry>
void reportOverruled(Prescriptions& prescribed,
                     const Entry& entry,
                     const Point& value,
                     const std::string& what,
                     Log& log)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (value[axis] == 0) continue;
        std::size_t overruled = 0;
        for (const Index node : entry.nodes) overruled += prescribed.owner(node, axis) >= 0;
        if (overruled > 0)
            log.line(format("{} '{}': component {} has no effect at {} of its {} nodes, where a "
                            "boundary condition prescribes it",
                            what, entry.name, std::string(1, axisNames[axis]), overruled,
                            entry.nodes.size()));
    }
}

} // namespace

void checkMotions(const Model& model, const Dictionary& dictionary, Log& log)
{
    Prescriptions prescribed(model);
    prescribe(prescribed, model, dictionary);
    for (std::size_t part = 0; part < model.parts.size(); ++part)
        if (model.parts[part].kind == PartKind::rigid)
            checkRigidPart(prescribed, model, Index(part), dictionary);
    for (const InitialVelocity& initial : model.initialVelocities)
        reportOverruled(prescribed, initial, initial.velocity, "initial velocity", log);
    for (const BoundaryCondition& condition : model.boundaryConditions)
        if (condition.kind == BoundaryCondition::Kind::force)
            reportOverruled(prescribed, condition, condition.value, "force", log);
}

} // namespace fpm
