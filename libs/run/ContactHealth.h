#pragma once

#include "run/HealthRow.h"
#include "run/Sample.h"
#include "run/Sliding.h"

#include <array>

namespace fpm {

/// Judges contact pair by pair: penetration, friction delivered, what was lost or released.
class ContactHealth
{
public:
    ContactHealth(const Model& model, const Solver& solver);
    void sample(const Sample& row);
    void addRows(HealthRows& rows) const;
    /// What the passes count: asks the solver.
    void addCounts(Solver& solver, HealthRows& rows) const;
    void keep(Archive& archive);

private:
    struct OfPair {
        double size = 0;     ///< width of a face of the target
        double forgiven = 0; ///< depth before the run that makes no force
        Peak depth;
        PairStatus deepest; ///< at the time of that depth
        Sliding sliding;
        std::array<double, 4> since{-1, -1, -1, -1}; ///< first row with a count, see losses
    };
    void addDepth(std::size_t pair, HealthRows& rows) const;
    void addFriction(std::size_t pair, HealthRows& rows) const;

    const Model& model_;
    std::vector<OfPair> pairs_;
};

} // namespace fpm
