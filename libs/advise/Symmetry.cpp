#include "advise/Symmetry.h"

#include "base/Format.h"
#include "mesh/Surface.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

using Surface = RigidSurface;

/// Directions the formulation of a part's elements prefers.
ElementAxes axesOf(const Part& part)
{
    if (isRigid(part.kind) || part.hexahedron == HexahedronForm::selective)
        return ElementAxes::none;
    if (part.hourglass == HourglassForm::physical) return ElementAxes::all;
    return part.rotation == RotationForm::midSurface ? ElementAxes::zeta : ElementAxes::none;
}

std::string partObstacle(const Model& model)
{
    for (const Part& part : model.parts) {
        if (!isRigid(part.kind) && part.hexahedron == HexahedronForm::reduced
            && part.rotation == RotationForm::arcsine)
            return format("part {} has rotation arcsin, which treats the two directions of "
                          "rotation differently",
                          part.name);
        if (part.kind == PartKind::rigidFree && (part.inertia.mass > 0 || part.inertia.hasInertia))
            return format("part {} has mass or inertia given by numbers, which cannot be halved "
                          "with the mesh",
                          part.name);
    }
    return "";
}

bool contains(const std::vector<Index>& ascending, Index node)
{
    return std::binary_search(ascending.begin(), ascending.end(), node);
}

/// Whether nodes or sides are their own image.
bool isOwnImage(const std::vector<Index>& nodes, const MirrorMap& map)
{
    return std::all_of(nodes.begin(), nodes.end(),
                       [&](Index n) { return contains(nodes, map.node[std::size_t(n)]); });
}

bool isOwnImage(const Mesh& mesh, const std::vector<ElementSide>& sides, const MirrorMap& map)
{
    return std::all_of(sides.begin(), sides.end(), [&](const ElementSide& side) {
        return std::binary_search(sides.begin(), sides.end(), map.image(mesh, side));
    });
}

/// A surface that moves across the plane, or lies differently on its two sides.
bool isOwnImage(const Surface& surface, const MirrorPlane& plane, double tolerance)
{
    const std::size_t a = plane.axis;
    const auto isOn = [&](const Point& p) { return std::abs(p[a] - plane.place) <= tolerance; };
    if (surface.motion != Surface::Motion::none && surface.value[a] != 0) return false;
    if (surface.kind == Surface::Kind::sphere) return isOn(surface.point);
    if (surface.axis[a] == 0) return surface.kind == Surface::Kind::plane || isOn(surface.point);
    if (surface.kind == Surface::Kind::plane || std::abs(surface.axis[a]) != 1) return false;
    Point middle = surface.point;
    middle[a] += 0.5 * surface.length * surface.axis[a];
    return surface.infinite || isOn(middle);
}

bool touches(const Model& model, const std::vector<ElementSide>& sides, PartKind kind)
{
    return std::any_of(sides.begin(), sides.end(), [&](const ElementSide& side) {
        return model.parts[std::size_t(model.mesh.partOf(side.element))].kind == kind;
    });
}

std::string pairObstacle(const Model& model, const ContactPair& pair, const MirrorMap& map)
{
    if (pair.kind == ContactKind::general)
        return "general contact takes the whole skin of every part, and a cut would add to it; "
               "pairs can be cut";
    if (pair.edges)
        return format("pair {} has contact of edges, of which those in a plane of symmetry make no "
                      "force",
                      pair.name);
    if (!isOwnImage(pair.contactorNodes, map) || !isOwnImage(model.mesh, pair.targetSides, map))
        return format("the surfaces of contact pair {} are not their own mirror image", pair.name);
    for (const ContactSurfaces& surfaces : model.mesh.contact) {
        if (surfaces.pair != pair.name) continue;
        if (!isOwnImage(model.mesh, surfaces.contactorSides, map))
            return format("the contactor of contact pair {} is not its own mirror image",
                          pair.name);
        if (touches(model, surfaces.contactorSides, PartKind::rigidFree)
            || (pair.passes == 2 && touches(model, pair.targetSides, PartKind::rigidFree)))
            return format("contactors of pair {} belong to a rigidFree part: half a body of that "
                          "kind has no nodes held on the mirror plane, which would be half nodes",
                          pair.name);
    }
    if (pair.surface < 0) return "";
    const Surface& surface = model.rigidSurfaces[std::size_t(pair.surface)];
    if (isOwnImage(surface, map.plane, mirrorTolerance(model.mesh))) return "";
    return format("surface {} is not its own mirror image", surface.name);
}

MirrorPlane middlePlane(const Mesh& mesh, std::size_t axis)
{
    double low = mesh.points.front()[axis], high = low;
    for (const Point& p : mesh.points) {
        low = std::min(low, p[axis]);
        high = std::max(high, p[axis]);
    }
    const double place = 0.5 * (low + high);
    // What rounding left of a plane through the origin.
    return {axis, std::abs(place) <= 1e-12 * (high - low) ? 0.0 : place};
}

} // namespace

std::vector<Point> initialVelocities(const Model& model)
{
    std::vector<Point> out(model.mesh.points.size(), Point{0, 0, 0});
    for (const InitialVelocity& initial : model.initialVelocities)
        if (!initial.rotates)
            for (const Index node : initial.nodes) out[std::size_t(node)] = initial.velocity;
    for (const InitialVelocity& initial : model.initialVelocities)
        if (initial.rotates)
            for (const Index node : initial.nodes) {
                const Point v = initial.at(model.mesh.points[std::size_t(node)]);
                for (std::size_t c = 0; c < 3; ++c) out[std::size_t(node)][c] += v[c];
            }
    return out;
}

std::string initialObstacle(const Model& model, const MirrorMap& map)
{
    const std::vector<Point> velocity = initialVelocities(model);
    double most = 0;
    for (const Point& v : velocity)
        for (const double c : v) most = std::max(most, std::abs(c));
    for (std::size_t node = 0; node < velocity.size(); ++node) {
        if (map.node[node] < 0) continue;
        const Point image = map.plane.imageOfVector(velocity[node]);
        const Point& there = velocity[std::size_t(map.node[node])];
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(image[c] - there[c]) > 1e-9 * most)
                return format("the initial velocity of node {} is not mirrored at node {}", node,
                              map.node[node]);
    }
    return "";
}

std::string contactObstacle(const Model& model, const MirrorMap& map)
{
    for (const ContactPair& pair : model.contactPairs)
        if (const std::string why = pairObstacle(model, pair, map); !why.empty()) return why;
    return "";
}

std::vector<MirrorMap> findSymmetry(const Model& model)
{
    std::vector<ElementAxes> axes;
    for (const Part& part : model.parts) axes.push_back(axesOf(part));
    std::vector<MirrorMap> found;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        MirrorMap map = mirrorMesh(model.mesh, middlePlane(model.mesh, axis), axes);
        if (map.holds()) map.obstacle = partObstacle(model);
        if (map.holds()) map.obstacle = conditionObstacle(model, map);
        if (map.holds()) map.obstacle = initialObstacle(model, map);
        if (map.holds()) map.obstacle = contactObstacle(model, map);
        found.push_back(std::move(map));
    }
    return found;
}

} // namespace fpm
