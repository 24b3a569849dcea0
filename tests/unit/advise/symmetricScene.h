#pragma once

#include "mesh/Patches.h"
#include "stability/SceneTools.h"
#include "support/TemporaryFolder.h"
#include "support/solverModel.h"

namespace fpm::test {

/// A block of 4 x 2 x 2 that falls on one of 6 x 4 x 1, its own mirror image in x = 0 and y = 1:
/// held below, pressed on top, pulled to both sides in x by conditions that mirror each other.
inline Model symmetricScene()
{
    Model model;
    Mesh& mesh = model.mesh;
    addBox(mesh, "lower", {6, 4, 1}, {-3, -1, -1}, {6, 4, 1});
    addBox(mesh, "upper", {4, 2, 2}, {-1, 0.5, 0}, {2, 1, 1});
    renumber(mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::physical, "lower"),
                   aluminium(PartKind::elastoplastic, HourglassForm::stiffness, "upper")};
    const auto add = [&](BoundaryCondition::Kind kind, const char* name, Point value,
                         std::vector<Index> nodes, std::array<bool, 3> components) {
        BoundaryCondition condition;
        condition.kind = kind;
        condition.name = name;
        condition.value = value;
        condition.constrains = components;
        condition.nodes = std::move(nodes);
        model.boundaryConditions.push_back(condition);
    };
    using Kind = BoundaryCondition::Kind;
    const std::array all{true, true, true}, alongX{true, false, false}, alongZ{false, false, true};
    add(Kind::fixed, "ground", {0, 0, 0}, nodesWhere(mesh, [](Point p) { return p[2] == -1; }),
        all);
    add(Kind::velocity, "left", {-5, 0, 0},
        nodesWhere(mesh, [](Point p) { return p[0] == -3 && p[2] > -1; }), alongX);
    add(Kind::velocity, "right", {5, 0, 0},
        nodesWhere(mesh, [](Point p) { return p[0] == 3 && p[2] > -1; }), alongX);
    add(Kind::force, "weight", {0, 0, -8}, nodesWhere(mesh, [](Point p) { return p[2] == 1; }),
        alongZ);
    InitialVelocity fall;
    fall.name = "fall";
    fall.nodes = nodesOfPart(mesh, 1);
    fall.velocity = {0, 0, -1e3};
    fall.part = 1;
    model.initialVelocities = {fall};
    ContactPair pair;
    pair.name = "touch";
    const auto contactor = facing(mesh, "upper", {0, 0, -1});
    pair.targetSides = facing(mesh, "lower", {0, 0, 1});
    pair.contactorNodes = nodesOf(mesh, contactor);
    mesh.contact.push_back({pair.name, pair.contactorNodes, contactor, pair.targetSides});
    model.contactPairs = {pair};
    model.control.endTime = 1e-4;
    return model;
}

} // namespace fpm::test
