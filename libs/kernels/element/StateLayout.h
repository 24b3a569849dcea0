#pragma once

#include "base/Types.h"
#include "kernels/material/Material.h"

#include <cstddef>

namespace fpm {

/// Element values lie in tiles of this many elements: the values of a quantity for a batch of
/// elements are contiguous, at constant strides.
inline constexpr Index tileWidth = 16;

/// Index of value 0 of local element e of a quantity with n values; the others follow at stride
/// tileWidth.
FPM_KERNEL constexpr std::size_t inTiles(Index e, int n)
{
    return std::size_t(e / tileWidth * tileWidth) * std::size_t(n) + std::size_t(e % tileWidth);
}

/// Index, in floats, of value `i` of a row of float tiles that begins where value `first` of a
/// quantity of doubles does; `place`: index of value 0 of that quantity.
FPM_KERNEL constexpr std::size_t inFloatTiles(std::size_t place, int first, int i)
{
    const std::size_t inTile = place % tileWidth;
    return 2 * (place - inTile) + inTile + std::size_t(2 * first + i) * tileWidth;
}

/// Layout of the state of one element of a part. In the working type, one tile per value: the
/// stress of every integration point, the backstress of every one, the hourglass forces (as floats
/// two tiles share the memory of one). In the type of sums: the plastic strain of every point, then
/// its temperature rise. No memory is spent on values that the part does not use. A deleted element
/// (Deletion.h) keeps its energy in its first stress value.
struct StateLayout {
    int points;    ///< integration points, 0 for a part without elements to compute
    int hourglass; ///< number of hourglass forces
    bool plastic;  ///< keeps plastic strain, also where elements may be deleted
    bool kinematic = false;
    bool heats = false;
    bool floatHourglass = false; ///< hourglass forces are floats; only where the others are doubles

    FPM_KERNEL constexpr int stress(int point) const { return 6 * point; }
    FPM_KERNEL constexpr int backstress(int point) const { return 6 * (points + point); }
    FPM_KERNEL constexpr int hourglassForces() const
    {
        return kinematic ? 12 * points : 6 * points;
    }
    FPM_KERNEL constexpr int size() const
    {
        return hourglassForces() + (floatHourglass ? hourglass / 2 : hourglass);
    }
    FPM_KERNEL constexpr int strains() const { return plastic ? points : 0; }
    FPM_KERNEL constexpr int temperature(int point) const { return strains() + point; }
    FPM_KERNEL constexpr int sums() const { return strains() + (heats ? points : 0); }
};

/// What the elements of a part with this law and element keep. `floats`: hourglass forces as
/// floats, where the element has any.
template <class Material, class Element, class Constants>
FPM_KERNEL constexpr StateLayout stateLayout(const Constants& m, bool floats)
{
    const KeptState kept = Material::kept(m);
    bool plastic = kept.plasticStrain;
    if constexpr (Material::general) plastic = plastic || m.general.erodes;
    return {Element::points, Element::stateSize, plastic,
            kept.backstress, kept.temperature,   Element::stateSize > 0 && floats};
}

} // namespace fpm
