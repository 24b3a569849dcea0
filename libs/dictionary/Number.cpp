#include "dictionary/Number.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace fpm {

namespace {

constexpr std::string_view digits = "0123456789";

/// Takes the digits at the front of `text` away and returns how many there were.
std::size_t dropDigits(std::string_view& text)
{
    const auto count = std::min(text.find_first_not_of(digits), text.size());
    text.remove_prefix(count);
    return count;
}

bool dropOneOf(std::string_view& text, std::string_view characters)
{
    if (text.empty() || characters.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
}

/// Distinguishes underflow from overflow, for a text that from_chars found out of range.
bool isBelowOne(std::string_view number)
{
    const auto mark = number.find_first_of("eE");
    const auto mantissa = number.substr(0, mark);
    const auto first = static_cast<std::int64_t>(mantissa.find_first_of("123456789"));
    const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa.size()));

    std::int64_t exponent = 0;
    if (mark != std::string_view::npos) {
        auto text = number.substr(mark + 1);
        dropOneOf(text, "+");
        const auto read = std::from_chars(text.data(), text.data() + text.size(), exponent);
        if (read.ec == std::errc::result_out_of_range) return text.front() == '-';
    }
    constexpr std::int64_t farAway = std::numeric_limits<std::int64_t>::max() / 2;
    return point - first + std::clamp(exponent, -farAway, farAway) <= 0;
}

} // namespace

bool isNumber(std::string_view text)
{
    dropOneOf(text, "-");
    std::size_t count = dropDigits(text);
    if (dropOneOf(text, ".")) count += dropDigits(text);
    if (count == 0) return false;
    if (dropOneOf(text, "eE")) {
        dropOneOf(text, "+-");
        if (dropDigits(text) == 0) return false;
    }
    return text.empty();
}

std::optional<double> readNumber(std::string_view text)
{
    if (!isNumber(text)) return std::nullopt;

    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec == std::errc()) return value;
    if (isBelowOne(text)) return 0.0;
    return std::nullopt;
}

std::optional<std::int64_t> readInteger(std::string_view text)
{
    if (text.find_first_not_of("-0123456789") != std::string_view::npos) return std::nullopt;

    std::int64_t value = 0;
    const auto end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return value;
}

} // namespace fpm
