#pragma once

// Part of ExplicitSolver.h: pressures and rigid bodies.

namespace fpm {

/// Pressures at the present positions, then the forces on the rigid bodies.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::launchPressures()
{
    if (!data_.pressureFaceCondition.empty())
        executor_.parallelFor(
            Index(data_.pressureFaceCondition.size()),
            PressureForces<Numbers>{state_.pressureFaceNode.data(),
                                    state_.pressureFaceCondition.data(), state_.conditions.data(),
                                    state_.amplitudeRows.data(), state_.position.data(),
                                    std::size_t(data_.nodeCount), state_.pressureForce.data(),
                                    data_.pressureFaceNode.size(), state_.clock.data()});
    if (data_.body.bodies.empty()) return;
    auto& body = state_.body;
    executor_.parallelBlocks(Index(data_.body.blocks.size()), bodyScratch(),
                             BodyForces<Numbers>{nodeMotion(), body.blocks.data(),
                                                 body.loaded.data(), body.inverseMass.data(),
                                                 body.bodies.data(), body.sums.data()});
    executor_.parallelBlocks(
        Index(data_.body.bodies.size()), BodySum::scratch(),
        BodySum{body.bodies.data(), body.blockStart.data(), body.sums.data(), body.useStart.data(),
                body.uses.data(), state_.conditions.data(), state_.amplitudeRows.data(),
                state_.contactLimit.data() + contactBlocks(), state_.clock.data()});
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::moveBodies()
{
    auto& body = state_.body;
    const Index nodes = Index(data_.body.nodes.size());
    executor_.parallelFor(Index(data_.body.bodies.size()),
                          BodyStep{body.bodies.data(), massDamping_, state_.clock.data()});
    executor_.parallelFor(nodes,
                          BodyMotion<Numbers>{body.nodes.data(), body.bodyOf.data(),
                                              body.arm.data(), nodes, body.bodies.data(),
                                              state_.position.data(), state_.velocity.data(),
                                              std::size_t(data_.nodeCount), state_.clock.data()});
}

template <class Numbers, class Executor>
BodyMotionValues ExplicitSolver<Numbers, Executor>::bodyMotion(std::size_t number)
{
    executor_.synchronize();
    const RigidBody body = state_.body.bodies.toHost()[number];
    Vec3<double> velocity, momentum;
    kicked(body, clock().step / 2, massDamping_ + clock().damping, velocity, momentum);
    const Vec3<double> spin = spinOf(body, momentum);
    const auto point = [](const Vec3<double>& a) { return Point{a.x, a.y, a.z}; };
    return {point(body.centre - body.start),
            point(velocity),
            point(spin),
            point(transpose(rotationOf(body.q)) * spin),
            point(body.contact.force + body.outer.force),
            point(body.contact.moment + body.outer.moment),
            point(momentum),
            0.5 * (body.mass * dot(velocity, velocity) + dot(momentum, spin)),
            0.5
                * (body.mass * dot(body.velocity, body.velocity)
                   + dot(body.momentum, spinOf(body, body.momentum)))};
}

} // namespace fpm
