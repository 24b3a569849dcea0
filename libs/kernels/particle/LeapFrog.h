#pragma once

#include "parallel/Kernel.h"

namespace fpm {

/// Central differences, eq. (3) of the paper, as a leapfrog: v^(n+1/2) of one component is [(1 - xi
/// h/2) v^(n-1/2) + h F^n / m] / (1 + xi h/2), h the mean of the two steps. With constant step and
/// x^(n+1) = x^n + dt v^(n+1/2) this equals d^(n+1) = c1 dt^2/m F + 2 c1 d^n - c2 d^(n-1) without
/// its loss of digits.
template <class Real>
FPM_KERNEL Real leapFrogVelocity(Real velocity, Real force, Real inverseMass, Real h, Real damping)
{
    const Real half = Real(0.5) * damping * h;
    // Without damping the quotient is exact; the branch is the same for every node.
    const Real next = (Real(1) - half) * velocity + h * (force * inverseMass);
    return damping > 0 ? next / (Real(1) + half) : next;
}

} // namespace fpm
