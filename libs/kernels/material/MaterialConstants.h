#pragma once

#include "base/Types.h"

namespace fpm {

inline constexpr int maxHardeningRows = 32;

/// How the rigid rotation of a step is found; the values are those of the dictionary's words.
enum class RotationRule : int { midSurface, arcsine, polar, hughesWinget };

/// What only GeneralPlasticity reads: options that a part may choose at run time.
template <class Work>
struct GeneralConstants {
    RotationRule rotation;
};

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
    int rows;              ///< of the hardening table, 0: never yields
    Work strain[maxHardeningRows], stress[maxHardeningRows], slope[maxHardeningRows];
    GeneralConstants<Work> general;
};

} // namespace fpm
