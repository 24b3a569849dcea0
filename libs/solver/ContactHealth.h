#pragma once

#include "solver/HealthRow.h"
#include "solver/Sliding.h"
#include "solver/Solver.h"

namespace fpm {

/// Judges contact pair by pair: penetration, friction delivered, what was lost or let go.
class ContactHealth
{
public:
    ContactHealth(const Model& model, const Solver& solver);
    /// One value a pair of the model.
    void sample(double time, const std::vector<PairTouch>& pairs);
    void addRows(HealthRows& rows) const;
    /// What the passes count: asks the solver.
    void addCounts(Solver& solver, HealthRows& rows) const;

private:
    struct OfPair {
        double size = 0;     ///< width of a face of the target
        double forgiven = 0; ///< depth before the run that makes no force
        Peak depth;
        PairTouch deepest; ///< at the time of that depth
        Sliding sliding;
    };
    void addDepth(std::size_t pair, HealthRows& rows) const;
    void addFriction(std::size_t pair, HealthRows& rows) const;

    const Model& model_;
    std::vector<OfPair> pairs_;
};

} // namespace fpm
