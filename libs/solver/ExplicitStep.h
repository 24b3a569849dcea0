#pragma once

#include "solver/bodies/BodySolver.h"
#include "solver/contact/ContactLists.h"
#include "solver/contact/ContactSolver.h"
#include "solver/elements/ElementSolver.h"
#include "solver/nodes/NodeSolver.h"

namespace fpm {

/// One explicit step, in the order of the paper's flow chart. Central differences: forces of time n
/// give velocities at n+1/2 (eq. 3, as a leapfrog) and positions at n+1, and those the forces of
/// n+1. A recipe and no more: what is fast about it is in the kernels, what is recorded in the
/// backend.
class ExplicitStep
{
public:
    ExplicitStep(ElementSolver& elements,
                 ContactSolver& contact,
                 ContactLists& lists,
                 NodeSolver& nodes,
                 BodySolver& bodies)
        : elements_(elements),
          contact_(contact),
          lists_(lists),
          nodes_(nodes),
          bodies_(bodies)
    {
    }

    /// Before a run of so many steps: contact lists that last for all of them.
    void prepare(Index steps) { lists_.check(steps); }

    void advance()
    {
        lists_.searchAtStep();
        nodes_.advanceClock();
        exchangeStep();
        nodes_.move();
        bodies_.move();
        exchangeMotion();
        updateForces();
    }

    /// Forces at the present positions.
    void updateForces()
    {
        elements_.updateForces();
        contact_.updateForces();
        nodes_.updateLoads();
        exchangeForces();
        bodies_.updateForces();
    }

private:
    // Where ranks that share a model would meet; one rank has all of it.
    void exchangeStep() {}   ///< the smallest of the next steps
    void exchangeMotion() {} ///< positions and velocities of nodes near the border
    void exchangeForces() {} ///< sums of forces on nodes of several ranks

    ElementSolver& elements_;
    ContactSolver& contact_;
    ContactLists& lists_;
    NodeSolver& nodes_;
    BodySolver& bodies_;
};

} // namespace fpm
