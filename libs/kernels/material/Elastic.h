#pragma once

#include "kernels/material/MaterialConstants.h"
#include "parallel/Vec3.h"

namespace fpm {

/// Outcome of a stress update beyond the stress itself.
template <class T>
struct PlasticStep {
    T strainIncrement; ///< of the equivalent plastic strain
    T work;            ///< plastic work of the stress per volume
    T reduction;       ///< fraction of the trial deviator removed by the return mapping, 0 when
                       ///< elastic
};

/// Isotropic linear elasticity, eq. (7) of the paper: stress + lambda tr(e) I + 2 mu e (part model
/// `elastic`; no plastic state is stored).
template <class T>
FPM_KERNEL Sym3<T>
elasticStress(const MaterialConstants<ScalarOf<T>>& m, const Sym3<T>& stress, const Sym3<T>& strain)
{
    const T volumetric = T(m.lambda) * (strain.xx + strain.yy + strain.zz);
    const T twoMu = T(m.twoMu);
    return {fusedMultiplyAdd(twoMu, strain.xx, stress.xx + volumetric),
            fusedMultiplyAdd(twoMu, strain.yy, stress.yy + volumetric),
            fusedMultiplyAdd(twoMu, strain.zz, stress.zz + volumetric),
            fusedMultiplyAdd(twoMu, strain.xy, stress.xy),
            fusedMultiplyAdd(twoMu, strain.yz, stress.yz),
            fusedMultiplyAdd(twoMu, strain.zx, stress.zx)};
}

struct Elastic {
    static constexpr bool plastic = false;
    static constexpr bool general = false;
};

} // namespace fpm
