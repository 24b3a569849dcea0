#pragma once

#include "mesh/Surface.h"
#include "model/Model.h"
#include "model/NodeSelection.h"
#include "solver/Solver.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace fpm {

/// What scenes are built and questioned with. Units: mm, tonne, s.

/// The aluminium of the plate scene, elastic, hourglass stiffness; nu 0.3 but where it is given.
Part aluminiumPart(const std::string& name, double poissonsRatio = 0.3);

/// Outer sides of a part whose normals point along `direction` (within 45 degrees).
std::vector<ElementSide> facing(const Mesh& mesh, const std::string& part, Point direction);
/// Nodes of the mesh whose position satisfies `here`, ascending.
std::vector<Index> nodesWhere(const Mesh& mesh, const std::function<bool(Point)>& here);
/// Nodes of a part, ascending.
std::vector<Index> nodesOfPart(const Mesh& mesh, const std::string& name);

/// Enters a contact pair between two lists of sides into the model and its mesh.
ContactPair& addContact(Model& model,
                        const std::string& name,
                        const std::vector<ElementSide>& contactor,
                        const std::vector<ElementSide>& target);
BoundaryCondition condition(BoundaryCondition::Kind kind,
                            const std::string& name,
                            const std::vector<Index>& nodes,
                            std::array<bool, 3> components,
                            Point value = {0, 0, 0},
                            const Amplitude& amplitude = {});
void holdFixed(Model& model, const std::vector<Index>& nodes);
void throwPart(Model& model, const std::string& part, Point velocity);
/// Patches (of at most `patch` elements), one thread, no end: ready for makeSolver.
void finishScene(Model& model, Index patch = 256);

/// Started, ready to advance.
std::unique_ptr<Solver> startedSolver(const Model& model, bool audit = false);
/// v^(n-1/2), the velocity the solver keeps, from the v^n it reports.
std::vector<Point> halfStepVelocities(Solver& solver);
/// Linear momentum of the nodes in `list` (all when empty) at v^(n-1/2).
Point momentum(Solver& solver, const std::vector<Index>& list = {});
/// Moment of momentum about the origin. Leapfrog keeps x^n x m v^(n-1/2) but for the moment of the
/// forces.
Point angularMomentum(Solver& solver);
double lengthOf(const Point& p);

} // namespace fpm
