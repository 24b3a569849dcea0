#pragma once

#include <string>

namespace fpm {

/// A formula in t: numbers, t, pi, + - * / ^, brackets, and sin cos tan exp log sqrt abs min max,
/// and smooth(x), the step of smooth amplitudes: 0 for x <= 0, 1 for x >= 1.
/// Signs bind as in mathematics: -t^2 is -(t^2), 2^3^2 is 2^9.
class Expression
{
public:
    /// Throws std::invalid_argument with what is wrong and where.
    explicit Expression(std::string text);
    /// Not finite where the formula has no value.
    double operator()(double t) const;
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

} // namespace fpm
