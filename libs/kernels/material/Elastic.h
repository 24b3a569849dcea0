#pragma once

#include "kernels/material/Material.h"

namespace fpm {

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

struct Elastic : MaterialLaw {
    static constexpr const char *word = "elastic", *name = "elastic";
    static constexpr bool plastic = false, general = false, everyElement = true;

    template <class Work>
    FPM_KERNEL static constexpr KeptState kept(const MaterialConstants<Work>&)
    {
        return {false};
    }
};

} // namespace fpm
