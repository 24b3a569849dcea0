#pragma once

#include "stability/Bounds.h"

namespace fpm {

/// What became of a run, the worst that applies.
enum class Outcome { stable, energyDrift, chatter, penetration, tunnelled, inverted, diverged };
inline constexpr int outcomeCount = 7;
const char* nameOf(Outcome outcome);

/// What counts as a failure.
struct TrialLimits {
    int steps = 500;
    double energy = 0.01;      ///< error of the balance
    double penetration = 0.25; ///< mean depth weighted by force, over the width of a face
    double chatter = 0.2;      ///< changes between closed and open from sample to sample
};

struct TrialResult {
    Outcome outcome = Outcome::stable;
    double energyError = 0, penetration = 0; ///< the largest
    double steps = 0;                        ///< done
};

/// Runs the trial with the step of `setting` (automatic without) and judges it.
TrialResult runTrial(const Trial& trial,
                     const Setting& setting,
                     const Bounds& bounds,
                     const TrialLimits& limits);

} // namespace fpm
