#pragma once

#include <vector>

namespace fpm {

/// The cells + 1 places from `first` to `last`, both exact; the last cell is `grading` times as
/// long as the first, each the same multiple of the one before.
std::vector<double> stations(double first, double last, int cells, double grading = 1);

/// Number of the station that `reference` in 0 ... 1 stands for among `cells` equal cells. Throws
/// Error(mesh) when it lies between two, for then the mesh is not the one asked for.
int stationOf(double reference, int cells);

} // namespace fpm
