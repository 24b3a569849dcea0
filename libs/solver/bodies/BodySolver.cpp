#include "solver/bodies/BodySolver.h"

namespace fpm {

void BodySolver::move()
{
    if (setUp_.bodies.empty()) return;
    backend_.timed(seconds_, [this] { launches_.moveBodies(); });
}

void BodySolver::updateForces()
{
    if (setUp_.bodies.empty()) return;
    backend_.timed(seconds_, [this] { launches_.bodyForces(); });
}

BodyMotionValues BodySolver::motion(std::size_t number) const
{
    backend_.synchronize();
    const StepClock clock = clock_.clock.toHost()[0];
    const RigidBody body = fields_.bodies.toHost()[number];
    Vec3<double> velocity, momentum;
    kicked(body, clock.step / 2, massDamping_ + clock.damping, velocity, momentum);
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
