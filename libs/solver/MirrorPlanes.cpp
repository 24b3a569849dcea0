#include "solver/MirrorPlanes.h"

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

bool isSame(const MirrorPlane& plane, const Point& normal, double distance)
{
    const double cosine = vector::dot(plane.normal, normal), near = 1e-9; // -1: told the other way
    return std::abs(std::abs(cosine) - 1) < near
           && std::abs(plane.distance - cosine * distance) < near * (1 + std::abs(distance));
}

} // namespace

std::vector<MirrorPlane> mirrorPlanes(const Model& model)
{
    std::vector<MirrorPlane> planes;
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        if (!condition.mirror || condition.nodes.empty()) continue;
        const Point normal = normalOf(condition);
        const double distance =
            vector::dot(normal, model.mesh.points[std::size_t(condition.nodes.front())]);
        auto plane = std::find_if(planes.begin(), planes.end(), [&](const MirrorPlane& known) {
            return isSame(known, normal, distance);
        });
        if (plane == planes.end())
            plane = planes.insert(plane,
                                  {normal, distance, std::vector<bool>(model.mesh.points.size())});
        for (const Index node : condition.nodes) plane->holds[std::size_t(node)] = true;
    }
    if (planes.size() > 8)
        throw Error(ExitCode::dictionary,
                    format("{} planes of symmetry meet a contact pair, 8 at most are possible",
                           planes.size()),
                    "hold some of them by type fixed");
    return planes;
}

} // namespace fpm
