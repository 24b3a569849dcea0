#pragma once

#include "base/Types.h"

namespace fpm {

inline constexpr int maxHardeningRows = 32;

/// What the kernels need to know of one part's material and element options, in its working type.
template <class Work>
struct MaterialConstants {
    Work lambda, twoMu, threeMu;
    Work pressureWaveModulus; ///< lambda + 2 mu
    Work young, poisson;
    Work waveSpeed; ///< sqrt((lambda + 2 mu) / density), undeformed
    Work linearViscosity, quadraticViscosity;
    Work hourglass;        ///< coefficient of the chosen form
    Work coupledHourglass; ///< 1: physical form yields with the section; 0: stays elastic
    int rows;              ///< of the hardening table
    Work strain[maxHardeningRows], stress[maxHardeningRows], slope[maxHardeningRows];
};

} // namespace fpm
