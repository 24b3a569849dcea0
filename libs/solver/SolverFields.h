#pragma once

#include "solver/SetUp.h"
#include "solver/bodies/BodyFields.h"
#include "solver/clock/ClockFields.h"
#include "solver/contact/ContactFields.h"
#include "solver/elements/ElementFields.h"
#include "solver/ledger/LedgerFields.h"
#include "solver/nodes/NodeFields.h"

namespace fpm {

/// All fields of a run. What a checkpoint or a count of bytes needs is a loop over
/// sets().
struct SolverFields {
    SolverFields(const SolverSetUp& setUp,
                 const std::vector<Point>& points,
                 const Memory& memory,
                 const NumberTypes& numbers);

    /// Those of contact passes and lists too, as they are now.
    std::vector<FieldSet*> sets();
    std::size_t bytes();
    /// Of state(), about what a file of it takes.
    std::size_t stateBytes();

    /// All that the next step reads, of a moment between two steps; see Solver::restore. Throws
    /// Error(checkpoint) for a state of other fields.
    std::vector<FieldSet::Images> state();
    void restore(const std::vector<FieldSet::Images>& state);
    /// Of a state, those that contact surfaces do not shape: clock, elements, nodes, rigid bodies.
    void restoreMotion(const std::vector<FieldSet::Images>& state);

    ClockFields clock;
    ElementFields elements;
    NodeFields nodes;
    BodyFields bodies;
    ContactFields contact;
    LedgerFields ledger;
};

} // namespace fpm
