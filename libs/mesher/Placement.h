#pragma once

#include "base/Types.h"
#include "dictionary/Dictionary.h"

#include <array>
#include <string>

namespace fpm {

/// Where a cylinder stands: its local z runs along `axis` from `base`, its sector begins `turns`
/// quarter turns after local x. Local (x, y, z) are the global (y, z, x) for axis x and (z, x, y)
/// for axis y, so that no axis mirrors.
struct Placement {
    Point base;
    int axis = 2;
    int turns = 0;    ///< startAngle / 90
    int quarters = 4; ///< of the sector

    /// Keys base, axis, sector, startAngle.
    static Placement read(const Dictionary& entry);
    /// Global place of a point given in the unturned section and by its global station along the
    /// axis.
    Point global(std::array<double, 2> section, double station) const;
    /// "symX", "symY" or "symZ": the plane through the axis which is y = 0 (`second` false) or x =
    /// 0 of the unturned section, named after its global normal.
    std::string symmetryFace(bool second) const;
};

} // namespace fpm
