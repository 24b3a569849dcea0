#pragma once

#include <array>
#include <optional>
#include <vector>

namespace fpm {

/// A history: y over ascending t.
struct Curve {
    std::vector<double> t, y;
};

/// Linear between the points; the end values hold outside. Not a number for an empty curve.
double valueAt(const Curve& curve, double t);

enum class Measure { l2, peak, peakTime, final };

/// How far a curve is from its reference, over the times both have:
/// root of the integral of the squared difference over that of the squared reference; peak (the
/// largest magnitude of the reference, and the largest value of that sign beside it) and last
/// value, both by the reference's peak; time of the peak, by the time they have in common. Not a
/// number where the reference is nothing but zero.
struct CurveErrors {
    double l2, peak, peakTime, final;
    double of(Measure measure) const;
};
CurveErrors errorsOf(const Curve& curve, const Curve& reference);

/// Of shares (the forces of a row of nodes) over their places what they are per length: shares of
/// equal place added, over the half distances to the neighbours. Ascending places; fewer than two
/// have none: an empty curve.
Curve perLength(const Curve& shares);

/// Running mean over `width` of t, the straight lines between the points integrated; less at the
/// ends, where there is no more.
Curve averaged(const Curve& curve, double width);

/// Root mean square of a - b over the times both have, at the points of b.
double distance(const Curve& a, const Curve& b);

/// Order p of a quantity with error C h^p from the differences of three results, at steps
/// h[0] > h[1] > h[2]: (h0^p - h1^p) / (h1^p - h2^p) = first / second. None where no p between 0.1
/// and 10 fits.
std::optional<double>
observedOrder(const std::array<double, 3>& h, double firstDifference, double secondDifference);

/// Richardson's estimate of the curve at step 0 from two steps, at the points of the finer one.
Curve extrapolated(
    const Curve& coarse, const Curve& fine, double hCoarse, double hFine, double order);

} // namespace fpm
