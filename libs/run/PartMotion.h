#pragma once

#include "solver/Solver.h"

namespace fpm {

/// A part as a whole at one time, in global axes.
struct PartMotionValues {
    Point centre{0, 0, 0}, momentum{0, 0, 0};
    Point angularMomentum{0, 0, 0}; ///< about the centre
    double kinetic = 0;
};

/// Sums over the nodes of a part, each with its share of the part's elements, in the order of their
/// numbers: equal bits on every backend. Mass is what accelerates, with mass scaling; that of
/// deleted elements stays. Of a rigidFree part, the state of the body.
class PartMotion
{
public:
    PartMotion(const Solver& solver, const Mesh& mesh, Index part);
    PartMotionValues of(Solver& solver) const;

private:
    std::size_t body_; ///< in SolverSetUp::body
    bool rigid_ = false;
    std::vector<Index> nodes_;
    std::vector<double> mass_; ///< of each of them
};

} // namespace fpm
