#include "run/MotionHealth.h"

#include "base/Format.h"
#include "run/BodyOverlap.h"
#include "run/Box.h"
#include "run/HealthLimits.h"
#include "run/RigidShare.h"

#include <cmath>

namespace fpm {

MotionHealth::MotionHealth(const Model& model) : model_(model), bodies_(model) {}

void MotionHealth::addRows(Solver& solver, HealthRows& rows) const
{
    addMass(solver, rows);
    const NodeValues nodes = solver.nodes().values({});
    const bool drifts = addDrift(solver, nodes, rows);
    addRest(solver.clock(), drifts, rows);
    addIdle(rows);
    addOverlaps(nodes, solver.clock().time, rows);
}

void MotionHealth::addMass(const Solver& solver, HealthRows& rows) const
{
    if (solver.elements().setUp().scaled == 0) return;
    double own = 0, scaled = 0;
    for (std::size_t i = 0; i < solver.nodes().setUp().mass.size(); ++i) {
        own += solver.nodes().setUp().ownMass[i];
        scaled += solver.nodes().setUp().mass[i];
    }
    const double added = own > 0 ? scaled / own - 1 : 0;
    const bool watched = model_.control.kineticShare > 0 && model_.initialVelocities.empty();
    rows.push_back({"mass added by scaling / own mass", added, HealthLimits::addedMass, "", -1,
                    added > HealthLimits::addedMass && !watched,
                    "bodies that start with a velocity bring energy and momentum of that mass, and "
                    "without quasiStatic nobody watches the inertia of others: scale the mass only "
                    "of slow processes"});
}

/// True where a body flies off.
bool MotionHealth::addDrift(Solver& solver, const NodeValues& nodes, HealthRows& rows) const
{
    const Control& control = model_.control;
    if (!(control.relaxationTolerance > 0) && !(control.kineticShare > 0)) return false;
    const Energies energies = solver.ledger().energies();
    const double held = energies.internal + energies.hourglass;
    bool found = false;
    for (std::size_t body = 0; body < bodies_.count(); ++body) {
        if (bodies_.isHeld(body) || isRigid(model_.parts[bodies_.parts(body).front()].kind))
            continue;
        std::vector<Point> places, velocities;
        std::vector<double> masses;
        for (const Index node : bodies_.nodes(body)) {
            places.push_back(nodes.at(0, std::size_t(node)));
            velocities.push_back(nodes.at(1, std::size_t(node)));
            masses.push_back(solver.nodes().setUp().mass[std::size_t(node)]);
        }
        const RigidShare share = rigidShare(places, velocities, masses);
        const double value = share.kinetic > 0 ? share.rigid / share.kinetic : 0;
        const bool drifts = value > HealthLimits::rigidMotion && share.kinetic > held;
        rows.push_back({"rigid motion / kinetic energy, nothing holds it", value,
                        HealthLimits::rigidMotion, bodies_.name(body), energies.time, drifts,
                        "the body flies off as a whole: hold it with fixed or symmetry, or let it "
                        "rest on something"});
        found |= drifts;
    }
    return found;
}

void MotionHealth::addRest(const StepClock& clock, bool drifts, HealthRows& rows) const
{
    const double limit = model_.control.relaxationTolerance;
    if (!(limit > 0)) return;
    rows.push_back({"dynamic relaxation: force out of balance", clock.residual, limit, "",
                    clock.time, !clock.settled && !drifts,
                    "it has not come to rest: a later endTime, and is everything held?"});
}

void MotionHealth::addIdle(HealthRows& rows) const
{
    for (std::size_t body = 0; body < bodies_.count(); ++body)
        if (!bodies_.isConcerned(body))
            rows.push_back({"bodies that nothing moves, loads or touches", 1, 0, bodies_.name(body),
                            -1, true,
                            "it costs time and does nothing: is a condition or a contact pair "
                            "missing?"});
}

void MotionHealth::addOverlaps(const NodeValues& nodes, double time, HealthRows& rows) const
{
    std::vector<Point> points;
    for (std::size_t i = 0; i < nodes.count; ++i) points.push_back(nodes.at(0, i));
    std::vector<Box> boxes(bodies_.count());
    for (std::size_t body = 0; body < boxes.size(); ++body)
        for (const Index node : bodies_.nodes(body)) boxes[body].take(points[std::size_t(node)]);
    const auto add = [&](std::size_t a, std::size_t b) {
        const BodyOverlap overlap =
            overlapOf(model_.mesh, points, bodies_.nodes(a), bodies_.parts(b));
        if (overlap.count == 0) return;
        const Point& at = points[std::size_t(overlap.node)];
        rows.push_back({"nodes inside a body with which there is no contact", double(overlap.count),
                        0,
                        format("{} in {}, first node {} at ({} {} {})", bodies_.name(a),
                               bodies_.name(b), overlap.node, at[0], at[1], at[2]),
                        time, true,
                        "bodies pass through one another unless contact says otherwise: add a "
                        "pair or 'general' to system/contactDict"});
    };
    forBoxesThatMeet(boxes, [&](std::size_t a, std::size_t b) {
        if (bodies_.mayMeet(a, b)) return;
        add(a, b);
        add(b, a);
    });
}

} // namespace fpm
