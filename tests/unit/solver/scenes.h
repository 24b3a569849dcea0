#pragma once

#include "mesh/Surface.h"
#include "model/NodeSelection.h"
#include "solver/Solver.h"
#include "support/solverModel.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace fpm::test {

/// Outer sides of a part that look along `direction` (within 45 degrees).
inline std::vector<ElementSide> facing(const Mesh& mesh, const std::string& part, Point direction)
{
    std::vector<ElementSide> chosen;
    for (const ElementSide& side : skin(mesh, mesh.findPart(part))) {
        const Point n = normal(mesh, side);
        if (n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2] > 0.7)
            chosen.push_back(side);
    }
    return chosen;
}

/// Nodes of the mesh whose position satisfies `here`, ascending.
inline std::vector<Index> nodesWhere(const Mesh& mesh, const std::function<bool(Point)>& here)
{
    std::vector<Index> nodes;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        if (here(mesh.points[i])) nodes.push_back(Index(i));
    return nodes;
}

/// Nodes of a part, ascending.
inline std::vector<Index> nodesOfPart(const Mesh& mesh, const std::string& name)
{
    return fpm::nodesOfPart(mesh, mesh.findPart(name));
}

/// Enters a contact pair between two lists of sides into the model and its mesh.
inline ContactPair& addContact(Model& model,
                               const std::string& name,
                               const std::vector<ElementSide>& contactor,
                               const std::vector<ElementSide>& target)
{
    ContactPair pair;
    pair.name = name;
    pair.contactorNodes = nodesOf(model.mesh, contactor);
    pair.targetSides = target;
    model.mesh.contact.push_back({name, pair.contactorNodes, contactor, target});
    model.contactPairs.push_back(pair);
    return model.contactPairs.back();
}

inline BoundaryCondition condition(BoundaryCondition::Kind kind,
                                   const std::string& name,
                                   const std::vector<Index>& nodes,
                                   std::array<bool, 3> components,
                                   Point value = {0, 0, 0},
                                   const Amplitude& amplitude = {})
{
    BoundaryCondition made;
    made.kind = kind;
    made.name = name;
    made.nodes = nodes;
    made.constrains = components;
    made.value = value;
    made.amplitude = amplitude;
    return made;
}

inline void holdFixed(Model& model, const std::vector<Index>& nodes)
{
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::fixed, "fixed", nodes, {true, true, true}));
}

/// A small block falling on a larger one from a height of `gap`, their faces not matching.
/// Renumbered into patches of at most 32 elements.
inline Model
twoBlocks(const Part& upper, const Part& lower, Point velocity, double friction, double gap = 0)
{
    Model model;
    addBox(model.mesh, "lower", {8, 7, 4}, {-2, -2, -4}, {12, 11, 4});
    addBox(model.mesh, "upper", {5, 4, 5}, {1, 1, gap}, {6, 5, 6});
    renumber(model.mesh, 32);
    model.parts = {lower, upper};
    model.parts[0].name = "lower";
    model.parts[1].name = "upper";
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "upper"), velocity});
    ContactPair& pair = addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                                   facing(model.mesh, "lower", {0, 0, 1}));
    pair.friction = friction;
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

/// Started, ready to advance.
inline std::unique_ptr<Solver> startedSolver(const Model& model, bool audit = false)
{
    std::unique_ptr<Solver> solver = makeSolver(model, audit);
    solver->start();
    return solver;
}

/// v^(n-1/2), the velocity the solver keeps, from the v^n it tells.
inline std::vector<Point> halfStepVelocities(Solver& solver)
{
    const NodeValues values = solver.nodeValues({});
    const double half = 0.5 * solver.clock().step;
    std::vector<Point> out(values.count);
    for (std::size_t i = 0; i < values.count; ++i) {
        const Point v = values.at(1, i), a = values.at(2, i);
        for (std::size_t c = 0; c < 3; ++c) out[i][c] = v[c] - half * a[c];
    }
    return out;
}

/// Linear momentum of the nodes in `list` (all when empty) at v^(n-1/2).
inline Point momentum(Solver& solver, const std::vector<Index>& list = {})
{
    const std::vector<Point> v = halfStepVelocities(solver);
    const std::vector<double>& mass = solver.data().nodeMass;
    Point sum{0, 0, 0};
    const auto add = [&](std::size_t i) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += mass[i] * v[i][c];
    };
    if (list.empty())
        for (std::size_t i = 0; i < v.size(); ++i) add(i);
    for (const Index node : list) add(std::size_t(node));
    return sum;
}

inline double largestStress(Solver& solver)
{
    double most = 0;
    for (const double s : solver.elementValues().stress) most = std::max(most, std::abs(s));
    return most;
}

} // namespace fpm::test
