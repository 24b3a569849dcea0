#pragma once

#include "base/Types.h"
#include "parallel/Kernel.h"

#include <cmath>

namespace fpm {

/// Time and step of the run in device memory: kernel arguments stay the same from step to step, and
/// no step waits for the host.
struct StepClock {
    double time = 0;             ///< t of the positions
    double lost = 0;             ///< rounding error of `time`, compensated (Kahan)
    double step = 0;             ///< step that led to the positions, dt^(n-1/2)
    double mean = 0;             ///< (dt^(n-1/2) + dt^(n+1/2)) / 2, for the velocity
    double stop = 0;             ///< time that is met exactly; then the clock stands still
    double pause = 1e300;        ///< it stands still at the first step at or after this time too
    double stableStep = 0;       ///< last bound from elements and contact, before the safety factor
    double elementStep = 0;      ///< last bound from elements alone
    double contactFrequency = 0; ///< last bound omega_c of the contact springs
    double damping = 0;          ///< of dynamic relaxation, beside the mass damping
    double residual = 0; ///< of dynamic relaxation: force out of balance over internal forces
    double unrest = 0;   ///< square root of kinetic over stored energy
    double quiet = 0;    ///< time for which both have been small
    std::int64_t steps = 0;
    std::int64_t deletions = 0; ///< changes whenever elements are deleted
    std::int64_t followed = -1; ///< those that surfaces follow: no step is made with a surface of
                                ///< deleted elements; -1: none has to
    std::int64_t listsValidUntil = std::int64_t(1) << 62; ///< step up to which contact lists are
                                                          ///< valid
    std::int32_t searched = 0;                            ///< 1: the last list check rebuilt some
                                                          ///< lists
    std::int32_t waits = 0;   ///< 1: waits for contact lists that the host has to rebuild
    std::int32_t running = 1; ///< 0: `stop` or `pause` is reached, or lists or surfaces have to
                              ///< be rebuilt; nothing moves
    std::int32_t failed = 0;  ///< 1: an element inverted or a number is not finite; 2: the fixed
                              ///< step is beyond the bound; nothing moves
    std::int32_t settled = 0; ///< dynamic relaxation is done; nothing moves

    /// Another step may be made.
    FPM_KERNEL bool mayStep() const
    {
        return !failed && !settled && time < stop && time < pause && steps < listsValidUntil
               && (followed < 0 || followed == deletions);
    }
};

/// Rules of the step size, fixed for a run.
struct StepRules {
    double safety = 0.9;       ///< of 2 / sqrt(omega_e^2 + omega_c^2)
    double contactLimit = 0.8; ///< omega_c dt: bounds the energy that one touch makes
    double maximumStep = 0;    ///< > 0: no step is longer
    double fixedStep = 0;      ///< > 0: this step
    bool beyondBound = false;  ///< fixedStep may exceed the bound
    double growth = 1.1;       ///< largest ratio of successive steps
};

/// Chooses dt^(n+1/2) from the bounds of this step and advances the clock by it. A clock that
/// stands still only checks the bounds.
FPM_KERNEL void
advanceClock(StepClock& clock, const StepRules& rules, double elementStep, double contactSquare)
{
    if (!(elementStep > 0) || !(elementStep < 1e300) || !(contactSquare >= 0)
        || !(contactSquare < 1e300))
        clock.failed = 1;
    if (!clock.mayStep()) clock.running = 0;
    if (!clock.running) return;
    clock.elementStep = elementStep;
    clock.contactFrequency = ::sqrt(contactSquare);
    const double elementSquare = 4 / (elementStep * elementStep);
    clock.stableStep = 2 / ::sqrt(elementSquare + contactSquare);
    if (rules.fixedStep > clock.stableStep && !rules.beyondBound) {
        clock.failed = 2;
        clock.running = 0;
        return;
    }
    double next = rules.safety * clock.stableStep;
    if (clock.contactFrequency * next > rules.contactLimit)
        next = rules.contactLimit / clock.contactFrequency;
    if (clock.step > 0 && next > rules.growth * clock.step) next = rules.growth * clock.step;
    if (rules.maximumStep > 0 && next > rules.maximumStep) next = rules.maximumStep;
    if (rules.fixedStep > 0) next = rules.fixedStep;

    // Avoid a tiny last step before `stop`.
    const double left = clock.stop - clock.time;
    if (left <= next * 1.000001)
        next = left;
    else if (left < 2 * next && rules.fixedStep <= 0)
        next = left / 2;
    clock.mean = (clock.step + next) / 2;
    clock.step = next;
    const double part = next - clock.lost;
    const double sum = clock.time + part;
    clock.lost = (sum - clock.time) - part;
    clock.time = sum;
    if (left <= next * 1.000001) {
        clock.time = clock.stop;
        clock.lost = 0;
    }
    ++clock.steps;
}

} // namespace fpm
