#pragma once

#include "kernels/contact/law/KinematicContact.h"
#include "kernels/contact/law/RigidSurface.h"
#include "model/Model.h"

#include <array>

namespace fpm {

/// One pass of a contact pair prepared on the host: surfaces, neighbours, frozen stiffness.
struct ContactPassSetup {
    std::size_t pair = 0;  ///< number in the model
    bool reversed = false; ///< second pass: the target's nodes are the contactors
    ContactSearch search = ContactSearch::faces;
    ContactProjection projection = ContactProjection::tracked;
    ContactLaw law;
    Index surface = -1;      ///< analytic target, in ContactSetUp::surfaces; it has no faces,
    bool kinematic = false;  ///< and is met exactly, without springs
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
    /// Segments of sharp edges instead of nodes and faces: contactors and faces are segments, those
    /// of both sides numbered as one.
    bool ofEdges = false;
    std::vector<Index> edgeNode; ///< [6 * segment], as EdgePassView
    std::vector<Index> edgeNext; ///< [2 * segment + end], as EdgePassView
    Index firstTarget = 0;       ///< segments from here on are partners
    double queryHalf = 0;        ///< as EdgePassView
    struct NodePass {
        Index number = -1;            ///< of a pass of nodes against faces of the pair; -1: none
        std::vector<Index> contactor; ///< in it, of either end of each segment; -1: none
    };
    std::array<NodePass, 2> nodePasses;
};

/// Passes of all contact pairs and the nodes they act on, in the layout of the kernels.
struct ContactSetUp {
    std::vector<ContactPassSetup> passes;
    std::vector<SurfaceShape> surfaces; ///< as Model::rigidSurfaces
    std::vector<Index> nodes;           ///< node of each contact node
    std::vector<Index> numberOf;        ///< of each node among them, -1; empty without contact
    std::vector<Index> surfaceStart;    ///< kinematic contactors of each node: CSR; empty: none
    std::vector<SurfaceUse> surfaceUses;
    ForceScale scale;
};

/// Completes a pass from its faces, their thickness and contactors: neighbours, faces around nodes,
/// reach and cells.
void addTopology(ContactPassSetup& pass, const std::vector<Point>& points);

} // namespace fpm
