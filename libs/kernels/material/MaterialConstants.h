#pragma once

#include "base/Types.h"

namespace fpm {

inline constexpr int maxHardeningRows = 32;

/// Rule for the rigid rotation of a step; the values are those of the dictionary's words.
enum class RotationRule : int { midSurface, arcsine, polar, hughesWinget };

/// Dependence of the yield stress on the plastic strain rate.
enum class RateLaw : int { none, cowperSymonds, logarithmic };

/// Constants that only GeneralPlasticity reads: options of a part at run time; all zero: none.
template <class Work>
struct GeneralConstants {
    RotationRule rotation;
    Work kinematicModulus; ///< H_k of the backstress, 2/3 H_k its rate over that of plastic strain
    Work powerModulus, powerExponent; ///< B e^n, added to the table
    RateLaw rateLaw;
    Work referenceRate;   ///< D of Cowper and Symonds, rate0 of Johnson and Cook
    Work rateCoefficient; ///< 1/p, or C
    Work heatPerWork;     ///< fraction of plastic work over specific heat; 0: no temperature is
                          ///< stored
    Work temperature;     ///< at the start
    Work softeningExponent, roomTemperature; ///< m of 1 - T*^m; 0: no softening
    Work inverseMeltingRange;                ///< 1 / (melting - room temperature)
    Work erosionStrain; ///< equivalent plastic strain beyond which an element is deleted
    bool erodes;        ///< elements may be deleted at all
    bool erodesInverted;
};

/// Constants of one part's material and element options in its working type.
template <class Work>
struct MaterialConstants {
    Work lambda, twoMu, threeMu;
    Work pressureWaveModulus; ///< lambda + 2 mu
    Work young, poisson;
    Work linearViscosity, quadraticViscosity;
    Work hourglass;        ///< coefficient of the chosen form
    Work coupledHourglass; ///< 1: the physical form yields with the section; 0: it stays elastic
    int rows;              ///< of the hardening table, 0: never yields
    bool floatHourglass;   ///< hourglass forces are kept as floats (StateLayout)
    Work strain[maxHardeningRows], stress[maxHardeningRows], slope[maxHardeningRows];
    GeneralConstants<Work> general;
};

} // namespace fpm
