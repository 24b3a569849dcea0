#pragma once

#include "kernels/contact/law/PenaltyRules.h"

namespace fpm {

/// Number of the rule in the list PenaltyRules: which stiffness K A^2 / V a contact spring takes;
/// mass: m* / dt^2 instead, m* the lesser of the masses that meet, dt the first stable step of the
/// elements.
enum class PenaltyRule : int { target, lesser, series, mass };
static_assert(PenaltyRules::indexOf<TargetPenalty>() == int(PenaltyRule::target)
              && PenaltyRules::indexOf<LesserPenalty>() == int(PenaltyRule::lesser)
              && PenaltyRules::indexOf<SeriesPenalty>() == int(PenaltyRule::series)
              && PenaltyRules::indexOf<MassPenalty>() == int(PenaltyRule::mass));
constexpr const PenaltyEntry& entryOf(PenaltyRule rule)
{
    return penaltyEntries[std::size_t(rule)];
}

/// How contact with an analytic surface is enforced: exactly, at the end of every step; or by
/// springs, as against faces.
enum class Enforcement { kinematic, penalty };

/// Contact law of a pair of system/contactDict.
struct ContactLaw {
    double friction = 0;         ///< Coulomb coefficient, static
    double dynamicFriction = -1; ///< at high slip speed; < 0: as the static one
    double frictionDecay = 0;    ///< of mu_s - mu_d with slip speed [time/length]
    double slipDamping = 0.5;    ///< zeta of the resistance to fluctuations of the slip rate
    bool paperFriction = false;  ///< eqs. 17-18 as printed: the stored force does not turn
    /// s_n, s_t: k = s K A^2 / V. Between elastic bodies in contact the tangential stiffness is 2
    /// (1 - nu) / (2 - nu) of the normal one, 0.82 at nu 0.3 (Mindlin 1949).
    double normalScale = 1, tangentialScale = 0.8;
    PenaltyRule penalty = PenaltyRule::target;
    Enforcement enforcement = Enforcement::kinematic; ///< against analytic surfaces
    double normalDamping = 0;                         ///< zeta of F = -2 zeta sqrt(k m*) dg/dt
};

} // namespace fpm
