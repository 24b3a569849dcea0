#include "solver/nodes/NodeSolver.h"

#include "base/Hash.h"
#include "kernels/particle/NodeSample.h"

namespace fpm {

void NodeSolver::advanceClock()
{
    backend_.timed(seconds_, [this] {
        if (setUp_.relaxation.tolerance > 0) launches_.relax();
        launches_.updateClock();
    });
}

void NodeSolver::move()
{
    backend_.timed(seconds_, [this] { launches_.moveNodes(); });
}

void NodeSolver::updateLoads()
{
    if (setUp_.pressureFaceCondition.empty()) return;
    backend_.timed(seconds_, [this] { launches_.pressures(); });
}

void NodeSolver::endPressures(NodeSetUp& setUp, const std::vector<bool>& deleted)
{
    for (std::size_t face = 0; face < setUp.pressureFaceElement.size(); ++face)
        if (deleted[std::size_t(setUp.pressureFaceElement[face])])
            setUp.pressureFaceCondition[face] = -1;
    fields_.pressureFaceCondition.fromHost(setUp.pressureFaceCondition);
}

NodeValues NodeSolver::values(const std::vector<Index>& nodes)
{
    const std::size_t count = nodes.empty() ? std::size_t(setUp_.count) : nodes.size();
    FieldSet reading("reading", fields_.memory(), fields_.numbers());
    const Field<Index> list(reading, {"list", Location::table, Role::scratch}, nodes);
    Field<double> out(reading, {"values", Location::table, Role::scratch}, sampleValues * count);
    launches_.sample(list.data(), Index(count), out.data());
    backend_.synchronize();
    return {out.toHost(), count};
}

std::uint64_t NodeSolver::checksum(std::uint64_t hash) const
{
    for (const double x : fields_.position.toDoubles()) hash = hashed(hash, x);
    const std::vector<std::byte> velocity = fields_.velocity.image();
    return hashedBytes(hash, velocity.data(), velocity.size());
}

} // namespace fpm
