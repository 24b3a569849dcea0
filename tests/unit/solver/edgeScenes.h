#pragma once

#include "unit/solver/kindScenes.h"

namespace fpm::test {

/// A box turned by 45 degrees about its longest axis (0 or 1), an edge up or down: its middle at
/// height `middle`.
inline void addRoof(Mesh& mesh,
                    const std::string& name,
                    std::size_t axis,
                    std::array<Index, 2> cells, ///< along and across
                    std::array<double, 2> size,
                    double middle)
{
    const std::size_t first = mesh.points.size(), across = 1 - axis;
    std::array<Index, 3> all{cells[1], cells[1], cells[1]};
    Point lengths{size[1], size[1], size[1]};
    all[axis] = cells[0];
    lengths[axis] = size[0];
    addBox(mesh, name, all, {-0.5 * lengths[0], -0.5 * lengths[1], -0.5 * lengths[2]}, lengths);
    const double half = std::sqrt(0.5);
    for (std::size_t i = first; i < mesh.points.size(); ++i) {
        Point& p = mesh.points[i];
        const double a = p[across], z = p[2];
        p[across] = half * (a - z);
        p[2] = half * (a + z) + middle;
    }
}

inline Part steel(const std::string& name)
{
    Part part = aluminium(PartKind::elastic, HourglassForm::physical, name);
    part.youngsModulus = 210000;
    part.density = 7.85e-9;
    return part;
}

/// Two roofs of steel edge on edge, `gap` apart: "low" along x, "high" along y, each of 10 x 10 mm
/// across, in general contact that sees edges.
inline Model crossedRoofs(std::array<Index, 2> cells, double length, double gap, Point velocity)
{
    Model model;
    const double half = 10 * std::sqrt(0.5);
    addRoof(model.mesh, "low", 0, cells, {length, 10}, -half);
    addRoof(model.mesh, "high", 1, cells, {length, 10}, half + gap);
    renumber(model.mesh, 64);
    model.parts = {steel("low"), steel("high")};
    throwPart(model, "high", velocity);
    addGeneral(model).edges = true;
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

/// Roofs that strike and slide with friction, over the joints of both at 15/7 mm from the middle.
inline Model slidingRoofs()
{
    Model model = crossedRoofs({7, 2}, 30, 0.01, {8e4, 6e4, -2e4});
    for (const Index node : nodesOfPart(model.mesh, "high")) {
        model.mesh.points[std::size_t(node)][0] += 2.05;
        model.mesh.points[std::size_t(node)][1] += 1.98;
    }
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -13; }));
    model.contactPairs[0].friction = 0.2;
    return model;
}

} // namespace fpm::test
