#include "model/ImposedMotion.h"

#include "model/NodeSelection.h"
#include "model/PointAlgebra.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fpm {

namespace {

using Kind = BoundaryCondition::Kind;

/// Directions closer than this are the same; rounding of normalised axes is far below.
constexpr double sameDirection = 1e-9;

/// Adds orthonormal directions one after the other.
class Span
{
public:
    std::size_t size() const { return directions_.size(); }
    const Point& operator[](std::size_t i) const { return directions_[i]; }

    /// What of `direction` is not spanned yet.
    Point rest(Point direction) const
    {
        // Twice: what rounding leaves of the first pass the second removes.
        for (int pass = 0; pass < 2; ++pass)
            for (const Point& held : directions_)
                direction = along(direction, -dot(direction, held), held);
        return direction;
    }
    void add(const Point& direction)
    {
        const Point left = rest(direction);
        const double size = length(left);
        if (size > sameDirection) directions_.push_back(along({0, 0, 0}, 1 / size, left));
    }
    /// Fills up to three directions.
    void complete()
    {
        while (directions_.size() < 3) {
            Point best{};
            for (const Point& axis : globalAxes)
                if (const Point left = rest(axis); length(left) > length(best)) best = left;
            add(best);
        }
    }

private:
    std::vector<Point> directions_;
};

struct Imposed {
    Index condition;
    Point direction;
};

class Resolver
{
public:
    explicit Resolver(const Model& model) : conditions_(model.boundaryConditions)
    {
        out_.owner.assign(3 * model.mesh.points.size(), -1);
        bodyNode_.assign(model.mesh.points.size(), false);
        for (std::size_t part = 0; part < model.parts.size(); ++part)
            if (model.parts[part].kind == PartKind::rigidFree)
                for (const Index node : nodesOfPart(model.mesh, Index(part)))
                    bodyNode_[std::size_t(node)] = true;
    }

    ImposedMotion resolve()
    {
        std::map<Index, std::vector<Imposed>> oblique; // nodes that need axes of their own
        for (const BoundaryCondition& condition : conditions_)
            if (!condition.isLoad() && !condition.isGlobal())
                for (const Index node : condition.nodes)
                    if (!bodyNode_[std::size_t(node)]) oblique[node];
        for (std::size_t number = 0; number < conditions_.size(); ++number) {
            const BoundaryCondition& condition = conditions_[number];
            if (condition.isLoad()) continue;
            for (const Index node : condition.nodes) {
                if (bodyNode_[std::size_t(node)]) continue;
                const auto own = oblique.find(node);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    if (!condition.constrains[axis]) continue;
                    if (own != oblique.end())
                        own->second.push_back({Index(number), condition.axes[axis]});
                    else
                        impose(node, axis, Index(number), globalAxes[axis]);
                }
            }
        }
        if (!oblique.empty()) out_.frameOf.assign(bodyNode_.size(), -1);
        for (const auto& [node, imposed] : oblique) place(node, imposed);
        return out_;
    }

private:
    void impose(Index node, std::size_t axis, Index condition, const Point& direction)
    {
        Index& owner = out_.owner[3 * std::size_t(node) + axis];
        if (owner >= 0 && owner != condition
            && !sameMotion(conditions_[std::size_t(owner)], conditions_[std::size_t(condition)],
                           direction))
            clash(owner, condition, node, direction, false);
        else if (owner < 0 || !holds(conditions_[std::size_t(condition)], direction))
            owner = condition;
    }

    void clash(Index earlier, Index later, Index node, const Point& direction, bool oblique)
    {
        if (!oblique && earlier > later) std::swap(earlier, later);
        for (ImposedMotion::Clash& known : out_.clashes)
            if (known.later == later) {
                known.nodes += known.node != node;
                return;
            }
        out_.clashes.push_back({earlier, later, node, direction, oblique, 1});
    }

    /// Axes of a node: what is driven keeps its directions; what is held need only be spanned.
    void place(Index node, const std::vector<Imposed>& imposed)
    {
        Span span;
        for (const bool driven : {true, false})
            for (const Imposed& one : imposed)
                if (driven != holds(conditions_[std::size_t(one.condition)], one.direction)) {
                    if (driven && crosses(span, one.direction))
                        clash(leaningOn(imposed, one.direction), one.condition, node, one.direction,
                              true);
                    span.add(one.direction);
                }
        span.complete();
        const Axes axes{span[0], span[1], span[2]};
        const auto known = numbers_.try_emplace(axes, Index(out_.frames.size())).first;
        if (known->second == Index(out_.frames.size())) out_.frames.push_back(axes);
        out_.frameOf[std::size_t(node)] = known->second;
        for (const bool driven : {true, false})
            for (const Imposed& one : imposed) {
                if (driven == holds(conditions_[std::size_t(one.condition)], one.direction))
                    continue;
                own(node, axes, one, driven);
            }
    }

    /// The first condition that imposes a direction neither along nor across `direction`.
    static Index leaningOn(const std::vector<Imposed>& imposed, const Point& direction)
    {
        for (const Imposed& one : imposed)
            if (const double share = std::abs(dot(one.direction, direction));
                share > sameDirection && share < 1 - sameDirection)
                return one.condition;
        return imposed.front().condition;
    }

    static bool crosses(const Span& span, const Point& direction)
    {
        const double left = length(span.rest(direction));
        return left > sameDirection && left < 1 - sameDirection;
    }

    /// Takes the axes that `one` imposes; a held direction must not lean on a driven one.
    void own(Index node, const Axes& axes, const Imposed& one, bool driven)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double share = std::abs(dot(axes[axis], one.direction));
            if (share <= sameDirection) continue;
            const Index earlier = out_.ownerOf(node, axis);
            const bool drivenAxis =
                earlier >= 0 && !holds(conditions_[std::size_t(earlier)], axes[axis]);
            if (!driven && drivenAxis && share < 1 - sameDirection)
                clash(earlier, one.condition, node, one.direction, true);
            else
                impose(node, axis, one.condition, axes[axis]);
        }
    }

    const std::vector<BoundaryCondition>& conditions_;
    std::vector<bool> bodyNode_;
    std::map<Axes, Index> numbers_;
    ImposedMotion out_;
};

} // namespace

bool holds(const BoundaryCondition& condition, const Point& direction)
{
    if (condition.kind == Kind::fixed) return true;
    if (condition.kind == Kind::rotation) return condition.angle == 0;
    const Point value = condition.globalValue();
    return std::abs(dot(value, direction)) <= sameDirection * length(value);
}

bool sameMotion(const BoundaryCondition& a, const BoundaryCondition& b, const Point& direction)
{
    if (holds(a, direction) && holds(b, direction)) return true;
    if (a.kind != b.kind || a.amplitude != b.amplitude) return false;
    if (a.kind == Kind::rotation) return a.line == b.line && a.angle == b.angle;
    return std::abs(dot(a.globalValue(), direction) - dot(b.globalValue(), direction))
           <= sameDirection * length(a.globalValue());
}

ImposedMotion imposedMotion(const Model& model)
{
    return Resolver(model).resolve();
}

HeldBody heldBody(const Model& model, Index part)
{
    Span translations, turns;
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        if (condition.kind != Kind::fixed || condition.part != part) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (condition.constrains[axis]) translations.add(condition.axes[axis]);
            if (condition.turns[axis]) turns.add(condition.axes[axis]);
        }
    }
    HeldBody held;
    for (std::size_t axis = 0; axis < translations.size(); ++axis) held.translations[axis] = true;
    held.turns = 3 - int(turns.size());
    translations.complete();
    turns.complete();
    held.axes = {translations[0], translations[1], translations[2]};
    if (held.turns == 1) held.axis = turns[2];
    return held;
}

std::array<double, 2>
pathFactors(const BoundaryCondition& condition, const Point& position, const Point& direction)
{
    if (condition.kind != Kind::rotation) return {dot(condition.globalValue(), direction), 0};
    const auto& [centre, axis] = condition.line;
    const Point side = vector::cross(axis, difference(position, centre));
    return {dot(side, direction), dot(vector::cross(axis, side), direction)};
}

} // namespace fpm
