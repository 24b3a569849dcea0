#pragma once

#include "parallel/Math.h"

namespace fpm {

/// exp(-x) for x >= 0 to 3e-14 (absolute) from products and sums alone, so that its bits are the
/// same everywhere: Taylor's series at x / 256, then squared eight times.
FPM_KERNEL double decayingExponential(double x)
{
    if (!(x < 40)) return 0;
    const double y = x / 256;
    double sum = 1;
    for (int k = 12; k > 0; --k) sum = fusedMultiplyAdd(-y / double(k), sum, 1.0);
    for (int k = 0; k < 8; ++k) sum *= sum;
    return sum;
}

} // namespace fpm
