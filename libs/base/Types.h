#pragma once

#include <array>
#include <cstdint>

namespace fpm {

/// Number of a node, element, face, patch. Products (8 * elements, ...) are formed in std::size_t.
using Index = std::int32_t;

/// A position or vector on the host, in the case's length unit.
using Point = std::array<double, 3>;

} // namespace fpm
