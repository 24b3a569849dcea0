#include "run/EdgeWatch.h"

#include "base/Format.h"
#include "mesh/Quality.h"
#include "mesh/Vector.h"
#include "run/Box.h"
#include "run/HealthLimits.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

Box boxOf(const Mesh& mesh, const std::vector<Point>& points, const std::vector<ElementSide>& sides)
{
    Box box;
    for (const ElementSide& side : sides)
        for (const Index node : mesh.sideNodes(side)) box.take(points[std::size_t(node)]);
    return box;
}

void warn(const EdgeFinding& found, Log& log)
{
    const Point& at = found.crossings.place;
    log.warning(format("{}: at time {} {} edges pass through the other surface between their "
                       "nodes, deepest at ({} {} {}): {}",
                       found.pair, found.time, found.crossings.count, at[0], at[1], at[2],
                       found.springs ? "contact of edges does not hold them"
                                     : "node-to-face contact does not see them"));
}

/// Width of a mean element.
double sizeOf(const Mesh& mesh)
{
    const Quality all = quality(mesh);
    return std::cbrt(all.totalVolume / double(mesh.hexahedra.size()));
}

/// Sides whose elements are not deleted; `deleted` is empty where none can be.
std::vector<ElementSide> living(std::vector<ElementSide> sides, const std::vector<bool>& deleted)
{
    if (!deleted.empty())
        std::erase_if(sides, [&](const ElementSide& s) { return deleted[std::size_t(s.element)]; });
    return sides;
}

} // namespace

bool EdgeFinding::isDeep() const
{
    return crossings.depth > HealthLimits::depthOfEdge;
}

std::string EdgeFinding::advice() const
{
    if (springs)
        return "contact of edges does not hold them: a larger normalScale, smaller elements along "
               "the edges, or a slower approach";
    return "node-to-face contact does not see edges between their nodes: 'edges yes;' in the pair, "
           "or elements along them smaller than the other body";
}

EdgeWatch::EdgeWatch(const Model& model) : model_(model), planes_(mirrorPlanes(model))
{
    // A die that ends on the plane does not move out of it, though nothing says so of its nodes.
    const double close = planes_.empty() ? 0 : 1e-6 * sizeOf(model.mesh);
    for (MirrorPlane& plane : planes_)
        for (std::size_t node = 0; node < model.mesh.points.size(); ++node)
            if (std::abs(vector::dot(model.mesh.points[node], plane.normal) - plane.distance)
                < close)
                plane.holds[node] = true;
    for (const MirrorPlane& plane : planes_) mirrors_.push_back({plane.normal, &plane.holds});
    for (const ContactPair& pair : model.contactPairs)
        for (const ContactSurfaces& surfaces : model.mesh.contact)
            if (surfaces.pair == pair.name && pair.surface < 0) add(pair, surfaces);
}

void EdgeWatch::add(const ContactPair& pair, const ContactSurfaces& surfaces)
{
    if (pair.kind == ContactKind::self) return;
    Group group{&pair, {}, {}, {}};
    if (pair.kind == ContactKind::pair)
        group.surfaces = {surfaces.contactorSides, surfaces.targetSides};
    else {
        std::map<Index, std::vector<ElementSide>> ofPart;
        for (const ElementSide& side : surfaces.contactorSides)
            ofPart[model_.mesh.partOf(side.element)].push_back(side);
        for (auto& [part, sides] : ofPart) {
            group.parts.push_back(part);
            group.surfaces.push_back(std::move(sides));
        }
    }
    for (const auto& sides : group.surfaces) sides_ += sides.size();
    groups_.push_back(std::move(group));
}

/// Parts with a pair of their own are watched there; two rigid ones have no contact.
bool EdgeWatch::mayMeet(const Group& group, std::size_t a, std::size_t b) const
{
    if (group.parts.empty()) return true;
    const Index one = group.parts[a], other = group.parts[b];
    if (isRigid(model_.parts[std::size_t(one)].kind)
        && isRigid(model_.parts[std::size_t(other)].kind))
        return false;
    return std::none_of(group.pair->apart.begin(), group.pair->apart.end(),
                        [&](const std::array<Index, 2>& two) {
                            return std::minmax(two[0], two[1]) == std::minmax(one, other);
                        });
}

std::string EdgeWatch::name(const Group& group, std::size_t a, std::size_t b) const
{
    if (group.parts.empty()) return "pair " + group.pair->name;
    return format("pair {}, parts {} and {}", group.pair->name,
                  model_.parts[std::size_t(group.parts[a])].name,
                  model_.parts[std::size_t(group.parts[b])].name);
}

double EdgeWatch::interval(const StepClock& clock) const
{
    // Seconds, of one core.
    constexpr double ofSide = 3e-6, ofElementStep = 6e-8, always = 0.1;
    constexpr double share = 0.01, most = 100;
    const double end = model_.control.endTime, steps = clock.step > 0 ? end / clock.step : 0,
                 run = steps * ofElementStep * double(model_.mesh.hexahedra.size())
                       / (model_.control.backend == "cuda" ? 100 : 1);
    const double checks = (share * run + always) / (ofSide * double(sides_ + 1));
    return end / std::clamp(checks, 1.0, most);
}

void EdgeWatch::checkIfDue(Solver& solver, Log& log)
{
    if (solver.clock().time >= next_) check(solver, log);
}

void EdgeWatch::check(Solver& solver, Log& log)
{
    next_ = solver.clock().time + interval(solver.clock());
    if (groups_.empty()) return;
    const Mesh& mesh = model_.mesh;
    std::vector<Point> points;
    const NodeValues values = solver.nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i) points.push_back(values.at(0, i));
    std::vector<bool> deleted;
    if (solver.elements().setUp().erodes) deleted = solver.elements().values().deleted;
    for (Group& group : groups_) {
        std::vector<Box> boxes;
        for (const auto& sides : group.surfaces) boxes.push_back(boxOf(mesh, points, sides));
        forBoxesThatMeet(boxes, [&](std::size_t a, std::size_t b) {
            EdgeFinding& found = group.found[{a, b}];
            if (found.isDeep() || !mayMeet(group, a, b)) return;
            const EdgeCrossings crossings =
                edgeCrossings(mesh, points, living(group.surfaces[a], deleted),
                              living(group.surfaces[b], deleted), mirrors_);
            if (!(crossings.depth > found.crossings.depth)) return;
            found = {name(group, a, b), crossings, solver.clock().time, group.pair->edges};
            if (found.isDeep()) warn(found, log);
        });
    }
}

void EdgeWatch::keep(Archive& archive)
{
    archive(next_);
    for (Group& group : groups_) {
        std::vector<std::pair<std::pair<std::size_t, std::size_t>, EdgeFinding>> all(
            group.found.begin(), group.found.end());
        archive.list(all, [](Archive& each, auto& one) {
            each(one.first.first);
            each(one.first.second);
            each(one.second.pair);
            each(one.second.crossings.count);
            each(one.second.crossings.depth);
            each(one.second.crossings.place);
            each(one.second.time);
        });
        if (!archive.reads()) continue;
        for (auto& each : all) each.second.springs = group.pair->edges;
        group.found = {all.begin(), all.end()};
    }
}

std::vector<EdgeFinding> EdgeWatch::findings() const
{
    std::vector<EdgeFinding> all;
    for (const Group& group : groups_)
        for (const auto& [surfaces, found] : group.found)
            if (found.crossings.count > 0) all.push_back(found);
    return all;
}

} // namespace fpm
