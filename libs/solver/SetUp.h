#pragma once

#include "solver/bodies/BodySetUp.h"
#include "solver/contact/ContactSetUp.h"
#include "solver/elements/ElementSetUp.h"
#include "solver/nodes/NodeSetUp.h"

namespace fpm {

/// Everything the solver uploads, in double and in the layout of the kernels.
struct SolverSetUp {
    ElementSetUp elements;
    NodeSetUp nodes;
    BodySetUp bodies;
    ContactSetUp contact;
};

/// Sets up a validated model. Throws Error(mesh) for an element without volume. `audit`: see
/// makeSolver.
SolverSetUp makeSetUp(const Model& model, bool audit = false);
/// Which nodes each patch moves itself, and NodeSetUp::listed; at the end, and when contact has
/// changed.
void shareNodes(SolverSetUp& data);
/// Patches, their tables, partial sums and kernel groups; masses with mass scaling. First of all.
void addElements(SolverSetUp& data, const Model& model);
/// Conditions, initial velocities and bodies; after masses, before contact.
void addMotion(SolverSetUp& data, const Model& model);
/// Bodies of rigidFree parts. `numbers`: condition of each boundary condition, -1 for fixed.
void addBodies(SolverSetUp& data, const Model& model, const std::vector<Index>& numbers);
/// Nodes of bodies with contact or loads; after addContact.
void addLoadedBodyNodes(SolverSetUp& data);
/// The contact part; anew after deletions.
void addContact(SolverSetUp& data, const Model& model);
/// Mass scaling of the elements: ElementSetUp::mass, scaled. Masses of nodes come after it.
void scaleMass(SolverSetUp& data, const Model& model);

} // namespace fpm
