#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "model/ImposedMotion.h"
#include "model/NodeSelection.h"
#include "solver/SetUp.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fpm {

namespace {

using Kind = BoundaryCondition::Kind;

Index addCondition(SolverSetUp& data, const BoundaryCondition& condition)
{
    data.nodes.conditions.push_back(conditionOf(condition, data.nodes.amplitudeRows));
    return Index(data.nodes.conditions.size()) - 1;
}

/// Integral of N_I dA over the reference faces, for each node of `sides` (2 x 2 Gauss points).
void addAreas(const Mesh& mesh,
              const std::vector<ElementSide>& sides,
              const std::function<void(Index, double)>& add)
{
    const double g = 1 / std::sqrt(3.0);
    const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (const ElementSide& side : sides) {
        const Quad quad = mesh.sideNodes(side);
        for (const auto& at : corner) {
            const double xi = g * at[0], eta = g * at[1];
            double t[2][3] = {}, n[4];
            for (std::size_t i = 0; i < 4; ++i) {
                const double a = corner[i][0], b = corner[i][1];
                n[i] = 0.25 * (1 + a * xi) * (1 + b * eta);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double x = mesh.points[std::size_t(quad[i])][c];
                    t[0][c] += 0.25 * a * (1 + b * eta) * x;
                    t[1][c] += 0.25 * b * (1 + a * xi) * x;
                }
            }
            double square = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
                const double component = t[0][d] * t[1][e] - t[0][e] * t[1][d];
                square += component * component;
            }
            for (std::size_t i = 0; i < 4; ++i) add(quad[i], n[i] * std::sqrt(square));
        }
    }
}

/// Mass of each node from the elements of the given parts, without mass scaling: what weighs.
std::vector<double>
massOfParts(const SolverSetUp& data, const Model& model, const std::vector<Index>& parts)
{
    std::vector<double> mass(std::size_t(data.nodes.count), 0.0);
    for (const Index part : parts) {
        if (model.parts[std::size_t(part)].kind == PartKind::rigidFree) continue; // as a whole
        const MeshPart& run = model.mesh.parts[std::size_t(part)];
        const double density = model.parts[std::size_t(part)].density;
        for (Index e = run.firstElement; e < run.firstElement + run.elementCount; ++e)
            for (const Index node : model.mesh.hexahedra[std::size_t(e)])
                mass[std::size_t(node)] += density * volume(model.mesh, e) / 8;
    }
    return mass;
}

/// Weight of each loaded node in the load's value.
std::vector<double>
loadWeights(const SolverSetUp& data, const Model& model, const BoundaryCondition& condition)
{
    if (condition.kind == Kind::gravity) return massOfParts(data, model, condition.parts);
    std::vector<double> weight(std::size_t(data.nodes.count), 0.0);
    if (condition.sides.empty()) {
        for (const Index node : condition.nodes)
            weight[std::size_t(node)] = 1.0 / double(condition.nodes.size());
        return weight;
    }
    double total = 0;
    addAreas(model.mesh, condition.sides, [&](Index node, double area) {
        weight[std::size_t(node)] += area;
        total += area;
    });
    if (condition.kind == Kind::force)
        for (double& share : weight) share /= total;
    return weight;
}

void addPressure(SolverSetUp& data,
                 const Mesh& mesh,
                 const BoundaryCondition& condition,
                 Index number)
{
    for (const ElementSide& side : condition.sides) {
        const Quad quad = mesh.sideNodes(side);
        data.nodes.pressureFaceNode.insert(data.nodes.pressureFaceNode.end(), quad.begin(),
                                           quad.end());
        data.nodes.pressureFaceElement.push_back(side.element);
        data.nodes.pressureFaceCondition.push_back(number);
    }
}

/// CSR of `entries` (owner, value), owners ascending, their values in the order given.
template <class Value>
void toRows(std::vector<std::pair<Index, Value>> entries,
            Index owners,
            std::vector<Index>& start,
            std::vector<Value>& values)
{
    if (entries.empty()) return;
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    start.assign(std::size_t(owners) + 1, 0);
    for (const auto& [owner, value] : entries) {
        ++start[std::size_t(owner) + 1];
        values.push_back(value);
    }
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
}

using Uses = std::vector<std::pair<Index, ConditionUse>>;

/// Velocity of a driven component at time 0, for a path factor of 1: a body driven from the start
/// is in motion then, it is not struck.
double startVelocity(const Condition& condition, const std::vector<double>& rows)
{
    if (condition.kind == ConditionKind::velocity) return amplitudeAt(condition, rows.data(), 0);
    const double* row = rows.data() + 2 * std::size_t(condition.firstRow);
    for (Index i = 1; i < condition.rowCount; ++i) {
        const double before = row[2 * i - 2], after = row[2 * i], length = after - before;
        if (!(before <= 0 && 0 < after)) continue;
        const double tau = -before / length, slope = (row[2 * i + 1] - row[2 * i - 1]) / length;
        const double factor =
            condition.smooth ? slope * 30 * tau * tau * (1 - tau) * (1 - tau) : slope;
        const double radian = 3.14159265358979323846 / 180;
        return condition.kind == ConditionKind::rotation ? radian * condition.value[0] * factor
                                                         : factor;
    }
    return 0;
}

/// The velocity `v` with its part along a unit axis replaced.
void setAlong(Point& v, const Point& axis, double speed)
{
    double change = speed;
    for (std::size_t c = 0; c < 3; ++c) change -= v[c] * axis[c];
    for (std::size_t c = 0; c < 3; ++c) v[c] += change * axis[c];
}

/// Held components, and those that a condition drives.
void addImposed(SolverSetUp& data,
                const Model& model,
                const std::vector<Index>& numbers,
                Uses& uses)
{
    const ImposedMotion imposed = imposedMotion(model);
    data.nodes.frameOf = imposed.frameOf;
    for (const Axes& axes : imposed.frames)
        for (const Point& axis : axes)
            data.nodes.frames.insert(data.nodes.frames.end(), axis.begin(), axis.end());
    for (Index node = 0; node < data.nodes.count; ++node) {
        const Axes& axes = imposed.axesOf(node);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Index owner = imposed.ownerOf(node, axis);
            if (owner < 0) continue;
            const BoundaryCondition& condition = model.boundaryConditions[std::size_t(owner)];
            if (holds(condition, axes[axis])) {
                data.nodes.fixed[std::size_t(node)] |= heldComponent(int(axis));
                setAlong(data.nodes.velocity[std::size_t(node)], axes[axis], 0);
                continue;
            }
            const auto [first, second] =
                pathFactors(condition, model.mesh.points[std::size_t(node)], axes[axis]);
            const Index number = numbers[std::size_t(owner)];
            uses.push_back({node, {number, std::int32_t(axis), first, second}});
            setAlong(data.nodes.velocity[std::size_t(node)], axes[axis],
                     first
                         * startVelocity(data.nodes.conditions[std::size_t(number)],
                                         data.nodes.amplitudeRows));
        }
    }
}

void markImposed(SolverSetUp& data)
{
    for (std::size_t node = 0; node < data.nodes.fixed.size(); ++node) {
        int imposed = data.nodes.fixed[node];
        if (!data.nodes.conditionStart.empty())
            for (Index k = data.nodes.conditionStart[node]; k < data.nodes.conditionStart[node + 1];
                 ++k)
                if (const int axis = data.nodes.uses[std::size_t(k)].axis; axis >= 0)
                    imposed |= heldComponent(axis);
        if ((imposed & heldComponents) == heldComponents) data.nodes.fixed[node] |= imposedNode;
    }
}

void addInitialVelocities(SolverSetUp& data, const Model& model)
{
    data.nodes.velocity.assign(std::size_t(data.nodes.count), Point{0, 0, 0});
    // A velocity is set (two that meet are equal), rotations add to it.
    for (const InitialVelocity& initial : model.initialVelocities)
        if (!initial.rotates)
            for (const Index node : initial.nodes)
                data.nodes.velocity[std::size_t(node)] = initial.velocity;
    for (const InitialVelocity& initial : model.initialVelocities) {
        if (!initial.rotates) continue;
        for (const Index node : initial.nodes) {
            const Point v = initial.at(model.mesh.points[std::size_t(node)]);
            for (std::size_t c = 0; c < 3; ++c) data.nodes.velocity[std::size_t(node)][c] += v[c];
        }
    }
}

} // namespace

Condition makeCondition(ConditionKind kind,
                        const Point& value,
                        const Amplitude& amplitude,
                        std::vector<double>& amplitudeRows)
{
    Condition out{};
    out.kind = kind;
    out.smooth = amplitude.kind == Amplitude::Kind::smooth;
    out.firstRow = Index(amplitudeRows.size() / 2);
    out.rowCount = Index(amplitude.rows.size());
    for (const auto& row : amplitude.rows) {
        amplitudeRows.push_back(row[0]);
        amplitudeRows.push_back(row[1]);
    }
    for (std::size_t c = 0; c < 3; ++c) out.value[c] = value[c];
    return out;
}

Condition conditionOf(const BoundaryCondition& condition, std::vector<double>& amplitudeRows)
{
    const ConditionKind kind = condition.kind == Kind::displacement ? ConditionKind::displacement
                               : condition.kind == Kind::velocity   ? ConditionKind::velocity
                               : condition.kind == Kind::rotation   ? ConditionKind::rotation
                               : condition.kind == Kind::pressure   ? ConditionKind::pressure
                                                                    : ConditionKind::load;
    const Point value =
        condition.kind == Kind::rotation ? Point{condition.angle, 0, 0} : condition.globalValue();
    return makeCondition(kind, value, condition.amplitude, amplitudeRows);
}

void addMotion(SolverSetUp& data, const Model& model)
{
    addInitialVelocities(data, model);
    data.nodes.fixed.assign(std::size_t(data.nodes.count), 0);
    Uses uses;
    std::vector<Index> numbers;
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        numbers.push_back(condition.kind == Kind::fixed ? -1 : addCondition(data, condition));
        if (condition.kind == Kind::pressure)
            addPressure(data, model.mesh, condition, numbers.back());
        else if (condition.isLoad()) {
            const std::vector<double> weight = loadWeights(data, model, condition);
            for (const Index node : condition.nodes)
                if (weight[std::size_t(node)] != 0)
                    uses.push_back({node, {numbers.back(), -1, weight[std::size_t(node)], 0}});
        }
    }
    addImposed(data, model, numbers, uses);
    toRows(std::move(uses), data.nodes.count, data.nodes.conditionStart, data.nodes.uses);
    std::vector<std::pair<Index, Index>> slots;
    for (std::size_t slot = 0; slot < data.nodes.pressureFaceNode.size(); ++slot)
        slots.push_back({data.nodes.pressureFaceNode[slot], Index(slot)});
    toRows(std::move(slots), data.nodes.count, data.nodes.pressureStart, data.nodes.pressureSlots);
    addBodies(data, model, numbers);
    markImposed(data);
}

} // namespace fpm
