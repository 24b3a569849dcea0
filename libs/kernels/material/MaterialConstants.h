#pragma once

#include "base/Types.h"

namespace fpm {

inline constexpr int maxHardeningRows = 32;
inline constexpr int maxLawConstants = 12;

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

    /// The same in another type.
    template <class To>
    GeneralConstants<To> converted() const
    {
        return {.rotation = rotation,
                .kinematicModulus = To(kinematicModulus),
                .powerModulus = To(powerModulus),
                .powerExponent = To(powerExponent),
                .rateLaw = rateLaw,
                .referenceRate = To(referenceRate),
                .rateCoefficient = To(rateCoefficient),
                .heatPerWork = To(heatPerWork),
                .temperature = To(temperature),
                .softeningExponent = To(softeningExponent),
                .roomTemperature = To(roomTemperature),
                .inverseMeltingRange = To(inverseMeltingRange),
                .erosionStrain = To(erosionStrain),
                .erodes = erodes,
                .erodesInverted = erodesInverted};
    }
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
    Work law[maxLawConstants]; ///< of the part's law beyond these, see MaterialLaw

    /// The same in another type.
    template <class To>
    MaterialConstants<To> converted() const
    {
        MaterialConstants<To> to{.lambda = To(lambda),
                                 .twoMu = To(twoMu),
                                 .threeMu = To(threeMu),
                                 .pressureWaveModulus = To(pressureWaveModulus),
                                 .young = To(young),
                                 .poisson = To(poisson),
                                 .linearViscosity = To(linearViscosity),
                                 .quadraticViscosity = To(quadraticViscosity),
                                 .hourglass = To(hourglass),
                                 .coupledHourglass = To(coupledHourglass),
                                 .rows = rows,
                                 .floatHourglass = floatHourglass,
                                 .strain = {},
                                 .stress = {},
                                 .slope = {},
                                 .general = general.template converted<To>(),
                                 .law = {}};
        for (int row = 0; row < rows; ++row) {
            to.strain[row] = To(strain[row]);
            to.stress[row] = To(stress[row]);
            to.slope[row] = To(slope[row]);
        }
        for (int i = 0; i < maxLawConstants; ++i) to.law[i] = To(law[i]);
        return to;
    }
};

} // namespace fpm
