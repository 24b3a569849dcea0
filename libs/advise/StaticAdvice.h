#pragma once

#include "advise/Advice.h"
#include "case/Case.h"
#include "model/Model.h"

#include <optional>

namespace fpm {

/// Half, quarter or eighth: every mirror plane of the model at once. Nothing where there is none.
std::optional<Advice> symmetryAdvice(const Model& model, Log& log);

/// Pairs of surfaces that cannot meet as long as no node is faster than twice the largest speed
/// that initial conditions and prescribed motion contain. None with loads, which accelerate without
/// bound.
std::vector<Advice> pairAdvice(const Model& model);

/// Frames that system/probeDict does not read, and histories with more rows than a plot can show.
std::vector<Advice> outputAdvice(const Model& model, const Case& theCase);

/// The box of a pair's contactor and target, moved by `displacement` to all sides: whether they are
/// apart.
bool apart(const Mesh& mesh, const ContactPair& pair, const std::vector<double>& displacement);

} // namespace fpm
