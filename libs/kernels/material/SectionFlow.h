#pragma once

#include "kernels/material/Elastic.h"

namespace fpm {

/// Result of the return mapping of a section that stretches and bends at once.
template <class T>
struct SectionFlow {
    T bendingKept; ///< fraction of the trial bending that remains
    T bendingWork; ///< plastic work of the bending per volume
};

/// Equivalent stress of stretch and bending on the limit surface of a solid section: equals the
/// yield stress on (stretch / yield)^2 + bending / yield = 1.
template <class T>
FPM_KERNEL T sectionStress(const T& stretch, const T& bending)
{
    using Real = ScalarOf<T>;
    return T(Real(0.5))
           * (bending
              + squareRoot(fusedMultiplyAdd(bending, bending, T(Real(4)) * stretch * stretch)));
}

/// `to` plus fraction `direction` where `mask` is set.
template <class Mask, class T>
FPM_KERNEL Sym3<T>
moved(const Mask& mask, const Sym3<T>& to, const T& share, const Sym3<T>& direction)
{
    return {select(mask, to.xx + share * direction.xx, to.xx),
            select(mask, to.yy + share * direction.yy, to.yy),
            select(mask, to.zz + share * direction.zz, to.zz),
            select(mask, to.xy + share * direction.xy, to.xy),
            select(mask, to.yz + share * direction.yz, to.yz),
            select(mask, to.zx + share * direction.zx, to.zx)};
}

/// Associated flow on the limit surface n^2 + m = 1 of a solid section, n = q / sigma_y of the
/// stress and m = q_b / sigma_y of the bending: the ratio of plastic curvature to plastic stretch
/// is 1 to 2 n, so that the neutral axis lies where that of the section does; at the end m = 0 no
/// bending remains. Then layers of elements carry the plastic moment of the whole section, whatever
/// their number. `plastic` and `s` come from the radial return, which has reduced both by the same
/// factor: it determines sigma_y, this function the point on the surface. With p the flow, n = n_tr
/// / (1 + p) and m = m_tr - k p, k = (stiffness of the bending) / (6 mu + 2 H). `bendingEnergy`:
/// twice the elastic energy of the trial bending per volume. `kinematic`: modulus H of the
/// backstress, 0 for none; the stress is then measured from the backstress, and both change.
/// Bending has no backstress.
template <class T>
FPM_KERNEL SectionFlow<T> flowOfSection(const MaterialConstants<ScalarOf<T>>& m,
                                        const T& bending,
                                        const T& bendingEnergy,
                                        ScalarOf<T> kinematic,
                                        PlasticStep<T>& plastic,
                                        Sym3<T>& s,
                                        Sym3<T>& backstress)
{
    using Real = ScalarOf<T>;
    const T zero = T(Real(0)), one = T(Real(1)), two = T(Real(2)), tiny = T(Real(1e-30));
    const auto flows = plastic.reduction > zero;
    if (!NumberTraits<T>::any(flows)) return {one, zero};
    const Real stiffness = m.threeMu + kinematic;
    Sym3<T> deviator = deviatorOf(s);
    if (kinematic > Real(0)) deviator = deviator + T(Real(-1)) * backstress;
    const T inverseKept = one / (one - plastic.reduction);
    const T q = inverseKept
                * squareRoot(fusedMultiplyAdd(T(Real(1.5)), contract(deviator, deviator), tiny));
    const T yield = (one - plastic.reduction) * sectionStress<T>(q, bending);
    const T n = q / yield, bend = bending / yield;
    const T k = bending * bending / (T(Real(2) * stiffness) * bendingEnergy + tiny);

    // The overstress decreases with p and is convex: Newton's method converges from below. The rest
    // after three iterations is removed radially.
    T p = zero;
    for (int round = 0; round < 3; ++round) {
        const T g = one / (one + p), stretch = n * g;
        const T over = fusedMultiplyAdd(stretch, stretch, bend - k * p - one);
        p += over / fusedMultiplyAdd(two * stretch * stretch, g, k + tiny);
    }
    const T g = one / (one + p), left = maximum(bend - k * p, zero);
    const T fit = one / sectionStress<T>(n * g, left);
    const auto inside = k + bend > n * k; // of the edge m = 0
    const T stretchKept = select(inside, g * fit, one / n);
    const T bendingKept = select(flows, select(inside, left * fit / (bend + tiny), zero), one);

    // An elastic stress stays unchanged to the last bit, whatever the other lanes of its batch do.
    const T change = stretchKept * inverseKept - one;
    s = moved(flows, s, T(m.threeMu / stiffness) * change, deviator);
    const T strain = (one - stretchKept) * q * T(Real(1) / stiffness);
    T work = stretchKept * q * strain; // on the stress less the backstress
    const T bendingWork = bendingKept * (one - bendingKept) * bendingEnergy;
    plastic.strainIncrement = (select(flows, work, zero) + bendingWork) / yield;
    if (kinematic > Real(0)) {
        backstress = moved(flows, backstress, T(-kinematic / stiffness) * change, deviator);
        work = fusedMultiplyAdd(T(Real(1.5)) * contract(backstress, deviator) * inverseKept / q,
                                strain, work);
    }
    plastic.reduction = select(flows, one - stretchKept, zero);
    plastic.work = select(flows, work, zero);
    return {bendingKept, bendingWork};
}

/// Largest share of its bending that a section loses in one step under SectionRule::radial.
inline constexpr double largestSectionLoss = 0.1;

/// The bending loses the share that the deviator has lost, at most a tenth in a step. At the apex
/// of a cone nothing is left of the deviator at once; the motions that one point cannot see then
/// meet a viscous resistance instead of none, and bear no load at rest.
template <class T>
FPM_KERNEL SectionFlow<T> radialSection(const T& bendingEnergy, const PlasticStep<T>& plastic)
{
    using Real = ScalarOf<T>;
    const T kept = maximum(T(Real(1)) - plastic.reduction, T(Real(1 - largestSectionLoss)));
    return {kept, kept * (T(Real(1)) - kept) * bendingEnergy};
}

} // namespace fpm
