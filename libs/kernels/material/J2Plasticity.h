#pragma once

#include "kernels/material/Elastic.h"
#include "kernels/material/HardeningCurve.h"

namespace fpm {

/// Radial return of the elastic trial stress to the yield surface sqrt(3 J2) = sigma_y(ebar) (Simo
/// and Hughes); eq. (8) of the paper in other variables, ||s|| = kappa = sqrt(2/3) sigma_y. Exact
/// for each linear piece: q_tr - 3 mu d = sigma_y + H (ebar + d - strain). Stress is changed in
/// place. `bending`: equivalent bending stress q_b of the section (PhysicalHourglass), 0 for none.
/// Yield is then the limit surface of a solid section, (q / sigma_y)^2 + q_b / sigma_y = 1, with
/// the equivalent stress (q_b + sqrt(q_b^2 + 4 q^2)) / 2; membrane and bending are reduced by the
/// same factor, which flowOfSection then corrects.
template <class T>
FPM_KERNEL PlasticStep<T> radialReturn(const MaterialConstants<ScalarOf<T>>& m,
                                       const T& plasticStrain,
                                       const T& bending,
                                       Sym3<T>& s)
{
    using Real = ScalarOf<T>;
    const T zero = T(Real(0));
    const Sym3<T> deviator = deviatorOf(s);
    const TrialStress<T> size(deviator, bending);
    const T trial = size.equivalent;

    T increment = (trial - T(m.stress[0]) - T(m.slope[0]) * (plasticStrain - T(m.strain[0])))
                  * T(Real(1) / (m.threeMu + m.slope[0]));
    for (int row = 1; row < m.rows; ++row) {
        const auto beyond = plasticStrain + maximum(increment, zero) > T(m.strain[row]);
        const T here =
            (trial - T(m.stress[row]) - T(m.slope[row]) * (plasticStrain - T(m.strain[row])))
            * T(Real(1) / (m.threeMu + m.slope[row]));
        increment = select(beyond, here, increment);
    }
    increment = maximum(increment, zero);

    // Subtraction leaves an elastic stress unchanged to the last bit.
    const T reduction = T(m.threeMu) * increment / trial;
    s = s + (-reduction) * deviator;
    return {increment, (T(Real(1)) - reduction) * increment * (size.square / trial), reduction};
}

/// J2 flow with tabulated isotropic hardening sigma_y(ebar), piecewise linear.
struct J2Plasticity : MaterialLaw {
    static constexpr const char *word = "elastoplastic", *name = "J2 plasticity";
    static constexpr bool general = false, heats = true, everyElement = true;

    template <class Work>
    FPM_KERNEL static constexpr KeptState kept(const MaterialConstants<Work>&)
    {
        return {true};
    }
    template <class T>
    FPM_KERNEL static PlasticStep<T> update(const MaterialConstants<ScalarOf<T>>& m,
                                            const FlowPoint<T>& point,
                                            Sym3<T>& stress,
                                            Sym3<T>&)
    {
        return radialReturn<T>(m, point.plasticStrain, point.bending, stress);
    }
    template <class T>
    FPM_KERNEL static T
    strength(const MaterialConstants<ScalarOf<T>>& m, const FlowPoint<T>& point, const Sym3<T>&)
    {
        return hardeningCurve<T>(m, point.plasticStrain).value;
    }
};

} // namespace fpm
