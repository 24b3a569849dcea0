#pragma once

#include "stability/StabilityMap.h"

namespace fpm {

/// First failures of all rows of a map whose x is the step, as multiples of what `bound` gives;
/// without those of penetration, which no step cures.
struct Onset {
    double least = 0, median = 0, most = 0;
    std::size_t point = 0; ///< the one that fails at the least
    /// A bound is one as long as nothing fails below it.
    bool isBound() const { return least >= 1; }
};
/// Nothing where no row fails or x is not the step.
std::optional<Onset> onsetOf(const StabilityMap& map, double (*bound)(const Bounds&));
/// Of Bounds::withContact and of Bounds::both.
std::optional<Onset> onsetOfContact(const StabilityMap& map);
std::optional<Onset> onsetOfBoth(const StabilityMap& map);

/// One sentence: how many points, whether a predicted-stable one failed, where failure begins, and
/// whether what was predicted is a bound here.
std::string conclusionOf(const StabilityMap& map);

/// "this case: ...": where it lies, its margin to what is predicted and to the first failure that
/// the map shows beside it; why it is not on the map; empty for scenes that are no case.
std::string ownSentence(const StabilityMap& map);

} // namespace fpm
