#pragma once

#include "case/Case.h"

#include <string>

namespace fpm {

/// A chartDict for this case, to be cut and edited: its element sizes and forms of element, then
/// precision, time step and penalty one at a time; probes for its histories. Throws
/// Error(dictionary) where the case has no history to chart.
std::string proposedChartDict(const Case& theCase);

} // namespace fpm
