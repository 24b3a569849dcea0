#pragma once

#include "advise/Advice.h"
#include "advise/Results.h"
#include "case/Case.h"

namespace fpm {

/// Advice from results: parts that move as rigid bodies, parts that stay far from yield, pairs that
/// stayed apart, friction, bulk viscosity and mass damping that do no work; and mixed precision,
/// which only a comparison can judge.
std::vector<Advice> pilotAdvice(const Model& model, const Case& theCase, const Results& results);

} // namespace fpm
