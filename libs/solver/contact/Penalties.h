#pragma once

#include "mesh/SharpEdges.h"
#include "solver/SetUp.h"

namespace fpm {

/// Stiffnesses and masses of a pair whose contactor and faces are known. A rigid side has stiffness
/// 0, so that the other side's counts; `own`: sides of the contactor's surface.
void addPenalty(ContactPassSetup& out,
                const SolverSetUp& data,
                const Model& model,
                const ContactPair& pair,
                const std::vector<ElementSide>& own,
                const std::vector<ElementSide>& target);

/// The same of a pass of sharp edges. The two edges of a pair are alike: where the rule asks only
/// for the target, the lesser stiffness counts; a pair has one spring, with all of the stiffness.
void addEdgePenalty(ContactPassSetup& out,
                    const SolverSetUp& data,
                    const Model& model,
                    const ContactPair& pair,
                    const std::vector<SharpEdge>& edges);

/// Largest stiffness a spring of the pair can have.
double largestStiffness(const ContactPassSetup& pass);

/// Share of a damped spring in the step bound: lagged damping zeta shortens the stable step to
/// (sqrt(1 + zeta^2) - zeta) 2 / omega.
double dampingLimit(const ContactLaw& law);

/// Motion of an analytic surface; rows of its amplitude are appended to `amplitudeRows`.
Condition surfaceMotion(const RigidSurface& surface, std::vector<double>& amplitudeRows);
/// The surface as the kernel has it, likewise.
SurfaceShape surfaceShape(const RigidSurface& surface, std::vector<double>& amplitudeRows);

/// A pair against an analytic surface.
ContactPassSetup makeSurfacePair(const SolverSetUp& data,
                                 const Model& model,
                                 const ContactPair& pair,
                                 const std::vector<ElementSide>& own);

} // namespace fpm
