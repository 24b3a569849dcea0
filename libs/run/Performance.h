#pragma once

#include "base/Archive.h"
#include "base/Log.h"
#include "io/OutputFolder.h"
#include "solver/Solver.h"

namespace fpm {

/// The parts of a run before this one, where it goes on from a checkpoint: what became of them up
/// to there.
struct EarlierParts {
    std::int64_t count = 0;
    double stepSeconds = 0; ///< of their steps

    /// Together with the part that the solver has made.
    EarlierParts with(const StepTimes& part) const { return {count + 1, stepSeconds + part.total}; }
    void keep(Archive& archive);
};

/// Logs ns per element-step, the shares of the solvers and the checksum of the state, and writes
/// the PerformanceRecord of the run.
void reportPerformance(Solver& solver,
                       const Model& model,
                       const EarlierParts& earlier,
                       const OutputFolder& theCase,
                       const std::string& runId,
                       Log& log);

/// One line on the mass that mass scaling adds; none where there is none.
void reportMassScaling(const Solver& solver, Log& log);

/// "element 17 of part rod: ..." with the smallest stable step, or the one that inverted.
std::string worstElement(Solver& solver, const Model& model);

/// What bounds the present time step: an element, or the node of a contact pair whose springs are
/// the stiffest for its mass.
std::string stepLimit(Solver& solver, const Model& model);

/// Logs of every contact pair: nodes in contact, stiffness, energy held and lost; warns of
/// released nodes.
void reportPairs(Solver& solver, const Model& model, Log& log);

} // namespace fpm
