#include "run/StepBytes.h"

#include "parallel/Precision.h"

namespace fpm {

namespace {

template <class Numbers>
std::size_t bytesFor(const SolverData& data)
{
    constexpr std::size_t position = 3 * sizeof(typename Numbers::Position),
                          motion = 3 * sizeof(typename Numbers::Motion),
                          work = sizeof(typename Numbers::Work),
                          mass = sizeof(typename Numbers::Motion),
                          sum = sizeof(typename Numbers::Sum);
    std::size_t bytes = 0;
    for (const KernelGroup& group : data.groups)
        for (const Index number : group.patches) {
            const PatchHeader& patch = data.patches[std::size_t(number)];
            const StateLayout& layout = data.layouts[std::size_t(patch.material)];
            const std::size_t elements = std::size_t(patch.elementCount),
                              slots = std::size_t(patch.nodeCount),
                              own = std::size_t(patch.interiorCount);
            bytes +=
                elements
                * (work
                   + 2 * (std::size_t(layout.size()) * work + std::size_t(layout.sums()) * sum));
            bytes += slots * (position + motion);
            // Sums at nodes of this patch alone are kept, the others' are partial sums.
            bytes += slots * 2 * 3 * work + (slots - own) * 2 * sizeof(Index);
        }
    // Patches of one shape share their tables.
    bytes += sizeof(std::uint16_t)
             * (data.corners.size() + data.cornerStarts.size() + data.slotCorners.size());
    const std::size_t nodes = std::size_t(data.nodeCount),
                      listed = data.sharesNodes ? data.listedNodes.size() : nodes;
    return bytes + nodes * (position + motion + mass + 1)      // moved, by whomever
           + listed * (position + motion + 2 * sizeof(Index)); // read for that alone
}

} // namespace

std::size_t bytesOfStep(const SolverData& data, Precision precision)
{
    switch (precision) {
    case Precision::single:
        return bytesFor<SinglePrecision>(data);
    case Precision::mixed:
        return bytesFor<MixedPrecision>(data);
    case Precision::double_:
        break;
    }
    return bytesFor<DoublePrecision>(data);
}

} // namespace fpm
