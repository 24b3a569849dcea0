#pragma once

#include <array>
#include <vector>

namespace fpm {

/// A factor over time: constant 1, a table (linear between rows, held outside), or a smooth step
/// tau^3 (10 - 15 tau + 6 tau^2) from row to row (method of Abaqus' smooth amplitude).
struct Amplitude {
    enum class Kind { constant, table, smooth } kind = Kind::constant;
    std::vector<std::array<double, 2>> rows{{0.0, 1.0}}; ///< time, factor
    double operator()(double time) const;
    bool operator==(const Amplitude&) const = default;
};

} // namespace fpm
