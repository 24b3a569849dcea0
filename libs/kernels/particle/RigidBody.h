#pragma once

#include "base/Types.h"
#include "kernels/particle/NodeMotion.h"
#include "parallel/Vec3.h"

namespace fpm {

/// Force, then moment about the centre.
struct Wrench {
    Vec3<double> force, moment;
};

struct BodyEnergy {
    double kinetic, closing;
};
struct BodyAcceleration {
    Vec3<double> centre, turn;
};

/// A free rigid body: position X, orientation q, velocity V and angular momentum H about the centre
/// at the half step, in global axes. A point that was x0 from the centre is at X + R(q) x0.
struct RigidBody {
    double mass;
    Mat3<double> inertia, inverseInertia; ///< about the centre, in the axes of the start
    Mat3<double> axes;                    ///< of the held translations, rows
    std::int32_t held;                    ///< bits 0..2: translation along axes row c held at 0
    std::int32_t turns;                   ///< 3 free, 1 only about `axis`, 0 none
    Vec3<double> axis;
    double axisInertia; ///< about `axis`

    Vec3<double> start, centre, velocity, momentum;
    double q[4];            ///< unit quaternion, q[3] real
    Wrench contact, outer;  ///< at the time of the positions
    Wrench last;            ///< resultant a step before, for dynamic relaxation alone
    double work[nodeWorks]; ///< running sums, as NodeMotion::blockWork
};

/// Matrix of a unit quaternion.
FPM_KERNEL Mat3<double> rotationOf(const double (&q)[4])
{
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    return {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
}

/// Angular velocity, in global axes, that belongs to an angular momentum.
FPM_KERNEL Vec3<double> spinOf(const RigidBody& body, const Vec3<double>& momentum)
{
    if (body.turns == 0) return {0, 0, 0};
    if (body.turns == 1) return (dot(momentum, body.axis) / body.axisInertia) * body.axis;
    const Mat3<double> r = rotationOf(body.q);
    return r * (body.inverseInertia * (transpose(r) * momentum));
}

/// (1 + [a]x)^-1 b
FPM_KERNEL Vec3<double> halfTurnedBack(const Vec3<double>& a, const Vec3<double>& b)
{
    return (1 / (1 + dot(a, a))) * (b - cross(a, b) + dot(a, b) * a);
}

/// q <- q (1, a) / |(1, a)|: the Cayley rotation by the vector 2 a in the body's axes.
FPM_KERNEL void turnQuaternion(double (&q)[4], const Vec3<double>& a)
{
    const Vec3<double> v{q[0], q[1], q[2]};
    const Vec3<double> u = v + q[3] * a + cross(v, a);
    const double w = q[3] - dot(v, a);
    const double scale = 1 / squareRoot(dot(u, u) + w * w);
    q[0] = scale * u.x;
    q[1] = scale * u.y;
    q[2] = scale * u.z;
    q[3] = scale * w;
}

/// Rotates the body through one step at constant angular momentum: implicit midpoint rule for the
/// momentum in body axes, R <- R cay(dt omega), omega = J^-1 (L^n + L^(n+1)) / 2 (Austin,
/// Krishnaprasad and Wang 1993). H = R L is unchanged and the energy L . J^-1 L / 2 is conserved
/// exactly; the error of the path is of second order. Each fixed-point iteration gains a factor dt
/// |omega|.
FPM_KERNEL void turnBody(RigidBody& body, double dt)
{
    if (body.turns == 0) return;
    const Mat3<double> back = transpose(rotationOf(body.q));
    if (body.turns == 1) {
        turnQuaternion(body.q, (0.5 * dt) * (back * spinOf(body, body.momentum)));
        return;
    }
    const Vec3<double> local = back * body.momentum;
    Vec3<double> a = (0.5 * dt) * (body.inverseInertia * local);
    for (int iteration = 0; iteration < 40; ++iteration) {
        const Vec3<double> next = (0.5 * dt) * (body.inverseInertia * halfTurnedBack(a, local));
        const Vec3<double> change = next - a;
        a = next;
        if (dot(change, change) <= 1e-34 * dot(a, a)) break;
    }
    turnQuaternion(body.q, a);
}

/// Momentum of the next half step: leapfrog with damping, then the fixed components set to 0.
FPM_KERNEL double damped(double old, double force, double h, double damping)
{
    return leapFrogVelocity(old, force, 1.0, h, damping);
}
FPM_KERNEL Vec3<double>
damped(const Vec3<double>& old, const Vec3<double>& force, double h, double damping)
{
    return {damped(old.x, force.x, h, damping), damped(old.y, force.y, h, damping),
            damped(old.z, force.z, h, damping)};
}
FPM_KERNEL Vec3<double> withoutHeldTranslation(const RigidBody& body, const Vec3<double>& v)
{
    if (body.held == 0) return v;
    const Vec3<double> own = body.axes * v;
    const Vec3<double> left{body.held & 1 ? 0 : own.x, body.held & 2 ? 0 : own.y,
                            body.held & 4 ? 0 : own.z};
    return transpose(body.axes) * left;
}
FPM_KERNEL Vec3<double> withoutHeldTurns(const RigidBody& body, const Vec3<double>& h)
{
    if (body.turns == 3) return h;
    if (body.turns == 0) return {0, 0, 0};
    return dot(h, body.axis) * body.axis;
}

/// Velocity and angular momentum after an impulse over `h` of the current forces.
FPM_KERNEL void kicked(
    const RigidBody& body, double h, double damping, Vec3<double>& velocity, Vec3<double>& momentum)
{
    const Vec3<double> force = body.contact.force + body.outer.force,
                       moment = body.contact.moment + body.outer.moment;
    velocity =
        withoutHeldTranslation(body, damped(body.velocity, (1 / body.mass) * force, h, damping));
    momentum = withoutHeldTurns(body, damped(body.momentum, moment, h, damping));
}

/// Acceleration of the centre and angular acceleration at the time of the positions.
FPM_KERNEL BodyAcceleration accelerationOf(const RigidBody& body,
                                           const Vec3<double>& velocity,
                                           const Vec3<double>& momentum,
                                           double damping)
{
    const Vec3<double> force = (1 / body.mass) * (body.contact.force + body.outer.force),
                       moment = body.contact.moment + body.outer.moment,
                       spin = spinOf(body, momentum);
    BodyAcceleration out{withoutHeldTranslation(body, force - damping * velocity),
                         spinOf(body, withoutHeldTurns(body, moment - damping * momentum))};
    if (body.turns == 3) out.turn += spinOf(body, -cross(spin, momentum));
    return out;
}

/// Kinetic energy and closing half work at the time of the positions, as KineticEnergy has them.
FPM_KERNEL BodyEnergy bodyEnergy(const RigidBody& body, double step)
{
    Vec3<double> velocity, momentum;
    kicked(body, step, 0, velocity, momentum);
    const Vec3<double> spin = spinOf(body, body.momentum);
    return {0.5 * (body.mass * dot(body.velocity, velocity) + dot(spin, momentum)),
            0.5 * step * (dot(body.outer.force, body.velocity) + dot(body.outer.moment, spin))};
}

/// One step of a body: impulse of the forces of t^n, works as in NodeMotion (moment times angular
/// velocity, so that their sum is the change of kinetic energy), then the motion.
struct BodyStep {
    RigidBody* bodies;
    double massDamping;
    const StepClock* clock;

    FPM_KERNEL void operator()(Index number) const
    {
        if (!clock->running) return;
        RigidBody& body = bodies[number];
        const double h = clock->mean, dt = clock->step, previous = 2 * clock->mean - clock->step,
                     rate = massDamping + clock->damping;
        const Vec3<double> oldVelocity = body.velocity, oldMomentum = body.momentum,
                           oldSpin = spinOf(body, oldMomentum);
        kicked(body, h, rate, body.velocity, body.momentum);
        const Vec3<double> spin = spinOf(body, body.momentum);
        const auto power = [](const Wrench& w, const Vec3<double>& v, const Vec3<double>& turn) {
            return dot(w.force, v) + dot(w.moment, turn);
        };
        double* work = body.work;
        work[contactBefore] += 0.5 * previous * power(body.contact, oldVelocity, oldSpin);
        work[contactAfter] += 0.5 * dt * power(body.contact, body.velocity, spin);
        work[externalBefore] += 0.5 * previous * power(body.outer, oldVelocity, oldSpin);
        work[externalAfter] += 0.5 * dt * power(body.outer, body.velocity, spin);
        const Vec3<double> mean = 0.5 * (oldVelocity + body.velocity);
        work[damping] += h * rate
                         * (body.mass * dot(mean, mean)
                            + 0.25 * dot(oldMomentum + body.momentum, oldSpin + spin));
        body.centre = multiplyAdd(dt, body.velocity, body.centre);
        turnBody(body, dt);
    }
};

} // namespace fpm
