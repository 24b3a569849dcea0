#pragma once

#include "base/Types.h"
#include "parallel/Kernel.h"

namespace fpm {

/// *target += value, and what was there. Integer sums have no order, so the result is the same on
/// every backend.
FPM_KERNEL std::int64_t atomicAdd64(std::int64_t* target, std::int64_t value)
{
#ifdef __CUDA_ARCH__
    return std::int64_t(atomicAdd(reinterpret_cast<unsigned long long*>(target),
                                  static_cast<unsigned long long>(value)));
#else
    return __atomic_fetch_add(target, value, __ATOMIC_RELAXED);
#endif
}

/// The same; `alone`: no other thread adds meanwhile, so that the processor need not lock.
FPM_KERNEL void add64(std::int64_t* target, std::int64_t value, [[maybe_unused]] bool alone)
{
#ifndef __CUDA_ARCH__
    if (alone) {
        *target += value;
        return;
    }
#endif
    atomicAdd64(target, value);
}

/// *source, which other threads may exchange meanwhile.
FPM_KERNEL Index atomicLoadIndex(const Index* source)
{
#ifdef __CUDA_ARCH__
    return *static_cast<const volatile Index*>(source); // ld.volatile is a relaxed load
#else
    return __atomic_load_n(source, __ATOMIC_RELAXED);
#endif
}

/// Puts `value` into *target and returns what was there.
FPM_KERNEL Index atomicExchangeIndex(Index* target, Index value)
{
#ifdef __CUDA_ARCH__
    return atomicExch(target, value);
#else
    return __atomic_exchange_n(target, value, __ATOMIC_RELAXED);
#endif
}

} // namespace fpm
