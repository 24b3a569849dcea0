#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fpm {

/// Least number of insertions, deletions, replacements and swaps of neighbours between two words
/// (Damerau-Levenshtein distance, optimal string alignment).
std::size_t editDistance(std::string_view first, std::string_view second);

/// The candidate nearest to `word`, if it is at most 2 edits and a third of the word away. The
/// first of equals wins.
std::optional<std::string> nearest(std::string_view word,
                                   const std::vector<std::string>& candidates);

/// "did you mean 'x'?  valid here: a, b, ..." without the parts that do not apply.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c", cut after 30 names.
std::string listed(const std::vector<std::string>& names);

} // namespace fpm
