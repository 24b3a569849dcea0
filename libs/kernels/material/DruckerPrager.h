#pragma once

#include "kernels/material/Elastic.h"

#include <cmath>
#include <numbers>

namespace fpm {

/// Drucker and Prager 1952: a yield stress that grows with the pressure, for soils, rock and
/// concrete in compression. Without hardening,
///     q + A p = Y,   A = 6 sin phi / (3 - sin phi),   Y = 6 c cos phi / (3 - sin phi),
/// q the Mises stress, p the mean stress (tension > 0): the cone through the compressive edges of
/// Mohr and Coulomb. Plastic flow follows the potential q + B p, with the angle of dilation in B.
struct DruckerPrager : MaterialLaw {
    static constexpr const char *word = "druckerPrager", *name = "Drucker-Prager";
    static constexpr SectionRule section = SectionRule::radial;
    static constexpr std::array<Parameter, 3> parameters{{
        {.word = "cohesion", .meaning = "c of Mohr and Coulomb", .unit = "stress"},
        {.word = "frictionAngle",
         .meaning = "phi, of triaxial compression",
         .unit = "degrees",
         .upper = 90,
         .upperOpen = true},
        {.word = "dilationAngle",
         .meaning = "psi; that of friction: associated flow",
         .unit = "degrees",
         .upper = 90,
         .upperOpen = true,
         .required = false},
    }};

    static constexpr ParameterFault fault(const double* values)
    {
        if (values[0] == 0 && values[1] == 0)
            return {0, "without cohesion and friction the material bears no shear",
                    "give one of them"};
        if (values[2] > values[1])
            return {2, "the angle of dilation is above that of friction",
                    "plastic flow would make energy; at most associated: the angle of friction"};
        return {};
    }

    /// Places in MaterialConstants::law.
    enum Constant {
        pressureSlope, ///< A
        dilation,      ///< B, plastic growth of volume over equivalent plastic strain
        cohesive,      ///< Y
        apex,          ///< Y / A, the largest mean stress
        inverseReturn, ///< 1 / (3 mu + K A B)
        bulk,          ///< K
    };

    static void constants(const double* values, MaterialConstants<double>& m)
    {
        const auto slope = [](double degrees) {
            const double sine = std::sin(degrees * std::numbers::pi / 180);
            return 6 * sine / (3 - sine);
        };
        const double a = slope(values[1]), angle = values[1] * std::numbers::pi / 180;
        m.law[pressureSlope] = a;
        m.law[dilation] = slope(values[2]);
        m.law[cohesive] = 6 * values[0] * std::cos(angle) / (3 - std::sin(angle));
        m.law[apex] = a > 0 ? m.law[cohesive] / a : 1e30;
        m.law[bulk] = m.lambda + m.twoMu / 3;
        m.law[inverseReturn] = 1 / (m.threeMu + m.law[bulk] * a * m.law[dilation]);
    }

    /// Return along the flow direction to the cone, q = q_tr - 3 mu d, p = p_tr - K B d; where that
    /// would pass the apex, to the apex. The bending of the section counts as in radialReturn and
    /// loses the share that the deviator loses. The equivalent plastic strain is that of the
    /// deviator.
    template <class T>
    FPM_KERNEL static PlasticStep<T>
    update(const MaterialConstants<ScalarOf<T>>& m, const FlowPoint<T>& point, Sym3<T>& s, Sym3<T>&)
    {
        using Real = ScalarOf<T>;
        const T zero = T(Real(0)), one = T(Real(1));
        const T mean = meanStress(s);
        const Sym3<T> deviator = deviatorOf(s);
        const TrialStress<T> size(deviator, point.bending);
        const T trial = size.equivalent;
        const T over = fusedMultiplyAdd(T(m.law[pressureSlope]), mean, trial) - T(m.law[cohesive]);
        const T onCone = maximum(over * T(m.law[inverseReturn]), zero);
        const T wholly = trial * T(Real(1) / m.threeMu); // increment that leaves no deviator
        const auto beyond = onCone > wholly;
        const T increment = select(beyond, wholly, onCone);
        const T reduction = select(beyond, one, T(m.threeMu) * increment / trial);
        const T relief =
            select(beyond, mean - T(m.law[apex]), T(m.law[bulk] * m.law[dilation]) * increment);

        s = s + (-reduction) * deviator;
        s.xx = s.xx - relief;
        s.yy = s.yy - relief;
        s.zz = s.zz - relief;
        const T volumetric = relief * T(Real(1) / m.law[bulk]);
        const T work = fusedMultiplyAdd(mean - relief, volumetric,
                                        (one - reduction) * increment * (size.square / trial));
        return {increment, work, reduction};
    }

    template <class T>
    FPM_KERNEL static T
    strength(const MaterialConstants<ScalarOf<T>>& m, const FlowPoint<T>&, const Sym3<T>& s)
    {
        return maximum(
            fusedMultiplyAdd(T(-m.law[pressureSlope]), meanStress(s), T(m.law[cohesive])),
            T(ScalarOf<T>(0)));
    }
};

} // namespace fpm
