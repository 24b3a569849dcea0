#pragma once

#include "mesh/Mesh.h"

#include <optional>

namespace fpm {

/// A few elements so much smaller than most that the time step of all follows from them.
struct SmallElements {
    std::size_t count = 0, total = 0; ///< of size up to twice the least; of all that have a size
    std::vector<std::string> parts{}; ///< they lie in
    double least = 0, ordinary = 0;   ///< sizes: the least, the median of all
    Point lower{}, upper{};           ///< box around their centres
    double ratio() const { return ordinary / least; }
};

/// Small elements by `sizes` [element], heights or stable steps; 0 for elements that do not count.
/// Nothing where the least is no less than a third of the median, or a tenth of all are as small.
std::optional<SmallElements> smallElements(const Mesh& mesh, const std::vector<double>& sizes);

/// "16 of 256 elements (part b, between (20.5 1 1) and (20.5 9 9))": the box around their centres.
std::string smallElementsText(const SmallElements& few);

/// Height of each element: volume by largest side.
std::vector<double> elementHeights(const Mesh& mesh);

} // namespace fpm
