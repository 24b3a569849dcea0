#include "study/Curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpm {

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

/// The times two curves have in common.
struct Window {
    double begin, end;
    bool holds(double t) const { return t >= begin && t <= end; }
};

Window common(const Curve& a, const Curve& b)
{
    if (a.t.empty() || b.t.empty()) return {1, 0};
    // A last time may differ by rounding of the step.
    const double end = std::min(a.t.back(), b.t.back());
    return {std::max(a.t.front(), b.t.front()), end + 1e-9 * std::abs(end)};
}

/// Integral of f over the points of `curve` in the window, by trapezoids.
template <class Function>
double integral(const Curve& curve, const Window& window, const Function& f)
{
    double sum = 0, lastTime = 0, lastValue = 0;
    bool any = false;
    for (std::size_t i = 0; i < curve.t.size(); ++i) {
        if (!window.holds(curve.t[i])) continue;
        const double value = f(i);
        if (any) sum += (curve.t[i] - lastTime) * (value + lastValue) / 2;
        lastTime = curve.t[i], lastValue = value;
        any = true;
    }
    return sum;
}

struct Peak {
    double t = noNumber, y = noNumber;
};

/// The largest value of `sign` y.
Peak peakOf(const Curve& curve, const Window& window, double sign)
{
    Peak peak;
    for (std::size_t i = 0; i < curve.t.size(); ++i)
        if (window.holds(curve.t[i]) && !(sign * curve.y[i] <= sign * peak.y))
            peak = {curve.t[i], curve.y[i]};
    return peak;
}

std::ptrdiff_t countIn(const Curve& curve, const Window& window)
{
    return std::count_if(curve.t.begin(), curve.t.end(), [&](double t) { return window.holds(t); });
}

double squaredDifference(const Curve& a, const Curve& b, const Window& window)
{
    return integral(b, window, [&](std::size_t i) {
        const double difference = valueAt(a, b.t[i]) - b.y[i];
        return difference * difference;
    });
}

} // namespace

double valueAt(const Curve& curve, double t)
{
    if (curve.t.empty()) return noNumber;
    if (t <= curve.t.front()) return curve.y.front();
    if (t >= curve.t.back()) return curve.y.back();
    const auto above = std::upper_bound(curve.t.begin(), curve.t.end(), t);
    const auto i = std::size_t(above - curve.t.begin());
    const double share = (t - curve.t[i - 1]) / (curve.t[i] - curve.t[i - 1]);
    return curve.y[i - 1] + share * (curve.y[i] - curve.y[i - 1]);
}

double CurveErrors::of(Measure measure) const
{
    return measure == Measure::l2         ? l2
           : measure == Measure::peak     ? peak
           : measure == Measure::peakTime ? peakTime
                                          : final;
}

CurveErrors errorsOf(const Curve& curve, const Curve& reference)
{
    const Window window = common(curve, reference);
    // At the points of the coarser curve, so that it is the finer one that is interpolated.
    const bool isCoarser = countIn(curve, window) < countIn(reference, window);
    const Curve &points = isCoarser ? curve : reference, &other = isCoarser ? reference : curve;
    const double norm = integral(points, window, [&](std::size_t i) {
        const double exact = valueAt(reference, points.t[i]);
        return exact * exact;
    });
    if (!(norm > 0)) return {noNumber, noNumber, noNumber, noNumber};
    const Peak above = peakOf(reference, window, 1), below = peakOf(reference, window, -1);
    const double sign = above.y >= -below.y ? 1 : -1;
    const Peak exact = sign > 0 ? above : below, ours = peakOf(curve, window, sign);
    const double scale = std::abs(exact.y), last = window.end;
    return {std::sqrt(squaredDifference(other, points, window) / norm),
            std::abs(ours.y - exact.y) / scale,
            std::abs(ours.t - exact.t) / (window.end - window.begin),
            std::abs(valueAt(curve, last) - valueAt(reference, last)) / scale};
}

Curve perLength(const Curve& shares)
{
    Curve sums;
    for (std::size_t i = 0; i < shares.t.size(); ++i) {
        if (sums.t.empty() || shares.t[i] != sums.t.back()) {
            sums.t.push_back(shares.t[i]);
            sums.y.push_back(0);
        }
        sums.y.back() += shares.y[i];
    }
    const std::size_t count = sums.t.size();
    if (count < 2) return {};
    for (std::size_t i = 0; i < count; ++i)
        sums.y[i] /=
            (sums.t[std::min(i + 1, count - 1)] - sums.t[i - std::min<std::size_t>(i, 1)]) / 2;
    return sums;
}

Curve averaged(const Curve& curve, double width)
{
    if (curve.t.size() < 2) return curve;
    // Integral up to every point, and to any place between them.
    std::vector<double> upTo{0};
    for (std::size_t i = 1; i < curve.t.size(); ++i)
        upTo.push_back(upTo.back()
                       + (curve.y[i] + curve.y[i - 1]) / 2 * (curve.t[i] - curve.t[i - 1]));
    const auto integralTo = [&](double t) {
        const auto above = std::upper_bound(curve.t.begin() + 1, curve.t.end() - 1, t);
        const auto i = std::size_t(above - curve.t.begin()) - 1;
        return upTo[i] + (curve.y[i] + valueAt(curve, t)) / 2 * (t - curve.t[i]);
    };
    Curve mean{curve.t, {}};
    for (const double t : curve.t) {
        const double from = std::max(t - width / 2, curve.t.front());
        const double to = std::min(t + width / 2, curve.t.back());
        mean.y.push_back(to > from ? (integralTo(to) - integralTo(from)) / (to - from)
                                   : valueAt(curve, t));
    }
    return mean;
}

double distance(const Curve& a, const Curve& b)
{
    const Window window = common(a, b);
    const double time = integral(b, window, [](std::size_t) { return 1.0; });
    return std::sqrt(squaredDifference(a, b, window) / time);
}

std::optional<double>
observedOrder(const std::array<double, 3>& h, double firstDifference, double secondDifference)
{
    const double wanted = firstDifference / secondDifference;
    const auto ratio = [&](double p) {
        return (std::pow(h[0], p) - std::pow(h[1], p)) / (std::pow(h[1], p) - std::pow(h[2], p));
    };
    double low = 0.1, high = 10; // the ratio grows with p
    if (!(wanted > ratio(low) && wanted < ratio(high))) return std::nullopt;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (ratio(middle) < wanted ? low : high) = middle;
    }
    return (low + high) / 2;
}

Curve extrapolated(
    const Curve& coarse, const Curve& fine, double hCoarse, double hFine, double order)
{
    // Steps by their ratio: 1e-200^2 would be nothing.
    const double share = 1 / (std::pow(hCoarse / hFine, order) - 1);
    Curve result = fine;
    for (std::size_t i = 0; i < fine.t.size(); ++i)
        result.y[i] += share * (fine.y[i] - valueAt(coarse, fine.t[i]));
    return result;
}

} // namespace fpm
