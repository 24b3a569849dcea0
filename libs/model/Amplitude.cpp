#include "model/Model.h"

#include <algorithm>

namespace fpm {

double Amplitude::operator()(double time) const
{
    if (kind == Kind::constant) return 1.0;
    if (time <= rows.front()[0]) return rows.front()[1];
    if (time >= rows.back()[0]) return rows.back()[1];

    const auto next = std::upper_bound(rows.begin(), rows.end(), time,
                                       [](double t, const auto& row) { return t < row[0]; });
    const auto& [start, from] = *(next - 1);
    const auto& [end, to] = *next;
    const double tau = (time - start) / (end - start);
    const double share =
        kind == Kind::smooth ? tau * tau * tau * (10 - 15 * tau + 6 * tau * tau) : tau;
    return from + (to - from) * share;
}

} // namespace fpm
