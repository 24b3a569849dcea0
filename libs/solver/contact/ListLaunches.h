#pragma once

#include "base/Types.h"

#include <cstddef>
#include <memory>

namespace fpm {

/// Kernels of contact lists: the list check, and the search that rebuilds them.
class ListLaunches
{
public:
    virtual ~ListLaunches() = default;
    /// Checks whether all lists stay valid for `steps` and rebuilds those of the blocks that do
    /// not; for whole passes the clock waits.
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
