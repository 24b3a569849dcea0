#include "run/RunJudge.h"

#include "base/Format.h"
#include "run/Health.h"
#include "run/Inversion.h"

#include <algorithm>
#include <cmath>

namespace fpm {

std::optional<RunFailure> RunJudge::lost(const Energies& energies, const StepClock& clock) const
{
    if (!std::isfinite(energies.total))
        return RunFailure{format("the energy is not a number at time {}", clock.time),
                          noNumberAdvice};
    // The first steps of a drive from rest: nothing to measure the error by yet.
    if (clock.steps < Health::judgedSteps || !(std::abs(energies.balance) > control_.energyStop))
        return std::nullopt;
    return RunFailure{format("energy balance error {} % at time {} is beyond energyBalance.stop "
                             "{} %",
                             toText(100 * energies.balance, 3), clock.time,
                             100 * control_.energyStop),
                      "try a smaller timeStep.safety or normalScale, and see the element or pair "
                      "named"};
}

std::optional<RunFailure>
RunJudge::judge(const Energies& energies, const StepClock& clock, Log& log)
{
    if (auto failure = lost(energies, clock)) return failure;
    if (clock.steps < Health::judgedSteps) return std::nullopt;
    const bool off = std::abs(energies.balance) > control_.energyWarning;
    if (off && !balanceWarned_)
        log.warning(format("energy balance error {} % at time {} is beyond energyBalance.warning "
                           "{} %",
                           toText(100 * energies.balance, 3), clock.time,
                           100 * control_.energyWarning));
    balanceWarned_ |= off;
    judgeInertia(energies, clock, log);
    return std::nullopt;
}

/// A slow run is quasi-static while its kinetic energy is small.
void RunJudge::judgeInertia(const Energies& energies, const StepClock& clock, Log& log)
{
    if (!(control_.kineticShare > 0) || clock.time < control_.quasiStaticAfter) return;
    const double share = energies.kineticShare();
    if (share > control_.kineticShare && largestShare_ <= control_.kineticShare)
        log.warning(format("kinetic energy is {} % of that of the elements at time {}, more than "
                           "quasiStatic.kineticShare: inertia has a part in the result; load more "
                           "slowly or scale the mass less",
                           toText(100 * share, 3), clock.time));
    largestShare_ = std::max(largestShare_, share);
}

std::string RunJudge::inertia() const
{
    if (!(control_.kineticShare > 0)) return "";
    return format("largest kinetic share after {}: {} %", control_.quasiStaticAfter,
                  toText(100 * largestShare_, 3));
}

void RunJudge::keep(Archive& archive)
{
    archive(largestShare_);
    archive(balanceWarned_);
}

} // namespace fpm
