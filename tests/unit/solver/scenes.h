#pragma once

#include "stability/SceneTools.h"
#include "support/solverModel.h"

#include <algorithm>
#include <cmath>

namespace fpm::test {

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

inline double largestStress(Solver& solver)
{
    double most = 0;
    for (const double s : solver.elements().values().stress) most = std::max(most, std::abs(s));
    return most;
}

} // namespace fpm::test
