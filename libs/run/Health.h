#pragma once

#include "run/ContactHealth.h"
#include "run/EdgeWatch.h"
#include "run/EnergyHealth.h"
#include "run/MotionHealth.h"
#include "run/Sample.h"

namespace fpm {

/// A run judges itself: figures taken at history rows and at the end, each beside its limit.
/// HealthLimits holds the limits and their reasons.
class Health
{
public:
    /// After the solver's start.
    Health(const Model& model, const Solver& solver);
    /// At a history row.
    void sample(const StepClock& clock, const Sample& row);
    /// The table up to now; asks the solver for what is not sampled.
    HealthRows rows(Solver& solver, const EdgeWatch& edges) const;
    /// What is known without asking the solver, for `status` while it runs.
    HealthRows sampledRows() const;

    /// All that the figures of later rows start from.
    void keep(Archive& archive);

    static constexpr int judgedSteps = 10; ///< the balance is judged from this step on

private:
    EnergyHealth energies_;
    ContactHealth contact_;
    MotionHealth motion_;
};

} // namespace fpm
