#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace fpm {

/// Whether `text` is ["-"] digits ["." digits*] [("e"|"E") ["+"|"-"] digits], nothing else.
bool isNumber(std::string_view text);

/// The double nearest to `text`, whatever the locale; below the smallest double it is 0. Empty for
/// what is no number (nan, inf, 0x10, +2, .5, 1,5) or exceeds the largest double.
std::optional<double> readNumber(std::string_view text);

/// A 64-bit integer in plain digits; empty for anything else, 1e3 and 2.0 included.
std::optional<std::int64_t> readInteger(std::string_view text);

} // namespace fpm
