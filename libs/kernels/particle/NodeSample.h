#pragma once

#include "kernels/particle/RigidBody.h"

namespace fpm {

/// Position, velocity, acceleration, force, contact force; three values each.
inline constexpr int sampleValues = 15;

/// Reads the state of chosen nodes at the time of the positions: v^n = v^(n-1/2) + dt/2 a^n. The
/// force is the sum of element, contact and external forces (0 = equilibrium).
template <class Numbers>
struct NodeSample {
    NodeMotion<Numbers> nodeMotion;
    const Index* list; ///< nodes, or null for all
    double* out;       ///< [sampleValues][count]
    Index count;
    const Index* bodyOf; ///< null without rigid bodies
    const RigidBody* bodies;

    FPM_KERNEL void operator()(Index i) const
    {
        const std::size_t node = std::size_t(list ? list[i] : i), planes = std::size_t(count);
        const auto internal = nodeMotion.internalForce(node);
        const auto contact = nodeMotion.contact(node) + nodeMotion.reaction(node);
        const auto load = nodeMotion.load(node, nodeMotion.clock->time);
        const double force[3] = {double(load.x) - double(internal.x) + double(contact.x),
                                 double(load.y) - double(internal.y) + double(contact.y),
                                 double(load.z) - double(internal.z) + double(contact.z)};
        const double touch[3] = {double(contact.x), double(contact.y), double(contact.z)};
        double half[3], a[3];
        for (int c = 0; c < 3; ++c) {
            half[c] = double(nodeMotion.velocity[c * nodeMotion.nodeStride + node]);
            a[c] = force[c] * double(nodeMotion.inverseMass[node])
                   - double(nodeMotion.dampingRate()) * half[c];
        }
        nodeMotion.removeImposed(node, a);
        for (int c = 0; c < 3; ++c) half[c] += 0.5 * nodeMotion.clock->step * a[c];
        if (bodyOf && bodyOf[node] >= 0) ride(node, half, a);
        for (int c = 0; c < 3; ++c) {
            out[std::size_t(c) * planes + std::size_t(i)] =
                double(nodeMotion.position[c * nodeMotion.nodeStride + node]);
            out[std::size_t(3 + c) * planes + std::size_t(i)] = half[c];
            out[std::size_t(6 + c) * planes + std::size_t(i)] = a[c];
            out[std::size_t(9 + c) * planes + std::size_t(i)] = force[c];
            out[std::size_t(12 + c) * planes + std::size_t(i)] = touch[c];
        }
    }

private:
    /// Velocity and acceleration of a node of a rigid body.
    FPM_KERNEL void ride(std::size_t node, double (&v)[3], double (&a)[3]) const
    {
        const RigidBody& body = bodies[bodyOf[node]];
        Vec3<double> velocity, momentum;
        kicked(body, 0.5 * nodeMotion.clock->step, double(nodeMotion.dampingRate()), velocity,
               momentum);
        const BodyAcceleration rate =
            accelerationOf(body, velocity, momentum, double(nodeMotion.dampingRate()));
        const Vec3<double> spin = spinOf(body, momentum),
                           arm = nodeMotion.place(node) - body.centre, turning = cross(spin, arm);
        const Vec3<double> here = velocity + turning,
                           change = rate.centre + cross(rate.turn, arm) + cross(spin, turning);
        const double to[6] = {here.x, here.y, here.z, change.x, change.y, change.z};
        for (int c = 0; c < 3; ++c) {
            v[c] = to[c];
            a[c] = to[3 + c];
        }
    }
};

/// Sums over a block of nodes: 1/2 m v^(n-1/2) . v^(n+1/2), the kinetic energy that matches the
/// internal energy at t^n (exact for constant step; without the damping of t^n, whose work the next
/// step books as a whole), and the half work F^n . dx^n / 2 of loads and
/// prescribed motion that the energy balance does not yet contain at t^n.
template <class Numbers>
struct KineticEnergy {
    NodeMotion<Numbers> nodeMotion;
    bool reactions;      ///< of analytic surfaces that are met exactly count too
    double* blockEnergy; ///< [block][2]

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index block) const
    {
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + 2 * nodeBlock;
        const Index first = block * nodeBlock;
        const Index count =
            nodeMotion.nodeCount - first < nodeBlock ? nodeMotion.nodeCount - first : nodeBlock;
        team.forEach(count, [&](Index i) { book(std::size_t(first + i), values + i); });
        team.barrier();
        blockSums(team, 2, count, values, nodeBlock, partial);
        team.barrier();
        double* out = blockEnergy + 2 * block;
        team.forEach(2, [=](Index k) { out[k] = blockSumResult(partial, k); });
    }

private:
    using Motion = typename Numbers::Motion;

    FPM_KERNEL void book(std::size_t node, double* out) const
    {
        out[0] = out[nodeBlock] = 0;
        if (nodeMotion.fixed[node] & bodyNode) return;
        const auto internal = nodeMotion.internalForce(node);
        auto contact = nodeMotion.contact(node);
        if (reactions) contact += nodeMotion.reaction(node);
        const auto load = nodeMotion.load(node, nodeMotion.clock->time);
        Vec3<Motion> outer = load, inner = contact - internal, old = nodeMotion.velocityOf(node);
        if (nodeMotion.toOwnAxes(node, old)) {
            nodeMotion.toOwnAxes(node, outer);
            nodeMotion.toOwnAxes(node, inner);
        }
        const double ex[3] = {double(outer.x), double(outer.y), double(outer.z)},
                     in[3] = {double(inner.x), double(inner.y), double(inner.z)},
                     v[3] = {double(old.x), double(old.y), double(old.z)};
        const double inverse = double(nodeMotion.inverseMass[node]), dt = nodeMotion.clock->step;
        double kinetic = 0, closing = 0;
        for (int c = 0; c < 3; ++c) {
            double a = (ex[c] + in[c]) * inverse;
            double booked = ex[c];
            if (nodeMotion.imposed(node, c)) {
                a = 0;
                booked = -in[c]; // load and reaction together, at constant velocity
            }
            kinetic += v[c] * (v[c] + dt * a);
            closing += 0.5 * dt * v[c] * booked;
        }
        out[0] = inverse > 0 ? 0.5 * kinetic / inverse : 0;
        out[nodeBlock] = closing;
    }
};

} // namespace fpm
