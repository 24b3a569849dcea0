#pragma once

#include "parallel/Vec3.h"

namespace fpm {

/// Tension > 0.
template <class T>
FPM_KERNEL T meanStress(const Sym3<T>& s)
{
    using Real = ScalarOf<T>;
    return (s.xx + s.yy + s.zz) * T(Real(1) / Real(3));
}

template <class T>
FPM_KERNEL Sym3<T> deviatorOf(const Sym3<T>& s)
{
    const T mean = meanStress(s);
    return {s.xx - mean, s.yy - mean, s.zz - mean, s.xy, s.yz, s.zx};
}

/// Size of an elastic trial stress, by which a return mapping begins.
template <class T>
struct TrialStress {
    T square;     ///< q^2, q the Mises stress; never 0
    T equivalent; ///< of stretch and bending, (q_b + sqrt(q_b^2 + 4 q^2)) / 2: see radialReturn

    /// `bending`: q_b, the equivalent bending stress of the section (PhysicalHourglass), 0 for
    /// none.
    FPM_KERNEL TrialStress(const Sym3<T>& deviator, const T& bending)
    {
        using Real = ScalarOf<T>;
        // The smallest normal number avoids 0/0 where there is no stress.
        square = fusedMultiplyAdd(T(Real(1.5)), contract(deviator, deviator), T(Real(1e-30)));
        equivalent =
            T(Real(0.5))
            * (bending + squareRoot(fusedMultiplyAdd(bending, bending, T(Real(4)) * square)));
    }
};

} // namespace fpm
