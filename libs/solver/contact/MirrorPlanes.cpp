#include "solver/contact/MirrorPlanes.h"

#include "base/Error.h"
#include "base/Format.h"
#include "mesh/Vector.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

/// The direction that a condition of symmetry holds.
Point normalOf(const BoundaryCondition& mirror)
{
    const auto held = std::find(mirror.constrains.begin(), mirror.constrains.end(), true);
    return mirror
        .axes[held == mirror.constrains.end() ? 0 : std::size_t(held - mirror.constrains.begin())];
}

/// `near`: length below which planes are one, more than meshes are off a plane.
bool isSame(const MirrorPlane& plane, const Point& normal, double distance, double near)
{
    const double cosine = vector::dot(plane.normal, normal); // -1: told the other way
    return std::abs(std::abs(cosine) - 1) < 1e-9
           && std::abs(plane.distance - cosine * distance) < near;
}

double diagonal(const std::vector<Point>& points)
{
    Point least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
    for (const Point& point : points)
        for (std::size_t c = 0; c < 3; ++c) {
            least[c] = std::min(least[c], point[c]);
            most[c] = std::max(most[c], point[c]);
        }
    return std::hypot(most[0] - least[0], most[1] - least[1], most[2] - least[2]);
}

constexpr std::size_t most = 8; ///< bits of a contactor

[[noreturn]] void refuse(const BoundaryCondition& condition)
{
    throw Error(
        ExitCode::dictionary,
        format("with '{}' the scene has more than {} planes of symmetry, which contact cannot "
               "tell apart",
               condition.name, most),
        "hold nodes inside a body, and some of the planes, by type fixed");
}

} // namespace

std::vector<MirrorPlane> mirrorPlanes(const Model& model)
{
    std::vector<MirrorPlane> planes;
    const double near = 1e-5 * diagonal(model.mesh.points);
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        if (!condition.mirror || condition.nodes.empty()) continue;
        const Point normal = normalOf(condition);
        for (const Index node : condition.nodes) { // those of a layer may lie on its two sides
            const double distance = vector::dot(normal, model.mesh.points[std::size_t(node)]);
            auto plane = std::find_if(planes.begin(), planes.end(), [&](const MirrorPlane& known) {
                return isSame(known, normal, distance, near);
            });
            if (plane == planes.end()) {
                if (planes.size() == most) refuse(condition);
                plane = planes.insert(
                    plane, {normal, distance, std::vector<bool>(model.mesh.points.size())});
            }
            plane->holds[std::size_t(node)] = true;
        }
    }
    return planes;
}

} // namespace fpm
