#pragma once

#include "solver/Solver.h"

namespace fpm {

/// What single-point elements hold beside the stress, [element]; 0 for deleted elements and where a
/// part has no such thing.
struct SectionFields {
    std::vector<double> hourglass; ///< energy per volume of spurious modes; viscous form: 0
    std::vector<double> bending;   ///< of the bending that the physical form knows
    /// Stress of the limit surface, stretch and bending together, over the slow yield stress at the
    /// present strain and temperature: 1 on the surface, more at high rates; 1 where no Mises
    /// stress is borne, as at the apex of a cone.
    std::vector<double> utilisation;
};

/// `points`: present positions.
SectionFields sectionFields(Solver& solver, const Model& model, const std::vector<Point>& points);

} // namespace fpm
