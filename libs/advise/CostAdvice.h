#pragma once

#include "advise/Advice.h"
#include "advise/Results.h"

#include <optional>

namespace fpm {

/// Parts that yield while their hourglass control stays elastic: it bears what the section cannot
/// bear any more. With results only those that have yielded.
std::optional<Advice> hourglassAdvice(const Model& model, const std::optional<Results>& results);

/// Runs whose steps were shorter than their elements allow, since contact springs bound them.
std::optional<Advice> contactStepAdvice(const Model& model, const Results& results);

/// A few elements so small that the time step of all follows from them: no edit of a
/// dictionary cures it.
std::optional<Advice> elementsAdvice(const Model& model);

/// A number of threads that does not fit a machine with so many cores.
std::optional<Advice> threadsAdvice(const Model& model, int cores);

} // namespace fpm
