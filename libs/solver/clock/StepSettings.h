#pragma once

#include "kernels/particle/StepClock.h"

namespace fpm {

/// Control values of the case that kernels read, fixed for a run.
struct StepSettings {
    double massDamping = 0;
    bool midStepStrain = true;
    bool ledger = false; ///< book the works of nodes
    StepRules rules;
};

} // namespace fpm
