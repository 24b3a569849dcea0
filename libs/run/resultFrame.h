#pragma once

#include "io/VtkHdf.h"
#include "solver/Solver.h"

namespace fpm {

/// The fields of one output time: U V and, with contact, FCONT CPRESS GAP on nodes, S Mises PEEQ
/// Part on elements, HourglassEnergy BendingEnergy Utilisation where a part has them
/// (SectionFields), TEMP, STATUS.
Frame resultFrame(Solver& solver, const Model& model);

} // namespace fpm
