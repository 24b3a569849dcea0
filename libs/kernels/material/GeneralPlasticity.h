#pragma once

#include "kernels/material/HardeningCurve.h"
#include "kernels/material/J2Plasticity.h"
#include "kernels/material/RateDependence.h"
#include "kernels/material/ThermalSoftening.h"

namespace fpm {

/// Largest number of Newton iterations of rateReturn; from its start five are enough for 1e-10 in
/// all but extreme exponents (GeneralPlasticityTest).
inline constexpr int returnIterations = 10;

/// Plastic strain increment d > 0 of trial - stiffness d = theta S(ebar + d) R(d / step) on a
/// curved right side: Newton's method for z = ln d. The left side less the right side decreases
/// with z and is concave for every law here (e^z, e^(nz), e^(z/p) and max(z, z0) are convex), so
/// that the iterates decrease from an upper bound without passing the root. The rate is that of the
/// same step: nothing lags, nothing is smoothed.
template <class T>
FPM_KERNEL T rateReturn(const MaterialConstants<ScalarOf<T>>& m,
                        const FlowPoint<T>& point,
                        const T& trial,
                        const T& slow,
                        const T& softening,
                        ScalarOf<T> stiffness)
{
    using Real = ScalarOf<T>;
    const GeneralConstants<Real>& g = m.general;
    const T tiny = T(Real(1e-30)), zero = T(Real(0)), one = T(Real(1));
    const bool viscous = g.rateLaw != RateLaw::none && point.rate > Real(0);
    const T toRate =
        viscous ? naturalLogarithm(T(point.rate / g.referenceRate)) : zero; // ln(rate/ref) = z + it

    // Upper bounds: without hardening and rate, with the rate alone, with the power law alone.
    T z = naturalLogarithm(maximum((trial - slow) * T(Real(1) / stiffness), tiny));
    if (viscous) {
        const T excess = maximum((trial - slow) / slow, tiny);
        const T alone = logRateOfFactor(g, excess) - toRate;
        z = select(alone < z, alone, z);
    }
    if (g.powerModulus > Real(0)) {
        // With the power law alone (e + d)^n = e^n + ..., where the root is no difference of nearly
        // equal numbers: at first yield its slope is infinite.
        const T n = T(g.powerExponent), e = maximum(point.plasticStrain, zero);
        const T grown = power(e, n) + (trial - slow) / (softening * T(g.powerModulus));
        const T sum = power(grown, T(Real(1) / g.powerExponent));
        const T alone = naturalLogarithm(maximum(sum - e, tiny));
        z = select(T(Real(0.1)) * sum < sum - e, select(alone < z, alone, z), z);
    }
    const T bound = z;
    for (int iteration = 0; iteration < returnIterations; ++iteration) {
        const T d = exponential(z);
        const YieldStress<T> curve = hardeningCurve(m, point.plasticStrain + d);
        RateFactor<T> factor{one, zero};
        if (viscous) factor = rateFactor(g, z + toRate);
        const T elastic = T(stiffness) * d;
        const T missing = trial - elastic - softening * curve.value * factor.value;
        const T falls =
            elastic
            + softening
                  * fusedMultiplyAdd(curve.slope * d, factor.value, curve.value * factor.slope);
        z += missing / (falls + tiny);
        z = select(bound < z, bound, z);
    }
    return exponential(z);
}

/// Plastic strain increment for a table without rate: exact for each linear piece, as in
/// radialReturn.
template <class T>
FPM_KERNEL T tableReturn(const MaterialConstants<ScalarOf<T>>& m,
                         const FlowPoint<T>& point,
                         const T& trial,
                         const T& softening,
                         ScalarOf<T> stiffness)
{
    const T zero = T(ScalarOf<T>(0));
    const auto solve = [&](int row) {
        const T slope = softening * T(m.slope[row]);
        const T start = fusedMultiplyAdd(slope, point.plasticStrain - T(m.strain[row]),
                                         softening * T(m.stress[row]));
        return (trial - start) / (T(stiffness) + slope);
    };
    T increment = solve(0);
    for (int row = 1; row < m.rows; ++row) {
        const auto beyond = point.plasticStrain + maximum(increment, zero) > T(m.strain[row]);
        increment = select(beyond, solve(row), increment);
    }
    return maximum(increment, zero);
}

/// Radial return of the elastic trial stress to the yield surface of the part's law,
///     sqrt(3/2) |s - a| = theta(T) S(ebar) R(rate),
/// on s - a (Simo and Hughes, box 3.1): the backstress a follows Prager's linear rule. The
/// temperature is that of the start of the step. `bending` as in radialReturn; the bending capacity
/// of a section does not move with the backstress.
template <class T>
FPM_KERNEL PlasticStep<T> generalReturn(const MaterialConstants<ScalarOf<T>>& m,
                                        const FlowPoint<T>& point,
                                        Sym3<T>& s,
                                        Sym3<T>& backstress)
{
    using Real = ScalarOf<T>;
    const GeneralConstants<Real>& g = m.general;
    const T zero = T(Real(0));
    if (m.rows == 0) return {zero, zero, zero};
    const bool curved = g.powerModulus > Real(0) || g.rateLaw != RateLaw::none;
    const YieldStress<T> curve = hardeningCurve(m, point.plasticStrain);
    if (!curved && !(g.kinematicModulus > Real(0)) && !(g.softeningExponent > Real(0)))
        return radialReturn<T>(m, point.plasticStrain, point.bending, s);

    const Sym3<T> deviator = deviatorOf(s);
    Sym3<T> shifted = deviator;
    if (g.kinematicModulus > Real(0)) shifted = deviator + T(Real(-1)) * backstress;
    const T trial = TrialStress<T>(shifted, point.bending).equivalent;
    const T softening = thermalSoftening(g, point.temperatureRise);
    const T slow = softening * curve.value;
    const auto flows = trial > slow;
    if (!NumberTraits<T>::any(flows)) return {zero, zero, zero};

    const Real stiffness = m.threeMu + g.kinematicModulus;
    const T found = curved ? rateReturn<T>(m, point, trial, slow, softening, stiffness)
                           : tableReturn<T>(m, point, trial, softening, stiffness);
    const T increment = select(flows, found, zero);
    const T share = increment / trial; // of s - a, for each unit of stiffness
    s = s + (-(T(m.threeMu) * share)) * shifted;
    if (g.kinematicModulus > Real(0))
        backstress = backstress + (T(g.kinematicModulus) * share) * shifted;
    // Work of the stress at the end on the plastic strain 3/2 (s - a) d / q.
    const Sym3<T> kept = deviator + (-(T(m.threeMu) * share)) * shifted;
    return {increment, T(Real(1.5)) * contract(kept, shifted) * share, T(stiffness) * share};
}

/// Everything a part may ask for beyond Elastic and J2Plasticity with the middle surface's
/// rotation: options are constants of the part, asked at run time, so that each of them needs no
/// kernels of its own. Also serves elastic parts (no hardening rows).
struct GeneralPlasticity : MaterialLaw {
    static constexpr const char* name = "options chosen at run time";
    static constexpr bool heats = true, everyElement = true;

    template <class Work>
    FPM_KERNEL static constexpr KeptState kept(const MaterialConstants<Work>& m)
    {
        return {m.rows > 0, m.general.kinematicModulus > Work(0), m.general.heatPerWork > Work(0)};
    }
    template <class T>
    FPM_KERNEL static PlasticStep<T> update(const MaterialConstants<ScalarOf<T>>& m,
                                            const FlowPoint<T>& point,
                                            Sym3<T>& stress,
                                            Sym3<T>& backstress)
    {
        return generalReturn<T>(m, point, stress, backstress);
    }
    template <class T>
    FPM_KERNEL static T
    strength(const MaterialConstants<ScalarOf<T>>& m, const FlowPoint<T>& point, const Sym3<T>&)
    {
        return hardeningCurve<T>(m, point.plasticStrain).value
               * thermalSoftening<T>(m.general, point.temperatureRise);
    }
};

} // namespace fpm
