#pragma once

namespace fpm {

/// Which stiffness K A^2 / V a contact spring takes; mass: m* / dt^2 instead, m* the lesser of the
/// masses that meet, dt the first stable step of the elements.
enum class PenaltyRule { target, lesser, series, mass };

/// What a pair of system/contactDict does where it touches.
struct ContactLaw {
    double friction = 0;         ///< Coulomb coefficient, static
    double dynamicFriction = -1; ///< at high slip speed; < 0: as the static one
    double frictionDecay = 0;    ///< of mu_s - mu_d with slip speed [time/length]
    bool paperFriction = false;  ///< eqs. 17-18 as printed: the stored force does not turn
    double normalScale = 1, tangentialScale = 0.1; ///< s_n, s_t: k = s K A^2 / V
    PenaltyRule penalty = PenaltyRule::target;
    double normalDamping = 0; ///< zeta of F = -2 zeta sqrt(k m*) dg/dt
};

} // namespace fpm
