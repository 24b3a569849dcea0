#include "model/BoundaryReader.h"

#include "base/Format.h"
#include "mesh/Surface.h"
#include "model/Names.h"
#include "model/PointAlgebra.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

using Kind = BoundaryCondition::Kind;

const std::vector<std::string> axisNames{"x", "y", "z"};

std::size_t axisOf(const std::string& name)
{
    return std::size_t(std::find(axisNames.begin(), axisNames.end(), name) - axisNames.begin());
}

std::array<bool, 3> readComponents(const Dictionary& entry, const char* key, bool preset)
{
    if (!entry.has(key)) return {preset, preset, preset};
    std::array<bool, 3> components{false, false, false};
    for (const std::string& word : entry.words(key)) {
        const std::size_t axis = axisOf(word);
        if (axis == 3) entry.fail(key, "unknown component '" + word + "'", "valid: x, y, z");
        if (components[axis]) entry.fail(key, "component '" + word + "' is given twice");
        components[axis] = true;
    }
    if (components == std::array{false, false, false})
        entry.fail(key, "no component is given", "leave the entry out for all three");
    return components;
}

Point unit(const Dictionary& entry, const char* key, const Point& direction)
{
    const double size = length(direction);
    if (!(size > 0) || !std::isfinite(size))
        entry.fail(key, "a direction of '" + std::string(key) + "' has no length",
                   "give a vector such as (1 1 0)");
    return along({0, 0, 0}, 1 / size, direction);
}

/// Orthonormal axes with the given first and second; `second` needs only a component in that
/// direction.
Axes axesFrom(const Point& first, const Point& second)
{
    Axes axes{};
    axes[0] = first;
    axes[1] = along(second, -dot(first, second), first);
    axes[1] = along({0, 0, 0}, 1 / length(axes[1]), axes[1]);
    axes[2] = vector::cross(axes[0], axes[1]);
    return axes;
}

/// `axes ((1 1 0) (-1 1 0))`: the local x and y; z completes them.
Axes readAxes(const Dictionary& entry)
{
    if (!entry.has("axes")) return globalAxes;
    const auto rows = entry.rows("axes", 3);
    if (rows.size() != 2)
        entry.fail("axes", format("'axes' has {} directions, not 2", rows.size()),
                   "give the local x and y, such as: axes ((1 1 0) (-1 1 0));");
    const Point x = unit(entry, "axes", {rows[0][0], rows[0][1], rows[0][2]});
    const Point y = unit(entry, "axes", {rows[1][0], rows[1][1], rows[1][2]});
    if (std::abs(dot(x, y)) > 1e-6)
        entry.fail("axes", "the two directions are not perpendicular",
                   "their scalar product must be 0");
    return axesFrom(x, y);
}

/// A word for a coordinate axis, or a vector; held is the first of the condition's axes.
void readNormal(const Dictionary& entry, BoundaryCondition& condition)
{
    if (!entry.isList("normal")) {
        condition.constrains[axisOf(entry.choice("normal", axisNames))] = true;
        return;
    }
    const Point normal = unit(entry, "normal", entry.vector("normal"));
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (std::abs(normal[axis]) == 1) {
            condition.constrains[axis] = true;
            return;
        }
    // The other two axes are free: any will do.
    const bool leansX = std::abs(normal[0]) > 0.7;
    condition.axes = axesFrom(normal, leansX ? Point{0, 1, 0} : Point{1, 0, 0});
    condition.constrains[0] = true;
}

/// Of a rigidFree part rotations can be held too: what is listed is held; all where nothing is.
void readHeld(const Dictionary& entry, BoundaryCondition& condition)
{
    const bool listed = entry.has("components") || entry.has("rotations");
    condition.constrains = readComponents(entry, "components", !listed || !entry.has("rotations"));
    condition.turns = readComponents(entry, "rotations", !listed);
    condition.axes = readAxes(entry);
}

Kind kindOf(const std::string& type)
{
    if (type == "velocity") return Kind::velocity;
    if (type == "displacement") return Kind::displacement;
    if (type == "rotation") return Kind::rotation;
    if (type == "force") return Kind::force;
    if (type == "traction") return Kind::traction;
    if (type == "pressure") return Kind::pressure;
    if (type == "gravity") return Kind::gravity;
    return Kind::fixed; // also symmetry: its normal component held
}

void readTurn(const Dictionary& entry, BoundaryCondition& condition)
{
    condition.constrains = {true, true, true};
    condition.line = {entry.vector("centre"), unit(entry, "axis", entry.vector("axis"))};
    condition.angle = entry.number("angle");
    condition.amplitude = readAmplitude(entry);
    refuseJump(entry, "rotation", "angle", condition.amplitude(0) * condition.angle);
}

/// Value, components and axes of what drives or loads.
void readValue(const Dictionary& entry, BoundaryCondition& condition)
{
    condition.constrains = readComponents(entry, "components", true);
    condition.axes = readAxes(entry);
    condition.value = entry.vector("value");
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!condition.constrains[axis] && condition.value[axis] != 0)
            entry.fail("value",
                       "component " + axisNames[axis] + " has the value "
                           + toText(condition.value[axis], 6) + " but is not in 'components'",
                       "add " + axisNames[axis] + " to components, or give it the value 0");
    condition.amplitude = readAmplitude(entry);
    if (condition.kind == Kind::displacement)
        refuseJump(entry, "displacement", "value",
                   condition.amplitude(0) * length(condition.value));
}

/// What is loaded: sides, parts or nodes.
void readLoadPlace(const Dictionary& entry, const Mesh& mesh, BoundaryCondition& condition)
{
    if (condition.kind == Kind::gravity) {
        condition.parts = selectParts(entry, mesh);
        for (const Index part : condition.parts) {
            const std::vector<Index> nodes = nodesOfPart(mesh, part);
            condition.nodes.insert(condition.nodes.end(), nodes.begin(), nodes.end());
        }
        std::sort(condition.nodes.begin(), condition.nodes.end());
        const auto last = std::unique(condition.nodes.begin(), condition.nodes.end());
        condition.nodes.erase(last, condition.nodes.end());
        return;
    }
    if (condition.kind == Kind::force
        && entry.choiceOr("distribution", "equal", {"equal", "area"}) == "equal") {
        condition.nodes = selectNodes(entry, mesh);
        return;
    }
    condition.sides = selectSides(entry, mesh);
    if (condition.kind != Kind::force) // whose total does not depend on the side
        refuseInnerSides(entry, "set", mesh, condition.sides,
                         condition.kind == Kind::pressure ? "a pressure" : "a traction");
    condition.nodes = nodesOf(mesh, condition.sides);
    if (condition.nodes.empty())
        entry.fail("set", "set '" + entry.word("set") + "' is empty",
                   "change it in system/meshDict");
}

void readLoad(const Dictionary& entry, const Mesh& mesh, BoundaryCondition& condition)
{
    readLoadPlace(entry, mesh, condition);
    if (condition.kind == Kind::pressure) {
        condition.constrains = {true, true, true};
        condition.value = {entry.number("value"), 0, 0};
        condition.amplitude = readAmplitude(entry);
    } else if (condition.kind == Kind::gravity) {
        condition.constrains = {true, true, true};
        condition.value = entry.vector("value");
        condition.amplitude = readAmplitude(entry);
    } else
        readValue(entry, condition);
}

BoundaryCondition readCondition(const Dictionary& entry, const std::string& name, const Mesh& mesh)
{
    const std::string type =
        entry.choice("type", {"fixed", "symmetry", "displacement", "velocity", "rotation", "force",
                              "traction", "pressure", "gravity"});
    BoundaryCondition condition;
    condition.name = name;
    condition.kind = kindOf(type);
    if (condition.isLoad()) {
        readLoad(entry, mesh, condition);
        return condition;
    }
    condition.nodes = selectNodes(entry, mesh);
    if (entry.has("part")) condition.part = mesh.findPart(entry.word("part"));
    if (type == "symmetry") {
        readNormal(entry, condition);
        condition.mirror = true;
    } else if (type == "fixed")
        readHeld(entry, condition);
    else if (type == "rotation")
        readTurn(entry, condition);
    else
        readValue(entry, condition);
    return condition;
}

} // namespace

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

void refuseJump(const Dictionary& entry,
                const std::string& what,
                const std::string& key,
                double size)
{
    if (size != 0)
        entry.fail(entry.has("amplitude") ? "amplitude" : key,
                   format("the {} would jump by {} at time 0", what, toText(size, 6)),
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

} // namespace fpm
