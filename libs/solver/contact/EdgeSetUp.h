#pragma once

#include "solver/SetUp.h"

namespace fpm {

/// Adds the pass of the sharp edges of a pair whose passes of nodes against faces are there
/// already; none where no two edges can meet. `own`: sides of the contactor's surface.
void addEdgePass(SolverSetUp& data,
                 const Model& model,
                 std::size_t pair,
                 const std::vector<ElementSide>& own);

} // namespace fpm
