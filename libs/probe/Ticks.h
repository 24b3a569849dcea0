#pragma once

#include <string>
#include <vector>

namespace fpm {

/// Marks on an axis. Labels are the values divided by 10^exponent, all with the same decimals.
struct Ticks {
    std::vector<double> values;
    std::vector<std::string> labels;
    std::vector<double> minor; ///< unlabelled grid lines of a logarithmic axis
    int exponent = 0;          ///< a multiple of 3; 0 where plain numbers read well
};

/// 1, 2 or 5 times a power of ten, such that about `count` steps make up `span` (> 0).
double niceStep(double span, int count);
/// Ticks at whole multiples of niceStep within [lower, upper].
Ticks linearTicks(double lower, double upper, int count);
/// Ticks at the powers of ten within [lower, upper] (both > 0), with 2 and 5 between them where
/// there would be fewer than three.
Ticks decadeTicks(double lower, double upper);
/// Labels for given values `step` apart: common decimals, common exponent.
Ticks labelled(std::vector<double> values, double step);
/// "×10⁻⁶"; empty for 0.
std::string timesPowerOfTen(int exponent);

} // namespace fpm
