#pragma once

#include "base/Types.h"

#include <cstddef>
#include <memory>

namespace fpm {

/// Kernels of contact lists: when they have to be made anew, and the search that makes them.
class ListLaunches
{
public:
    virtual ~ListLaunches() = default;
    /// Whether all lists last for `steps`; those that do not are made anew, but for whole passes,
    /// for which the clock waits.
    virtual void check(Index steps) = 0;
    /// Searches in a whole pass; `atSteps`: only where a step follows.
    virtual void search(std::size_t pass, bool atSteps) = 0;
    /// Positions from which displacements count, now.
    virtual void storeReferencePositions() = 0;
};

template <class Executor>
struct LaunchContext;
/// Instantiated in a unit of its own for each executor and precision.
template <class Numbers, class Executor>
std::unique_ptr<ListLaunches> makeListLaunches(const LaunchContext<Executor>& context);

} // namespace fpm
