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

/// Friction of a pair as the kernels have it.
template <class Work>
inline FrictionLaw<Work> frictionLaw(const ContactLaw& law)
{
    const double fast = law.dynamicFriction < 0 ? law.friction : law.dynamicFriction;
    return {.staticCoefficient = Work(law.friction),
            .dynamicCoefficient = Work(fast),
            .decay = law.frictionDecay,
            .stiffnessRatio = Work(law.tangentialScale / law.normalScale),
            .paper = law.paperFriction};
}

/// Motion of an analytic surface; rows of its amplitude are appended to `amplitudeRows`.
Condition surfaceMotion(const RigidSurface& surface, std::vector<double>& amplitudeRows);
/// The surface as the kernel has it, likewise.
SurfaceShape surfaceShape(const RigidSurface& surface, std::vector<double>& amplitudeRows);

/// Share of the mean face width by which a node that starts inside a kinematic surface comes out
/// in one step: what is deeper was asked for (`initialOverlap report`), and must not be thrown.
inline constexpr double pushOut = 0.01;

/// A pair against an analytic surface.
ContactPassSetup makeSurfacePair(const SolverSetUp& data,
                                 const Model& model,
                                 const ContactPair& pair,
                                 const std::vector<ElementSide>& own);

} // namespace fpm
