#include "dictionary/Suggestion.h"

#include "base/Format.h"

#include <algorithm>

namespace fpm {

namespace {

constexpr std::size_t mostEdits = 2;
constexpr std::size_t mostNames = 48;

} // namespace

std::size_t editDistance(std::string_view first, std::string_view second)
{
    using Row = std::vector<std::size_t>;
    Row beforeLast(second.size() + 1), last(second.size() + 1), row(second.size() + 1);
    for (std::size_t column = 0; column <= second.size(); ++column) last[column] = column;

    for (std::size_t line = 1; line <= first.size(); ++line) {
        row[0] = line;
        for (std::size_t column = 1; column <= second.size(); ++column) {
            const bool equal = first[line - 1] == second[column - 1];
            row[column] = std::min(
                {last[column] + 1, row[column - 1] + 1, last[column - 1] + (equal ? 0 : 1)});
            if (line > 1 && column > 1 && first[line - 1] == second[column - 2]
                && first[line - 2] == second[column - 1])
                row[column] = std::min(row[column], beforeLast[column - 2] + 1);
        }
        std::swap(beforeLast, last);
        std::swap(last, row);
    }
    return last[second.size()];
}

std::optional<std::string> nearest(std::string_view word,
                                   const std::vector<std::string>& candidates)
{
    std::optional<std::string> best;
    auto limit = std::min(mostEdits, word.size() / 3) + 1;
    for (const auto& candidate : candidates) {
        // The table of a hopeless pair is not worth its memory.
        if (candidate.size() > word.size() + mostEdits) continue;
        if (word.size() > candidate.size() + mostEdits) continue;
        const auto distance = editDistance(word, candidate);
        if (distance >= limit) continue;
        limit = distance;
        best = candidate;
    }
    return best;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates)
{
    std::string text;
    if (const auto close = nearest(word, candidates)) text = format("did you mean '{}'?", *close);
    if (candidates.empty()) return text;
    return text + (text.empty() ? "" : "  ") + "valid here: " + listed(candidates);
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (std::size_t number = 0; number < std::min(names.size(), mostNames); ++number)
        text += (number == 0 ? "" : ", ") + names[number];
    return text + (names.size() > mostNames ? ", ..." : "");
}

} // namespace fpm
