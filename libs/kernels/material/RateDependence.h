#pragma once

#include "kernels/material/MaterialConstants.h"
#include "parallel/ExpLog.h"

namespace fpm {

/// The factor of the yield stress and its derivative with respect to the logarithm of the plastic
/// strain increment.
template <class T>
struct RateFactor {
    T value, slope;
};

/// Cowper and Symonds 1957: 1 + (r / D)^(1/p). Logarithmic, the rate term of Johnson and Cook
/// 1983: 1 + C ln(max(r / rate0, 1)). `logRate`: ln of r over the reference rate.
template <class T>
FPM_KERNEL RateFactor<T> rateFactor(const GeneralConstants<ScalarOf<T>>& m, const T& logRate)
{
    using Real = ScalarOf<T>;
    const T one = T(Real(1)), zero = T(Real(0)), coefficient = T(m.rateCoefficient);
    if (m.rateLaw == RateLaw::cowperSymonds) {
        const T raised = exponential(coefficient * logRate);
        return {one + raised, coefficient * raised};
    }
    if (m.rateLaw == RateLaw::logarithmic)
        return {fusedMultiplyAdd(coefficient, maximum(logRate, zero), one),
                select(logRate > zero, coefficient, zero)};
    return {one, zero};
}

/// ln of r over the reference rate at which the factor alone would be 1 + excess > 1.
template <class T>
FPM_KERNEL T logRateOfFactor(const GeneralConstants<ScalarOf<T>>& m, const T& excess)
{
    const T inverse = T(ScalarOf<T>(1) / m.rateCoefficient);
    return m.rateLaw == RateLaw::cowperSymonds ? inverse * naturalLogarithm(excess)
                                               : inverse * excess;
}

} // namespace fpm
