#include "mesher/Stations.h"

#include "base/Error.h"
#include "base/Format.h"

#include <cmath>

namespace fpm {

std::vector<double> stations(double first, double last, int cells, double grading)
{
    const double length = last - first;
    const double exponent = cells > 1 ? std::log(grading) / (cells - 1) : 0;
    const auto distance = [&](int station) {
        // Multiplied before divided: a length of 50 in 20 cells has its stations at round numbers.
        if (exponent == 0) return length * station / cells;
        // Geometric series by expm1, which stays accurate as the grading goes to one.
        return length * std::expm1(station * exponent) / std::expm1(cells * exponent);
    };
    std::vector<double> places(cells + 1);
    for (int station = 0; station < cells; ++station) places[station] = first + distance(station);
    places[cells] = last;
    return places;
}

int stationOf(double reference, int cells)
{
    constexpr double tolerance = 1e-3; // of a cell; gmsh's own error is below 1e-6
    const double place = reference * cells;
    const double nearest = std::round(place);
    if (!(std::abs(place - nearest) < tolerance))
        throw Error(ExitCode::mesh,
                    format("gmsh put a node at {} cells from the start of a row of {}, "
                           "which should be a whole number",
                           place, cells));
    return int(nearest);
}

} // namespace fpm
