#pragma once

#include "kernels/particle/NodePass.h"

namespace fpm {

/// Position, velocity, acceleration, force, contact force; three values each.
inline constexpr int sampleValues = 15;

/// Reads the state of chosen nodes at the time of the positions: v^n = v^(n-1/2) + dt/2 a^n. The
/// force is the sum of element, contact and external forces (0 = equilibrium).
template <class Precision>
struct NodeSample {
    NodePass<Precision> pass;
    const Index* list; ///< nodes, or null for all
    double* out;       ///< [sampleValues][count]
    Index count;

    FPM_KERNEL void operator()(Index i) const
    {
        const std::size_t node = std::size_t(list ? list[i] : i), planes = std::size_t(count);
        const auto internal = pass.internalForce(node);
        const auto contact = pass.contact(node);
        const auto load = pass.load(node, pass.clock->time);
        const double force[3] = {double(load.x) - double(internal.x) + double(contact.x),
                                 double(load.y) - double(internal.y) + double(contact.y),
                                 double(load.z) - double(internal.z) + double(contact.z)};
        const double touch[3] = {double(contact.x), double(contact.y), double(contact.z)};
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = c * pass.nodeStride + node;
            const double v = double(pass.velocity[at]);
            double a = force[c] * double(pass.inverseMass[node]) - double(pass.dampingRate()) * v;
            if (pass.imposed(node, c)) a = 0;
            out[std::size_t(c) * planes + std::size_t(i)] = double(pass.position[at]);
            out[std::size_t(3 + c) * planes + std::size_t(i)] = v + 0.5 * pass.clock->step * a;
            out[std::size_t(6 + c) * planes + std::size_t(i)] = a;
            out[std::size_t(9 + c) * planes + std::size_t(i)] = force[c];
            out[std::size_t(12 + c) * planes + std::size_t(i)] = touch[c];
        }
    }
};

/// Sums over a block of nodes: 1/2 m v^(n-1/2) . v^(n+1/2), the kinetic energy that belongs to the
/// internal energy at t^n (exact for constant step), and the half work F^n . dx^n / 2 of loads and
/// drives that the ledger has not booked yet at t^n.
template <class Precision>
struct KineticEnergy {
    NodePass<Precision> pass;
    double* blockEnergy; ///< [block][2]

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index block) const
    {
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + 2 * nodeBlock;
        const Index first = block * nodeBlock;
        const Index count = pass.nodeCount - first < nodeBlock ? pass.nodeCount - first : nodeBlock;
        team.forEach(count, [&](Index i) { book(std::size_t(first + i), values + i); });
        team.barrier();
        blockSums(team, 2, count, values, nodeBlock, partial);
        team.barrier();
        double* out = blockEnergy + 2 * block;
        team.forEach(2, [=](Index k) { out[k] = blockSumResult(partial, k); });
        team.barrier();
    }

private:
    FPM_KERNEL void book(std::size_t node, double* out) const
    {
        const auto internal = pass.internalForce(node);
        const auto contact = pass.contact(node);
        const auto load = pass.load(node, pass.clock->time);
        const double outer[3] = {double(load.x), double(load.y), double(load.z)};
        const double inner[3] = {double(contact.x) - double(internal.x),
                                 double(contact.y) - double(internal.y),
                                 double(contact.z) - double(internal.z)};
        const double inverse = double(pass.inverseMass[node]), dt = pass.clock->step;
        double kinetic = 0, closing = 0;
        for (int c = 0; c < 3; ++c) {
            const double v = double(pass.velocity[c * pass.nodeStride + node]);
            double next =
                leapFrogVelocity(v, outer[c] + inner[c], inverse, dt, double(pass.dampingRate()));
            double booked = outer[c];
            if (pass.imposed(node, c)) {
                next = v;
                booked = -inner[c]; // load and reaction together, at constant velocity
            }
            kinetic += v * next;
            closing += 0.5 * dt * v * booked;
        }
        out[0] = inverse > 0 ? 0.5 * kinetic / inverse : 0;
        out[nodeBlock] = closing;
    }
};

} // namespace fpm
