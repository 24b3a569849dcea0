#include "base/Format.h"
#include "dictionary/Dictionary.h"
#include "dictionary/Suggestion.h"
#include "dictionary/ValueReader.h"

#include <limits>

namespace fpm {

namespace {

std::string numberOf(const Range& range)
{
    const auto limits = range.text();
    return limits.empty() ? "a number" : "a number " + limits;
}

std::string integerBetween(std::int64_t lower, std::int64_t upper)
{
    using Limits = std::numeric_limits<std::int64_t>;
    if (lower == Limits::min() && upper == Limits::max()) return "an integer";
    if (upper == Limits::max()) return format("an integer >= {}", lower);
    if (lower == Limits::min()) return format("an integer <= {}", upper);
    return format("an integer between {} and {}", lower, upper);
}

std::string rowsOf(std::size_t columns)
{
    std::string row;
    for (std::size_t column = 0; column < columns; ++column)
        row += std::string(column == 0 ? "" : " ") + char('a' + column % 26);
    return format("a list of rows of {} numbers (({}) ...)", columns, row);
}

} // namespace

double Dictionary::number(std::string_view key, const Range& range) const
{
    return ValueReader(*node_, key, numberOf(range)).number(range);
}

double Dictionary::numberOr(std::string_view key, double preset, const Range& range) const
{
    return has(key) ? number(key, range) : preset;
}

std::int64_t Dictionary::integer(std::string_view key, std::int64_t lower, std::int64_t upper) const
{
    return ValueReader(*node_, key, integerBetween(lower, upper)).integer(lower, upper);
}

std::int64_t Dictionary::integerOr(std::string_view key,
                                   std::int64_t preset,
                                   std::int64_t lower,
                                   std::int64_t upper) const
{
    return has(key) ? integer(key, lower, upper) : preset;
}

bool Dictionary::switchOr(std::string_view key, bool preset) const
{
    if (!has(key)) return preset;
    const auto value = choice(key, {"yes", "no", "on", "off", "true", "false"});
    return value == "yes" || value == "on" || value == "true";
}

std::string Dictionary::word(std::string_view key) const
{
    return ValueReader(*node_, key, "a word").word();
}

std::string Dictionary::wordOr(std::string_view key, std::string_view preset) const
{
    return has(key) ? word(key) : std::string(preset);
}

std::string Dictionary::choice(std::string_view key, const std::vector<std::string>& allowed) const
{
    return ValueReader(*node_, key, "one of " + listed(allowed)).choice(allowed);
}

std::string Dictionary::choiceOr(std::string_view key,
                                 std::string_view preset,
                                 const std::vector<std::string>& allowed) const
{
    return has(key) ? choice(key, allowed) : std::string(preset);
}

Point Dictionary::vector(std::string_view key) const
{
    const ValueReader reader(*node_, key, "a vector (x y z)");
    const auto values = reader.list(0);
    Point point{};
    if (values.size() != point.size()) reader.refuse();
    std::copy(values.begin(), values.end(), point.begin());
    return point;
}

Point Dictionary::vectorOr(std::string_view key, const Point& preset) const
{
    return has(key) ? vector(key) : preset;
}

std::vector<double> Dictionary::numbers(std::string_view key) const
{
    return ValueReader(*node_, key, "a list of numbers (a b ...)").list(0);
}

std::vector<std::string> Dictionary::words(std::string_view key) const
{
    return ValueReader(*node_, key, "a word or a list of words (a b ...)").words();
}

std::vector<std::string> Dictionary::items(std::string_view key) const
{
    return ValueReader(*node_, key, "a value or a list of values (a b ...)").items();
}

std::vector<std::vector<double>> Dictionary::rows(std::string_view key, std::size_t columns) const
{
    return ValueReader(*node_, key, rowsOf(columns)).rows(0, columns);
}

std::string Dictionary::leadingWord(std::string_view key) const
{
    return ValueReader(*node_, key, "a word and what belongs to it").firstWord();
}

std::vector<std::vector<double>> Dictionary::tailRows(std::string_view key,
                                                      std::size_t columns) const
{
    const ValueReader reader(*node_, key, "a word and " + rowsOf(columns));
    reader.firstWord();
    return reader.rows(1, columns);
}

std::vector<double> Dictionary::tailNumbers(std::string_view key) const
{
    return ValueReader(*node_, key, "a word and numbers").tail();
}

} // namespace fpm
