#pragma once

#include "unit/solver/scenes.h"

namespace fpm::test {

inline Part metal()
{
    return aluminium(PartKind::elastic, HourglassForm::physical);
}

/// All exterior faces against all, as fpmSetContact makes it of `general;`.
inline ContactPair& addGeneral(Model& model)
{
    std::vector<ElementSide> sides;
    for (std::size_t part = 0; part < model.mesh.parts.size(); ++part)
        for (const ElementSide& side : skin(model.mesh, Index(part))) sides.push_back(side);
    std::sort(sides.begin(), sides.end());
    ContactPair& pair = addContact(model, "general", sides, sides);
    pair.kind = ContactKind::general;
    return pair;
}

/// A U of one part whose upper arm is driven on the lower one.
inline Model closingFold()
{
    Model model;
    addBox(model.mesh, "fold", {12, 2, 5}, {0, 0, 0}, {6, 1, 2.5});
    Mesh& mesh = model.mesh;
    std::vector<Hexahedron> kept;
    for (const Hexahedron& h : mesh.hexahedra) { // a slot of one layer, open at x = 6
        double x = 0, z = 0;
        for (const Index node : h) {
            x += mesh.points[std::size_t(node)][0] / 8;
            z += mesh.points[std::size_t(node)][2] / 8;
        }
        if (!(x > 1 && z > 1 && z < 1.5)) kept.push_back(h);
    }
    mesh.hexahedra = kept;
    mesh.parts[0].elementCount = Index(kept.size());
    std::vector<Index> number(mesh.points.size(), -1);
    std::vector<Point> points;
    for (Hexahedron& h : mesh.hexahedra)
        for (Index& node : h) {
            if (number[std::size_t(node)] < 0) {
                number[std::size_t(node)] = Index(points.size());
                points.push_back(mesh.points[std::size_t(node)]);
            }
            node = number[std::size_t(node)];
        }
    mesh.points = points;
    renumber(mesh);
    model.parts = {metal()};
    holdFixed(model, nodesWhere(mesh, [](Point p) { return p[2] < 0.01; }));
    model.initialVelocities.push_back(
        {"close", nodesWhere(mesh, [](Point p) { return p[2] > 1.4 && p[0] > 3; }), {0, 0, -2e5}});
    model.control.backend = "serial";
    return model;
}

/// A stiff stamp through a soft plate, in a plane x = 0 of mirror symmetry: whole, or its half
/// x >= 0.
inline Model punch(bool half, double friction)
{
    Model model;
    const Index sides = half ? 1 : 2;
    const auto low = [&](double width) { return half ? 0 : -width; };
    addBox(model.mesh, "plate", {3 * sides, 6, 2}, {low(3), -3, -1}, {3.0 * sides, 6, 1});
    addBox(model.mesh, "stamp", {2 * sides, 3, 4}, {low(1.3), -0.9, 0.01}, {1.3 * sides, 1.8, 4});
    renumber(model.mesh, 32);
    Part soft = aluminium(PartKind::elastoplastic, HourglassForm::stiffness, "plate");
    soft.erosion.plasticStrain = 0.3;
    Part stiff = aluminium(PartKind::elastic, HourglassForm::stiffness, "stamp");
    stiff.youngsModulus = 210000;
    stiff.density = 7.85e-9;
    model.parts = {soft, stiff};
    holdFixed(model, nodesWhere(model.mesh, [](Point p) {
                  return std::max(std::abs(p[0]), std::abs(p[1])) > 2.99;
              }));
    if (half) {
        model.boundaryConditions.push_back(condition(
            BoundaryCondition::Kind::fixed, "mirror",
            nodesWhere(model.mesh, [](Point p) { return p[0] == 0; }), {true, false, false}));
        model.boundaryConditions.back().mirror = true;
    }
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "stamp"), {0, 0, -4e5}});
    addContact(model, "touch", facing(model.mesh, "stamp", {0, 0, -1}),
               facing(model.mesh, "plate", {0, 0, 1}))
        .friction = friction;
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

} // namespace fpm::test
