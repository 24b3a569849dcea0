#include "run/ContactPressure.h"

#include "mesh/Vector.h"

#include <algorithm>

namespace fpm {

namespace {

/// Every side of a contact surface once, however many pairs have it.
std::vector<ElementSide> contactSides(const Mesh& mesh, const std::vector<bool>& deleted)
{
    std::vector<ElementSide> sides;
    for (const ContactSurfaces& surfaces : mesh.contact)
        for (const auto* of : {&surfaces.contactorSides, &surfaces.targetSides})
            sides.insert(sides.end(), of->begin(), of->end());
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    if (!deleted.empty())
        std::erase_if(sides, [&](const ElementSide& s) { return deleted[std::size_t(s.element)]; });
    return sides;
}

} // namespace

std::vector<double> contactPressure(const Model& model,
                                    const std::vector<Point>& points,
                                    const std::vector<Point>& force,
                                    const std::vector<bool>& deleted)
{
    using namespace vector;
    std::vector<Point> area(points.size(), Point{0, 0, 0}); // outward
    for (const ElementSide& side : contactSides(model.mesh, deleted)) {
        const Quad quad = model.mesh.sideNodes(side);
        const auto x = [&](std::size_t k) { return points[std::size_t(quad[k])]; };
        const Point share = scaled(cross(difference(x(2), x(0)), difference(x(3), x(1))), 0.125);
        for (const Index node : quad) area[std::size_t(node)] = sum(area[std::size_t(node)], share);
    }
    std::vector<double> pressure;
    for (std::size_t node = 0; node < points.size(); ++node) {
        const double square = dot(area[node], area[node]);
        pressure.push_back(square > 0 ? -dot(force[node], area[node]) / square : 0);
    }
    return pressure;
}

} // namespace fpm
