#pragma once

#include <memory>

namespace fpm {

/// Kernels of the elements.
class ElementLaunches
{
public:
    virtual ~ElementLaunches() = default;
    /// Internal forces, energies and bounds of the step of all patches, for a group each.
    virtual void forces() = 0;
};

template <class Executor>
struct LaunchContext;
/// Instantiated in a unit of its own for each executor and precision.
template <class Numbers, class Executor>
std::unique_ptr<ElementLaunches> makeElementLaunches(const LaunchContext<Executor>& context);

} // namespace fpm
