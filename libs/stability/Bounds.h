#pragma once

#include "solver/Solver.h"
#include "stability/Scene.h"

#include <algorithm>

namespace fpm {

/// What theory says of a scene in its first contact, as multiples of the bound from elements alone.
struct Bounds {
    double elementStep = 0; ///< that bound [time]
    double withContact = 1; ///< 2 / sqrt(omega_e^2 + omega_c^2)
    double quality = 0;     ///< omega_c dt at the default of `contactLimit`, which bounds the
                            ///< energy that a touch makes; 0: no contact
    double eigenvalue = 0;  ///< 2 / omega_max of all elements and closed springs; 0: not computed
    /// What a step must stay below: elements with contact, and quality where there is contact.
    double both() const { return quality > 0 ? std::min(withContact, quality) : withContact; }
};

/// The clock after the first step of a model.
StepClock firstStep(const Model& model);

/// Bounds of the model at its start; springs within reach count before they close.
Bounds boundsOf(const Model& model);

/// Largest frequency of the discrete model with its active contacts closed [1/time], by power
/// iteration on M^-1 K, K v being the change of the solver's own forces along a small v; from
/// below, within about 1 %.
double largestFrequency(const Model& model, double elementStep);

} // namespace fpm
