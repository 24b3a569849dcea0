#pragma once

#include <cstddef>
#include <memory>

namespace fpm {

/// Kernels of contact forces and of what is read of them. Passes by their number among all.
class ContactLaunches
{
public:
    virtual ~ContactLaunches() = default;
    /// Forces of all passes at the present positions, and the bound of the next step from their
    /// springs.
    virtual void forces() = 0;
    /// Depth of each contactor inside the target, into PassFields::overlap.
    virtual void measureOverlaps(std::size_t pass) = 0;
    /// Nothing is forgiven, nothing counted.
    virtual void clearOverlaps(std::size_t pass) = 0;
    virtual void clearCounts(std::size_t pass) = 0;
    /// Sums over the contactors, into PassFields::sums.
    virtual void sums(std::size_t pass) = 0;
    /// Into PassFields::status, see StatusSums.
    virtual void status(std::size_t pass) = 0;
    /// Distance of each contactor, into PassFields::gap.
    virtual void gaps(std::size_t pass) = 0;
};

template <class Executor>
struct LaunchContext;
/// Instantiated in a unit of its own for each executor and precision.
template <class Numbers, class Executor>
std::unique_ptr<ContactLaunches> makeContactLaunches(const LaunchContext<Executor>& context);

/// Kernels of a pass of sharp edges; likewise.
enum class EdgeLaunch { forces, measureOverlaps, status };
template <class Numbers, class Executor>
void launchEdges(const LaunchContext<Executor>& on, std::size_t pass, EdgeLaunch what);

/// Forces of contactors on faces in one pass; likewise, since these are the largest kernels.
template <class Numbers, bool friction, class Executor>
void launchFaceForces(const LaunchContext<Executor>& on, std::size_t pass);

} // namespace fpm
