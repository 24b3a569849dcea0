#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>

namespace fpm {

/// Shortest text that reads back as the same double (std::to_chars), independent of the locale.
std::string toText(double value);
/// `digits` significant digits, as printf %.{digits}g, independent of the locale.
std::string toText(double value, int digits);
template <std::integral T>
std::string toText(T value)
{
    return std::to_string(value);
}
inline std::string toText(std::string_view text)
{
    return std::string(text);
}
inline std::string toText(const char* text)
{
    return text;
}
inline std::string toText(const std::string& text)
{
    return text;
}

/// Replaces the successive "{}" of `pattern` by the given texts.
std::string formatTexts(std::string_view pattern, std::initializer_list<std::string> texts);

/// format("{} nodes in part '{}'", n, name). Doubles print as with 6 significant digits.
template <class... Values>
std::string format(std::string_view pattern, const Values&... values)
{
    const auto text = [](const auto& value) {
        if constexpr (std::floating_point<std::decay_t<decltype(value)>>)
            return toText(double(value), 6);
        else
            return toText(value);
    };
    return formatTexts(pattern, {text(values)...});
}

} // namespace fpm
