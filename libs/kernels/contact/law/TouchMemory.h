#pragma once

#include "base/Types.h"
#include "parallel/Kernel.h"

namespace fpm {

/// Energy that the penalty spring of a contactor takes and makes because it closes and opens within
/// steps, and its return. In the step in which it closes, from gap g' to gap -d, the mean force
/// works over d + g' and not over d: the spring takes k d g' / 2 more than it stores. In the step
/// in which it opens it gives as much too much. Over one touch the two differ by any sign, up to
/// (omega dt)^2 / 4 of the energy of the touch, and their mean is above 0. `surplus` adds up what
/// the spring has taken beyond what it stores and given back; the first closed step of the next
/// touch returns it by a force `extra` beside k d, which works over two steps. So however often a
/// contactor touches, it makes no more than a few touches do. The first touch is that of the bare
/// spring, and so is a spring that stays closed. Arrays over contactors; null: not kept.
template <class Work>
struct TouchMemory {
    Work* gap;       ///< of a closed spring in the last step; 0: it was open
    Work* extra;     ///< force of the last step beside that of the spring
    double* surplus; ///< energy taken, running sum

    /// Bounds of `extra` by the force of the spring: never tensile, and the stiffness of the step
    /// stays below the margin of a safety of 0.9.
    static constexpr double least = -1, most = 0.2;

    FPM_KERNEL bool isKept() const { return gap != nullptr; }
    FPM_KERNEL bool wasOpen(Index i) const { return isKept() && !(gap[i] < 0); }

    /// Force beside k |g| of a closed spring at gap g < 0 which changed by `change` in this step;
    /// `change` is read where the spring was open.
    FPM_KERNEL Work press(Index i, Work stiffness, Work g, Work change) const
    {
        if (!isKept()) return Work(0);
        const bool closes = !(gap[i] < 0);
        const Work before = closes ? g - change : gap[i], last = extra[i];
        gap[i] = g;
        Work now = 0;
        if (closes && before > 0) {
            now = Work(returning(surplus[i], double(-stiffness * g), double(before - g)));
            surplus[i] += 0.5 * double(-stiffness * g) * double(before);
        }
        if (now != last) book(i, last, now, g - before);
        return now;
    }
    /// The spring opens at gap g >= 0.
    FPM_KERNEL void open(Index i, Work stiffness, Work g) const
    {
        if (!isKept() || !(gap[i] < 0)) return;
        surplus[i] += 0.5 * double(stiffness * gap[i]) * double(g);
        if (extra[i] != 0) book(i, extra[i], Work(0), g - gap[i]);
        gap[i] = 0;
    }
    /// The contactor lost its face while the spring was closed: what it held is not its own work.
    FPM_KERNEL void lose(Index i) const
    {
        if (isKept() && gap[i] < 0) gap[i] = extra[i] = 0;
    }

    /// Another slot goes on with the same touch.
    FPM_KERNEL void handOver(Index from, Index to) const
    {
        if (!isKept()) return;
        gap[to] = gap[from];
        extra[to] = extra[from];
        surplus[to] += surplus[from];
        gap[from] = extra[from] = 0;
        surplus[from] = 0;
    }

private:
    /// Force that takes -`owed` over a step of length `way` before and one after it.
    FPM_KERNEL static double returning(double owed, double elastic, double way)
    {
        const double force = -owed / way;
        if (!(force > least * elastic)) return least * elastic;
        return force < most * elastic ? force : most * elastic;
    }
    /// Work of the mean of two successive extra forces.
    FPM_KERNEL void book(Index i, Work last, Work now, Work change) const
    {
        surplus[i] -= 0.5 * double(last + now) * double(change);
        extra[i] = now;
    }
};

} // namespace fpm
