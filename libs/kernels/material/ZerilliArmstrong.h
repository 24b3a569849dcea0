#pragma once

#include "kernels/material/Elastic.h"
#include "parallel/ExpLog.h"

namespace fpm {

/// Zerilli and Armstrong 1987, for metals at high rates: Mises plasticity with the yield stress
///     S = C0 + (C1 + C2 sqrt(e)) exp((C4 ln(r / rate0) - C3) T) + C5 e^n
/// at the equivalent plastic strain e, its rate r and the absolute temperature T. C2 = 0 is the law
/// of body-centred metals (iron, tantalum), C1 = C5 = 0 that of face-centred ones (copper). Without
/// heating the temperature stays that of the start.
struct ZerilliArmstrong : MaterialLaw {
    static constexpr const char *word = "zerilliArmstrong", *name = "Zerilli-Armstrong";
    static constexpr bool heats = true;
    static constexpr std::array<Parameter, 8> parameters{{
        {.word = "C0", .meaning = "athermal part, with that of the grain size", .unit = "stress"},
        {.word = "C1", .meaning = "thermal part, bcc", .unit = "stress", .required = false},
        {.word = "C2",
         .meaning = "thermal part that hardens, fcc",
         .unit = "stress",
         .required = false},
        {.word = "C3", .meaning = "softening", .unit = "1/temperature"},
        {.word = "C4", .meaning = "rate dependence", .unit = "1/temperature"},
        {.word = "C5", .meaning = "athermal hardening, bcc", .unit = "stress", .required = false},
        {.word = "n",
         .meaning = "its exponent",
         .unit = "-",
         .upper = 1,
         .lowerOpen = true,
         .required = false,
         .preset = 1},
        {.word = "rate0",
         .meaning = "the rate 1/s of the constants in the units of the case",
         .unit = "1/time",
         .lowerOpen = true,
         .required = false,
         .preset = 1},
    }};

    static constexpr ParameterFault fault(const double* values)
    {
        if (values[0] + values[1] + values[2] > 0) return {};
        return {0, "C0, C1 and C2 are all 0: the material yields without stress",
                "give at least one of them"};
    }

    /// Places in MaterialConstants::law.
    enum Constant { c0, c1, c2, c3, c4, c5, exponent, rate0 };

    static constexpr void constants(const double* values, MaterialConstants<double>& m)
    {
        for (std::size_t i = 0; i < parameters.size(); ++i) m.law[i] = values[i];
    }

    /// A yield stress and its derivative with respect to the logarithm of the plastic strain
    /// increment.
    template <class T>
    struct Yield {
        T value, slope;
    };

    /// After an increment d = e^z of the plastic strain, `toRate` is ln(r / rate0) - z. Without a
    /// step there is no rate; that of rate0 counts.
    template <class T>
    FPM_KERNEL static Yield<T> yieldStress(const MaterialConstants<ScalarOf<T>>& m,
                                           const T& strain,
                                           const T& increment,
                                           const T& logRate,
                                           const T& temperature)
    {
        using Real = ScalarOf<T>;
        // Where the strain is nothing its powers have no slope: held at 1e-30.
        const T after = maximum(strain + increment, T(Real(1e-30))), share = increment / after;
        const T thermal =
            exponential((fusedMultiplyAdd(T(m.law[c4]), logRate, T(-m.law[c3]))) * temperature);
        const T root = T(m.law[c2]) * squareRoot(after) * thermal;
        const T powered =
            m.law[c5] > Real(0) ? T(m.law[c5]) * power(after, T(m.law[exponent])) : T(Real(0));
        const T rateful = fusedMultiplyAdd(T(m.law[c1]), thermal, root);
        return {T(m.law[c0]) + rateful + powered,
                fusedMultiplyAdd(
                    T(m.law[c4]) * temperature, rateful,
                    share * fusedMultiplyAdd(T(Real(0.5)), root, T(m.law[exponent]) * powered))};
    }

    /// Largest number of Newton iterations of the return (ZerilliArmstrongTest).
    static constexpr int iterations = 12;

    /// Radial return with the rate of this very step: 3 mu d + S(e + d, d / step, T) = q_tr by
    /// Newton's method for ln d. Every term is a convex function of it, so that the iterates come
    /// down from the bound without the thermal part and never pass the root.
    template <class T>
    FPM_KERNEL static PlasticStep<T>
    update(const MaterialConstants<ScalarOf<T>>& m, const FlowPoint<T>& point, Sym3<T>& s, Sym3<T>&)
    {
        using Real = ScalarOf<T>;
        const T zero = T(Real(0)), one = T(Real(1)), tiny = T(Real(1e-30));
        const Sym3<T> deviator = deviatorOf(s);
        const TrialStress<T> size(deviator, point.bending);
        const T trial = size.equivalent;

        const T strain = maximum(point.plasticStrain, zero);
        const T temperature = maximum(point.temperatureRise + T(m.general.temperature), zero);
        const bool rated = point.rate > Real(0) && m.law[c4] > Real(0);
        // Yields at any stress above that of the slowest flow.
        T least = T(m.law[c0]);
        if (m.law[c5] > Real(0)) least += T(m.law[c5]) * power(strain, T(m.law[exponent]));
        if (!rated) least = yieldStress<T>(m, strain, zero, zero, temperature).value;
        const auto flows = trial > least;
        if (!NumberTraits<T>::any(flows)) return {zero, zero, zero};

        const T toRate = rated ? naturalLogarithm(T(point.rate / m.law[rate0])) : zero;
        // Upper bounds: without the thermal part; with that alone, before it hardens.
        const T over = trial - least;
        T bound = naturalLogarithm(maximum(over * T(Real(1) / m.threeMu), tiny));
        if (rated) {
            const T base = fusedMultiplyAdd(T(m.law[c2]), squareRoot(strain), T(m.law[c1]));
            const T slope = T(m.law[c4]) * temperature;
            const T alone = (naturalLogarithm(maximum(over, tiny) / maximum(base, tiny))
                             + T(m.law[c3]) * temperature)
                                / maximum(slope, tiny)
                            - toRate;
            bound = select(alone < bound, alone, bound);
        }
        T z = bound;
        for (int iteration = 0; iteration < iterations; ++iteration) {
            const T d = exponential(z), elastic = T(m.threeMu) * d;
            const Yield<T> yield =
                yieldStress<T>(m, strain, d, rated ? z + toRate : zero, temperature);
            z += (trial - elastic - yield.value) / (elastic + yield.slope + tiny);
            z = select(bound < z, bound, z);
        }
        const T increment = select(flows, exponential(z), zero);
        const T reduction = T(m.threeMu) * increment / trial;
        s = s + (-reduction) * deviator;
        return {increment, (one - reduction) * increment * (size.square / trial), reduction};
    }

    /// At rate0.
    template <class T>
    FPM_KERNEL static T
    strength(const MaterialConstants<ScalarOf<T>>& m, const FlowPoint<T>& point, const Sym3<T>&)
    {
        const T zero = T(ScalarOf<T>(0));
        return yieldStress<T>(m, point.plasticStrain, zero, zero,
                              point.temperatureRise + T(m.general.temperature))
            .value;
    }
};

} // namespace fpm
