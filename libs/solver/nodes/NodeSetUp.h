#pragma once

#include "kernels/particle/BodyNodes.h"
#include "kernels/particle/Relaxation.h"
#include "model/Model.h"

namespace fpm {

/// Masses, constraints, drives and loads of the nodes, in the layout of the kernels.
struct NodeSetUp {
    Index count = 0;
    Index firstBoundaryNode = 0;                      ///< nodes before it are interior to a patch,
    Index interiorEnd = 0;                            ///< from here on none is
    std::vector<Index> partialSumsStart, partialSums; ///< of nodes from firstBoundaryNode on: CSR;
                                                      ///< none: interior
    std::vector<double> mass;                         ///< that accelerates, with mass scaling
    std::vector<double> ownMass;                      ///< without: what weighs
    std::vector<Point> velocity;                      ///< initial
    std::vector<std::uint8_t> fixed;                  ///< see InteriorNodes
    bool movedByPatches = false;       ///< patches move their interior nodes themselves, and
    std::vector<Index> listed;         ///< NodeMotion only these
    std::vector<Index> conditionStart; ///< uses of each node: CSR; empty without conditions
    std::vector<ConditionUse> uses;
    std::vector<Condition> conditions;
    std::vector<double> amplitudeRows;
    std::vector<Index> frameOf; ///< see NodeMotion
    std::vector<double> frames;
    std::vector<Index> pressureFaceNode, pressureFaceElement, pressureStart, pressureSlots;
    std::vector<Index> pressureFaceCondition; ///< -1: the element is deleted
    RelaxationRules relaxation;               ///< tolerance 0: none
};

/// Amplitude and value of a drive or load, its rows appended to `amplitudeRows`.
Condition makeCondition(ConditionKind kind,
                        const Point& value,
                        const Amplitude& amplitude,
                        std::vector<double>& amplitudeRows);
/// A boundary condition as the kernels have it.
Condition conditionOf(const BoundaryCondition& condition, std::vector<double>& amplitudeRows);

} // namespace fpm
