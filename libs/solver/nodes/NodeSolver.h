#pragma once

#include "solver/backend/Launches.h"
#include "solver/nodes/NodeFields.h"

namespace fpm {

/// State of chosen nodes: [value][node], values as in NodeSample.
struct NodeValues {
    std::vector<double> values;
    std::size_t count = 0;
    Point at(int quantity, std::size_t i) const
    {
        const std::size_t q = std::size_t(3 * quantity);
        return {values[q * count + i], values[(q + 1) * count + i], values[(q + 2) * count + i]};
    }
};

/// The particle solver of the paper: clock, motion of the nodes, loads.
class NodeSolver
{
public:
    NodeSolver(const NodeSetUp& setUp,
               NodeFields& fields,
               MotionLaunches& launches,
               Backend& backend)
        : setUp_(setUp),
          fields_(fields),
          launches_(launches),
          backend_(backend)
    {
    }

    /// Damping of dynamic relaxation, where the case asks for it, then the next step and its time.
    void advanceClock();
    /// Judges the state that was reached, where no step follows.
    void judge() { launches_.updateClock(); }
    /// Velocities and positions of the next time.
    void move();
    /// Pressures at the present positions.
    void updateLoads();
    /// Sides of deleted elements bear no pressure from the next step on.
    void endPressures(NodeSetUp& setUp, const std::vector<bool>& deleted);

    const NodeSetUp& setUp() const { return setUp_; }
    /// Of all nodes where `nodes` is empty.
    NodeValues values(const std::vector<Index>& nodes);
    /// FNV-1a over positions and velocities, continuing from `hash`.
    std::uint64_t checksum(std::uint64_t hash) const;
    double seconds() const { return seconds_; }

private:
    const NodeSetUp& setUp_;
    NodeFields& fields_;
    MotionLaunches& launches_;
    Backend& backend_;
    double seconds_ = 0;
};

} // namespace fpm
