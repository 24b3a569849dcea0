#pragma once

#include "kernels/contact/RigidSurface.h"
#include "kernels/element/ElementForces.h"
#include "kernels/element/ElementKernels.h"
#include "kernels/particle/BodyNodes.h"
#include "kernels/particle/Relaxation.h"
#include "mesh/Patches.h"
#include "model/Model.h"

namespace fpm {

/// Patches that share a kernel: same material law and element.
struct KernelGroup {
    ElementKernel kernel;
    std::vector<Index> patches;
};

/// One pass of a contact pair prepared on the host: surfaces, neighbours, frozen stiffness.
struct ContactPassSetup {
    std::size_t pair = 0;  ///< number in the model
    bool reversed = false; ///< second pass: the target's nodes are the contactors
    ContactSearch search = ContactSearch::faces;
    ContactProjection projection = ContactProjection::tracked;
    ContactLaw law;
    Index surface = -1;      ///< analytic target, in SolverData::surfaces; it has no faces
    double deepest = 0;      ///< depth at which the force on an analytic surface grows no more
    double meanFaceSize = 0; ///< square root of the mean target face area
    double reach = 0;        ///< distance at which faces are tracked
    double cellSize = 0;
    Index levels = 1;      ///< of cells, each twice as wide as the one before
    Index nodeCount = 0;   ///< contactor nodes; each is `slots` contactors
    bool forgives = false; ///< initial overlap makes no force
    double fadeTime = 0;   ///< > 0: for a time only
    std::vector<Index> contactor, ownFaceStart, ownFaces, ownFaceNode;
    std::vector<Index> faceNode, nextAround, neighbour;
    std::vector<double> mirrorNormal; ///< [3 * k]: of plane k of mirrorPlanes, mirrorEdge(k)
    std::vector<double> faceStiffness, faceThickness, faceMass;
    bool unequalFaces = false;              ///< in stiffness, by more than rounding
    bool mayLeave = false;                  ///< contactors, as their face may be deleted
    std::vector<double> contactorStiffness; ///< empty where the faces' alone count
    std::vector<double> contactorMass;
    std::vector<std::uint8_t> mirrors;       ///< planes of symmetry a contactor lies on, a bit each
                                             ///< as mirrorNormal; empty: none
    std::vector<Index> target, targetCorner; ///< nodes, and a corner of a face at each
    std::vector<Index> excludedStart, excluded;           ///< empty: none
    std::vector<Index> faceComponent, contactorComponent; ///< empty: one body
    std::vector<std::uint8_t> mayMeet;
    Index components = 1;
};

/// Where the state of one element lies: first value of it and of its plastic strains; further
/// values follow tileWidth apart.
struct ElementPlace {
    std::size_t part, state, strains;
};

/// Free rigid bodies, one a rigidFree part.
struct BodyData {
    std::vector<Index> part;
    std::vector<RigidBody> bodies;
    std::vector<Index> bodyOf; ///< of each node, -1; empty without bodies
    std::vector<Index> nodes;  ///< of all bodies
    std::vector<Point> arm;    ///< of each of them, from the centre
    std::vector<Index> useStart;
    std::vector<ConditionUse> uses; ///< loads on a body as a whole
    std::vector<BodyBlock> blocks;
    std::vector<Index> blockStart, loaded; ///< nodes that may feel a force
    std::vector<double> inverseMass;       ///< of each of them, for contact springs
};

/// Everything the solver uploads, in double and in the layout of the kernels.
struct SolverData {
    Index nodeCount = 0, elementCount = 0, paddedElements = 0, partialSumCount = 0;
    std::size_t maxPatchNodes = 0;
    std::vector<PatchHeader> patches;
    std::vector<KernelGroup> groups;
    std::vector<MaterialConstants<double>> materials;
    std::vector<StateLayout> layouts;           ///< of each part
    std::size_t stateSize = 0, strainCount = 0; ///< of all patches together
    std::vector<std::uint16_t> corners, cornerStarts,
        slotCorners;                                  ///< see PatchTables, ElementForces
    std::vector<Index> boundaryNodes;                 ///< node of each partial sum
    Index firstBoundaryNode = 0;                      ///< nodes before it are interior to a patch,
    Index interiorEnd = 0;                            ///< from here on none is
    std::vector<Index> partialSumsStart, partialSums; ///< of nodes from firstBoundaryNode on: CSR;
                                                      ///< none: interior
    std::vector<double> elementMass;                  ///< tiles of 1
    std::vector<double> massRatio;   ///< of it to the mass that is heated; empty: 1
    std::vector<double> nodeMass;    ///< that accelerates, with mass scaling
    std::vector<double> ownNodeMass; ///< without: what weighs
    std::size_t scaledElements = 0;
    RelaxationRules relaxation;        ///< tolerance 0: none
    std::vector<Point> velocity;       ///< initial
    std::vector<std::uint8_t> fixed;   ///< see InteriorNodes
    bool sharesNodes = false;          ///< patches move their interior nodes themselves, and
    std::vector<Index> listedNodes;    ///< NodeMotion only these
    std::vector<Index> conditionStart; ///< uses of each node: CSR; empty without conditions
    std::vector<ConditionUse> uses;
    std::vector<Condition> conditions;
    std::vector<double> amplitudeRows;
    std::vector<Index> frameOf; ///< see NodeMotion
    std::vector<double> frames;
    std::vector<Index> pressureFaceNode, pressureFaceElement, pressureStart, pressureSlots;
    std::vector<Index> pressureFaceCondition; ///< -1: the element is deleted
    BodyData body;
    bool rigidParts = false;
    bool erodes = false, heats = false; ///< some part does

    std::vector<ContactPassSetup> passes;
    std::vector<SurfaceShape> surfaces; ///< as Model::rigidSurfaces
    std::vector<Index> contactNodes;    ///< node of each contact node
    std::vector<Index> contactNumber;   ///< of each node, -1; empty without contact
    ForceScale contactScale;

    /// Position of element e (mesh order) in tiles: tile and place.
    std::size_t tileOf(Index element) const { return elementTile[std::size_t(element)]; }
    ElementPlace placeOf(Index element) const
    {
        const PatchHeader& patch = patches[std::size_t(elementPatch[std::size_t(element)])];
        const StateLayout& layout = layouts[std::size_t(patch.material)];
        const Index e = elementPlace[std::size_t(element)];
        return {std::size_t(patch.material), patch.state + inTiles(e, layout.size()),
                patch.strains + inTiles(e, layout.sums())};
    }
    double massOf(Index element) const
    {
        return elementMass[tileOf(element) + std::size_t(elementPlace[std::size_t(element)])];
    }
    std::vector<std::size_t> elementTile; ///< tile start of the element's patch
    std::vector<Index> elementPlace, elementPatch;
};

/// Builds the data of a validated model. Throws Error(mesh) for an element without volume. `audit`:
/// see makeSolver.
SolverData makeSolverData(const Model& model, bool audit = false);
/// Which nodes each patch moves itself, and listedNodes; at the end, and when contact has changed.
void shareNodes(SolverData& data);
/// Conditions, initial velocities and bodies of makeSolverData; after masses, before contact.
void addMotion(SolverData& data, const Model& model);
/// Bodies of rigidFree parts. `numbers`: condition of each boundary condition, -1 for fixed.
void addBodies(SolverData& data, const Model& model, const std::vector<Index>& numbers);
/// Nodes of bodies with contact or loads; after addContact.
void addLoadedBodyNodes(SolverData& data);
/// The contact part of makeSolverData.
void addContact(SolverData& data, const Model& model);
/// Mass scaling of the elements: elementMass, scaledElements. Masses of nodes come after it.
void scaleMass(SolverData& data, const Model& model);
/// Amplitude and value of a drive or load, its rows appended to `amplitudeRows`.
Condition makeCondition(ConditionKind kind,
                        const Point& value,
                        const Amplitude& amplitude,
                        std::vector<double>& amplitudeRows);
/// A boundary condition as the kernels have it.
Condition conditionOf(const BoundaryCondition& condition, std::vector<double>& amplitudeRows);
/// Completes a pass from its faces, their thickness and contactors: neighbours, faces around nodes,
/// reach and cells.
void addTopology(ContactPassSetup& pair, const std::vector<Point>& points);
/// Material constants of a part.
MaterialConstants<double> materialConstants(const Part& part);
/// Energy below which the balance of a run is no error but rounding.
double roundingEnergy(const Model& model);

} // namespace fpm
