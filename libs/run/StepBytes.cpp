#include "run/StepBytes.h"

#include "parallel/Precision.h"

namespace fpm {

namespace {

template <class Numbers>
std::size_t bytesFor(const Solver& solver)
{
    constexpr std::size_t position = 3 * sizeof(typename Numbers::Position),
                          motion = 3 * sizeof(typename Numbers::Motion),
                          work = sizeof(typename Numbers::Work),
                          mass = sizeof(typename Numbers::Motion),
                          sum = sizeof(typename Numbers::Sum);
    std::size_t bytes = 0;
    for (const KernelGroup& group : solver.elements().setUp().groups)
        for (const Index number : group.patches) {
            const PatchHeader& patch = solver.elements().setUp().patches[std::size_t(number)];
            const StateLayout& layout =
                solver.elements().setUp().layouts[std::size_t(patch.material)];
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
    bytes +=
        sizeof(std::uint16_t)
        * (solver.elements().setUp().corners.size() + solver.elements().setUp().cornerStarts.size()
           + solver.elements().setUp().slotCorners.size());
    const std::size_t nodes = std::size_t(solver.nodes().setUp().count),
                      listed = solver.nodes().setUp().movedByPatches
                                   ? solver.nodes().setUp().listed.size()
                                   : nodes;
    return bytes + nodes * (position + motion + mass + 1)      // moved, by whomever
           + listed * (position + motion + 2 * sizeof(Index)); // read for that alone
}

} // namespace

std::size_t bytesOfStep(const Solver& solver, Precision precision)
{
    switch (precision) {
    case Precision::single:
        return bytesFor<SinglePrecision>(solver);
    case Precision::mixed:
        return bytesFor<MixedPrecision>(solver);
    case Precision::double_:
        break;
    }
    return bytesFor<DoublePrecision>(solver);
}

} // namespace fpm
