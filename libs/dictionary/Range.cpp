#include "base/Format.h"
#include "dictionary/Dictionary.h"

#include <cmath>
#include <limits>

namespace fpm {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

std::string Range::text() const
{
    const bool hasLower = std::isfinite(lower), hasUpper = std::isfinite(upper);
    if (hasLower && hasUpper && !lowerOpen && !upperOpen)
        return format("between {} and {}", lower, upper);

    std::string text;
    if (hasLower) text = format("{} {}", lowerOpen ? ">" : ">=", lower);
    if (hasLower && hasUpper) text += " and ";
    if (hasUpper) text += format("{} {}", upperOpen ? "<" : "<=", upper);
    return text;
}

bool Range::holds(double value) const
{
    const bool isAboveLower = lowerOpen ? value > lower : value >= lower;
    const bool isBelowUpper = upperOpen ? value < upper : value <= upper;
    return isAboveLower && isBelowUpper;
}

Range anyNumber()
{
    return {-infinity, infinity};
}

Range positive()
{
    return {0, infinity, true, false};
}

Range nonNegative()
{
    return {0, infinity};
}

Range between(double lower, double upper)
{
    return {lower, upper};
}

} // namespace fpm
