#pragma once

#include "base/Types.h"
#include "kernels/particle/Turn.h"
#include "parallel/Kernel.h"

namespace fpm {

enum class ConditionKind : std::int32_t { displacement, velocity, rotation, load, pressure };

/// Prescribed motion or load of nodes on the device: a path or a force times amplitude(t).
struct Condition {
    ConditionKind kind;
    std::int32_t smooth; ///< rows are joined by tau^3 (10 - 15 tau + 6 tau^2) instead of linearly
    Index firstRow, rowCount;
    double value[3]; ///< load: force of weight 1; pressure: the pressure; rotation: degrees
};

/// Condition at one node. Prescribed motion: along `axis` of the node's axes, the path is first *
/// a(t) + second * b(t), see pathAt. Loads: axis -1, weight `first`.
struct ConditionUse {
    Index condition;
    std::int32_t axis;
    double first, second;
};

/// Factor of an amplitude table (rows of time, factor) at `time`; held outside the table.
FPM_KERNEL double amplitudeAt(const Condition& condition, const double* rows, double time)
{
    const double* row = rows + 2 * std::size_t(condition.firstRow);
    const Index last = condition.rowCount - 1;
    if (time <= row[0] || last == 0) return row[1];
    if (time >= row[2 * last]) return row[2 * last + 1];
    Index i = 1;
    while (time > row[2 * i]) ++i;
    const double tau = (time - row[2 * i - 2]) / (row[2 * i] - row[2 * i - 2]);
    const double s = condition.smooth ? tau * tau * tau * (10 + tau * (6 * tau - 15)) : tau;
    return row[2 * i - 1] + s * (row[2 * i + 1] - row[2 * i - 1]);
}

/// Prescribed displacement u(t) of a component at `time`, or that of a point rotated about an axis,
/// s sin(angle) + k (1 - cos(angle)), s and k the lever arm rotated once and twice by 90 degrees.
FPM_KERNEL double
pathAt(const Condition& condition, const ConditionUse& use, const double* rows, double time)
{
    const double factor = amplitudeAt(condition, rows, time);
    if (condition.kind != ConditionKind::rotation) return use.first * factor;
    const Turn turn = turnBy(condition.value[0] * factor);
    return use.first * turn.sine + use.second * turn.versine;
}

/// Prescribed velocity of a component over a step: follows a path exactly, or takes the velocity at
/// mid-step.
FPM_KERNEL double drivenVelocity(const Condition& condition,
                                 const ConditionUse& use,
                                 const double* rows,
                                 double end,
                                 double step)
{
    if (condition.kind == ConditionKind::velocity)
        return use.first * amplitudeAt(condition, rows, end - 0.5 * step);
    return (pathAt(condition, use, rows, end) - pathAt(condition, use, rows, end - step)) / step;
}

/// Integral of the factor from the first row to `time`.
FPM_KERNEL double
amplitudeIntegralFromFirstRow(const Condition& condition, const double* rows, double time)
{
    const double* row = rows + 2 * std::size_t(condition.firstRow);
    if (time <= row[0]) return (time - row[0]) * row[1];
    double sum = 0;
    for (Index i = 1; i < condition.rowCount; ++i) {
        const double start = row[2 * i - 2], from = row[2 * i - 1], rise = row[2 * i + 1] - from;
        const double length = row[2 * i] - start;
        const double tau = time < row[2 * i] ? (time - start) / length : 1;
        const double square = tau * tau;
        const double share =
            condition.smooth ? square * square * (2.5 + tau * (tau - 3)) : 0.5 * square;
        sum += length * (from * tau + rise * share);
        if (time < row[2 * i]) return sum;
    }
    const Index last = condition.rowCount - 1;
    return sum + (time - row[2 * last]) * row[2 * last + 1];
}

/// Prescribed displacement of a node set since time 0, in units of the condition's value.
FPM_KERNEL double travelAt(const Condition& condition, const double* rows, double time)
{
    if (condition.kind != ConditionKind::velocity) return amplitudeAt(condition, rows, time);
    return amplitudeIntegralFromFirstRow(condition, rows, time)
           - amplitudeIntegralFromFirstRow(condition, rows, 0);
}

} // namespace fpm
