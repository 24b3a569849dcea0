#include "advise/Symmetry.h"
#include "base/Format.h"
#include "mesh/Surface.h"
#include "mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fpm {

namespace {

using Kind = BoundaryCondition::Kind;

/// A direction and what is imposed along it. The sign is that of the first component that is not 0.
struct Row {
    Point direction;
    double value;
};

/// What a condition says, apart from where: two conditions of equal content do the same.
struct Content {
    Kind kind = Kind::fixed;
    bool mirror = false;
    Index body = -1; ///< the rigidFree part it holds as a whole
    Amplitude amplitude;
    std::vector<Row> rows;   ///< held or driven directions; else the vector of a load
    std::vector<Row> turns;  ///< rotations held
    std::vector<Point> line; ///< rotation: point of the axis nearest to the origin, axis times
                             ///< angle
};

Row canonical(Row row)
{
    for (const double c : row.direction) {
        if (std::abs(c) < 1e-12) continue;
        if (c < 0) return {vector::scaled(row.direction, -1), -row.value};
        break;
    }
    return row;
}

void sortRows(std::vector<Row>& rows)
{
    for (Row& row : rows) row = canonical(row);
    std::sort(rows.begin(), rows.end(),
              [](const Row& a, const Row& b) { return a.direction < b.direction; });
}

/// Point of a line nearest to the origin: the same for every point that defines the line.
std::vector<Point> lineOf(const std::array<Point, 2>& line, double angle)
{
    const double along = vector::dot(line[0], line[1]);
    return {vector::difference(line[0], vector::scaled(line[1], along)),
            vector::scaled(line[1], angle)};
}

Content contentOf(const Model& model, const BoundaryCondition& condition)
{
    Content out;
    out.kind = condition.kind;
    out.mirror = condition.mirror;
    out.amplitude = condition.amplitude;
    if (condition.part >= 0 && model.parts[std::size_t(condition.part)].kind == PartKind::rigidFree)
        out.body = condition.part;
    if (condition.kind == Kind::rotation)
        out.line = lineOf(condition.line, condition.angle);
    else if (condition.kind == Kind::pressure)
        out.rows = {{{0, 0, 0}, condition.value[0]}};
    else if (condition.isLoad())
        out.rows = {{condition.globalValue(), 1}};
    else
        for (std::size_t i = 0; i < 3; ++i) {
            if (condition.constrains[i])
                out.rows.push_back(canonical({condition.axes[i], condition.value[i]}));
            if (condition.turns[i]) out.turns.push_back(canonical({condition.axes[i], 0}));
        }
    if (!condition.isLoad()) sortRows(out.rows);
    sortRows(out.turns);
    return out;
}

Content imageOf(Content content, const MirrorPlane& plane)
{
    for (Row& row : content.rows) row.direction = plane.imageOfVector(row.direction);
    for (Row& row : content.turns) row.direction = plane.imageOfVector(row.direction);
    if (content.kind < Kind::force) sortRows(content.rows);
    sortRows(content.turns);
    if (!content.line.empty()) {
        // An axis of rotation is no arrow: its part across the plane stays, that in it turns round.
        const Point axis = plane.imageOfVector(vector::scaled(content.line[1], -1));
        const double size = vector::length(axis);
        const Point unit = size > 0 ? vector::scaled(axis, 1 / size) : axis;
        content.line = lineOf({plane.image(content.line[0]), unit}, size);
    }
    return content;
}

bool near(const Point& a, const Point& b, double size)
{
    return vector::length(vector::difference(a, b)) <= 1e-9 * size;
}

bool same(const std::vector<Row>& a, const std::vector<Row>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Row& x, const Row& y) {
        return near(x.direction, y.direction, std::max(1e-300, vector::length(x.direction)))
               && std::abs(x.value - y.value) <= 1e-9 * std::abs(x.value);
    });
}

/// Lines agree where every point of the mesh turns alike; angles count with their sign.
bool sameLine(const Content& a, const Content& b, double size)
{
    if (a.line.size() != b.line.size()) return false;
    if (a.line.empty()) return true;
    return near(a.line[0], b.line[0], size)
           && near(a.line[1], b.line[1], std::max(1e-300, vector::length(a.line[1])));
}

bool same(const Content& a, const Content& b, double size)
{
    return a.kind == b.kind && a.mirror == b.mirror && a.body == b.body
           && a.amplitude == b.amplitude && same(a.rows, b.rows) && same(a.turns, b.turns)
           && sameLine(a, b, size);
}

/// What a condition acts on. Parts are their own images.
enum class Target { nodes, sides, parts };

Target targetOf(const BoundaryCondition& condition)
{
    if (condition.kind == Kind::gravity) return Target::parts;
    return condition.sides.empty() ? Target::nodes : Target::sides;
}

/// How much of a condition each of them gets; sides are numbered 6 element + side.
using Weights = std::map<Index, double>;

void addWeights(const Model& model, const BoundaryCondition& condition, Weights& weights)
{
    const auto number = [](const ElementSide& side) { return 6 * side.element + side.side; };
    if (condition.kind == Kind::gravity) {
        for (const Index part : condition.parts) weights[part] += 1;
        return;
    }
    if (condition.kind == Kind::force && condition.sides.empty()) {
        for (const Index node : condition.nodes)
            weights[node] += 1 / double(condition.nodes.size());
        return;
    }
    if (!condition.isLoad()) {
        for (const Index node : condition.nodes) weights[node] = 1;
        return;
    }
    double total = 1;
    if (condition.kind == Kind::force) {
        total = 0;
        for (const ElementSide& side : condition.sides) total += area(model.mesh, side);
    }
    for (const ElementSide& side : condition.sides)
        weights[number(side)] += condition.kind == Kind::force ? area(model.mesh, side) / total : 1;
}

Index imageOf(const Model& model, const MirrorMap& map, Target target, Index number)
{
    if (target == Target::parts) return number;
    if (target == Target::nodes) return map.node[std::size_t(number)];
    const ElementSide image = map.image(model.mesh, {number / 6, number % 6});
    return 6 * image.element + image.side;
}

/// Conditions of equal content and what they do together.
struct Group {
    Content content;
    std::string name; ///< of the first condition
    Target target = Target::nodes;
    Weights weights;
};

std::vector<Group> groupsOf(const Model& model, double size)
{
    std::vector<Group> groups;
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        const Content content = contentOf(model, condition);
        const Target target = targetOf(condition);
        auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
            return g.target == target && same(g.content, content, size);
        });
        if (group == groups.end())
            group = groups.insert(groups.end(), {content, condition.name, target, {}});
        addWeights(model, condition, group->weights);
    }
    return groups;
}

} // namespace

std::string conditionObstacle(const Model& model, const MirrorMap& map)
{
    const double size = 1e9 * mirrorTolerance(model.mesh);
    const std::vector<Group> groups = groupsOf(model, size);
    for (const Group& group : groups) {
        const Content image = imageOf(group.content, map.plane);
        const auto other = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
            return g.target == group.target && same(g.content, image, size);
        });
        if (other == groups.end())
            return format("no condition mirrors what '{}' imposes", group.name);
        if (group.weights.size() != other->weights.size())
            return format(
                "'{}' and its mirror image '{}' act on other numbers of nodes, sides or parts",
                group.name, other->name);
        for (const auto& [number, weight] : group.weights) {
            const auto there = other->weights.find(imageOf(model, map, group.target, number));
            if (there == other->weights.end() || std::abs(there->second - weight) > 1e-9 * weight)
                return format("'{}' acts on {} {}, and nothing alike on its mirror image",
                              group.name,
                              group.target == Target::sides ? "a side of element" : "node",
                              group.target == Target::sides ? number / 6 : number);
        }
    }
    return "";
}

} // namespace fpm
