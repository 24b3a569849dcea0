#include "base/Format.h"

#include <charconv>

namespace fpm {

namespace {

// The longest shortest-form double has 24 characters; 17 significant digits are all there are.
constexpr std::size_t bufferSize = 64;
constexpr int mostDigits = 17;

} // namespace

std::string toText(double value)
{
    char buffer[bufferSize];
    const auto end = std::to_chars(buffer, buffer + bufferSize, value).ptr;
    return {buffer, end};
}

std::string toText(double value, int digits)
{
    char buffer[bufferSize];
    const int precision = digits < 1 ? 1 : (digits > mostDigits ? mostDigits : digits);
    const auto end =
        std::to_chars(buffer, buffer + bufferSize, value, std::chars_format::general, precision)
            .ptr;
    return {buffer, end};
}

std::string formatTexts(std::string_view pattern, std::initializer_list<std::string> texts)
{
    constexpr std::string_view mark = "{}";
    std::string result;
    for (const auto& text : texts) {
        const auto place = pattern.find(mark);
        if (place == std::string_view::npos) break;
        result.append(pattern.substr(0, place)).append(text);
        pattern.remove_prefix(place + mark.size());
    }
    return result.append(pattern);
}

} // namespace fpm
