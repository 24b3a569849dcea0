#pragma once

#include "advise/Advice.h"
#include "advise/Results.h"
#include "case/Case.h"

namespace fpm {

/// Runs a copy of the case up to `share` of its end with twenty frames, and removes it again. The
/// copy gets a new mesh where the case has a meshDict. Throws Error(numericalStop) where a program
/// fails.
Results pilotRun(const Case& theCase, const Model& model, double share, Log& log);

/// Runs the case as it is and with each piece of advice, in copies that are removed again; prints
/// time and the difference of every column of every history, relative L2. Columns that a cut leaves
/// without meaning (across the planes) are left out, resultants are multiplied. The largest is
/// noted in `advice`.
void measureAdvice(const Case& theCase, const Model& model, std::vector<Advice>& advice, Log& log);

} // namespace fpm
