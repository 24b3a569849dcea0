#include "probe/Ticks.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fpm {

namespace {

std::string fixedText(double value, int decimals)
{
    char buffer[400];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
    std::string text(buffer, end.ptr);
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos)
        text.erase(0, 1);
    if (text.starts_with('-')) text.replace(0, 1, "\u2212"); // a true minus is as wide as digits
    return text;
}

std::string superscript(int number)
{
    static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(number)) text += c == '-' ? "⁻" : digits[c - '0'];
    return text;
}

/// "0.02" where the whole axis reads well so, else "2·10⁻⁷".
std::string decadeLabel(int digit, int decade, bool plain)
{
    if (plain) return fixedText(digit * std::pow(10.0, decade), std::max(0, -decade));
    return (digit == 1 ? "10" : std::to_string(digit) + "·10") + superscript(decade);
}

} // namespace

double niceStep(double span, int count)
{
    const double raw = span / std::max(1, count);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double digit = raw / power;
    return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

Ticks labelled(std::vector<double> values, double step)
{
    Ticks ticks;
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    if (largest > 0 && (largest >= 1e5 || largest < 1e-2))
        ticks.exponent = 3 * int(std::floor(std::log10(largest * 1.000001) / 3));
    const double unit = std::pow(10.0, ticks.exponent);
    int decimals = 0;
    for (double scaled = step / unit; decimals < 12; ++decimals, scaled *= 10)
        if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled) break;
    for (const double value : values) ticks.labels.push_back(fixedText(value / unit, decimals));
    ticks.values = std::move(values);
    return ticks;
}

Ticks linearTicks(double lower, double upper, int count)
{
    const double step = niceStep(upper - lower, count);
    std::vector<double> values;
    const double tolerance = 1e-9 * (upper - lower) / step;
    for (double k = std::ceil(lower / step - tolerance); k <= upper / step + tolerance; ++k) {
        values.push_back(k * step);
        if (values.size() > 100) break; // step lost in the rounding of huge bounds
    }
    return labelled(std::move(values), step);
}

Ticks decadeTicks(double lower, double upper)
{
    Ticks ticks;
    const int first = int(std::floor(std::log10(lower))), last = int(std::ceil(std::log10(upper)));
    const int decadesInside =
        int(std::floor(std::log10(upper) + 1e-9) - std::ceil(std::log10(lower) - 1e-9)) + 1;
    const int stride = std::max(1, (last - first) / 8);
    const bool plain = lower >= 9e-4 && upper <= 2e4;
    for (int decade = first; decade <= last; ++decade) {
        for (int digit = 1; digit < 10; ++digit) {
            const double value = digit * std::pow(10.0, decade);
            if (value < lower * (1 - 1e-9) || value > upper * (1 + 1e-9)) continue;
            const bool between = decadesInside < 3 && (digit == 2 || digit == 5);
            if (between || (digit == 1 && decade % stride == 0)) {
                ticks.values.push_back(value);
                ticks.labels.push_back(decadeLabel(digit, decade, plain));
            } else if (stride == 1) {
                ticks.minor.push_back(value);
            }
        }
    }
    // Within a fraction of a decade even steps say more.
    return ticks.values.size() < 2 ? linearTicks(lower, upper, 5) : ticks;
}

std::string timesPowerOfTen(int exponent)
{
    return exponent == 0 ? "" : "×10" + superscript(exponent);
}

} // namespace fpm
