#include "solver/StepBytes.h"

#include "parallel/Precision.h"

namespace fpm {

namespace {

template <class Numbers>
std::size_t bytesFor(const SolverData& data)
{
    constexpr std::size_t position = 3 * sizeof(typename Numbers::Position),
                          motion = 3 * sizeof(typename Numbers::Motion),
                          work = sizeof(typename Numbers::Work),
                          sum = sizeof(typename Numbers::Sum);
    std::size_t bytes = 0;
    for (const KernelGroup& group : data.groups)
        for (const Index number : group.patches) {
            const PatchHeader& patch = data.patches[std::size_t(number)];
            const StateLayout& layout = data.layouts[std::size_t(patch.material)];
            const std::size_t elements = std::size_t(patch.elementCount),
                              slots = std::size_t(patch.nodeCount);
            bytes +=
                elements
                * (2 * 8 * sizeof(std::uint16_t) + work
                   + 2 * (std::size_t(layout.size()) * work + std::size_t(layout.sums()) * sum));
            // A patch reads its nodes and writes its sums; the node reads them again.
            bytes += slots * (position + motion + 2 * 3 * work + 3 * sizeof(Index));
        }
    const std::size_t nodes = std::size_t(data.nodeCount);
    return bytes
           + nodes
                 * (2 * position + 2 * motion + sizeof(typename Numbers::Motion) + sizeof(Index)
                    + 1);
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
