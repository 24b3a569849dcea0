#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// Everything at once: contact with friction, plasticity, a load, drives, a support, damping. The
/// blocks come within reach after a while, so that the contact springs shorten the step.
Model busyScene()
{
    Model model = twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical),
                            aluminium(PartKind::elastic, HourglassForm::stiffness),
                            {2e4, -1e4, -8e4}, 0.3, 0.5);
    using Kind = BoundaryCondition::Kind;
    const auto below = [](Point p) { return p[2] < -3.99; };
    const auto left = [](Point p) { return p[0] < -1.99 && p[2] > -3.99; };
    const auto top = [](Point p) { return p[2] > 6.49; };
    const auto back = [](Point p) { return p[1] > 8.99 && p[2] > -3.99 && p[0] > -1.99; };
    holdFixed(model, nodesWhere(model.mesh, below));
    model.boundaryConditions.push_back(condition(Kind::force, "load", nodesWhere(model.mesh, top),
                                                 {true, true, true}, {500, -300, -4000},
                                                 {Amplitude::Kind::table, {{0, 0}, {2e-6, 1}}}));
    model.boundaryConditions.push_back(
        condition(Kind::velocity, "pull", nodesWhere(model.mesh, left), {true, false, false},
                  {-3e3, 0, 0}, {Amplitude::Kind::smooth, {{0, 0}, {3e-6, 1}}}));
    model.boundaryConditions.push_back(
        condition(Kind::displacement, "push", nodesWhere(model.mesh, back), {false, true, false},
                  {0, -0.02, 0}, {Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}}}));
    BoundaryCondition pressure =
        condition(Kind::pressure, "blast", {}, {true, true, true}, {30, 0, 0},
                  {Amplitude::Kind::table, {{0, 1}, {2e-6, 0}}});
    pressure.sides = facing(model.mesh, "upper", {0, 1, 0});
    pressure.nodes = nodesOf(model.mesh, pressure.sides);
    BoundaryCondition traction =
        condition(Kind::traction, "shear", {}, {true, true, true}, {20, 10, -5});
    traction.sides = facing(model.mesh, "upper", {1, 0, 0});
    traction.nodes = nodesOf(model.mesh, traction.sides);
    traction.axes = {{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}};
    BoundaryCondition gravity =
        condition(Kind::gravity, "fall", nodesWhere(model.mesh, [](Point) { return true; }),
                  {true, true, true}, {1e8, 0, -3e8});
    gravity.parts = {0, 1};
    BoundaryCondition slide = condition(
        Kind::fixed, "mirror",
        nodesWhere(model.mesh, [](Point p) { return p[0] > 6.99 && p[0] < 7.01 && p[2] > 5; }),
        {true, false, false});
    slide.axes = {{{0.6, 0, 0.8}, {-0.8, 0, 0.6}, {0, -1, 0}}};
    BoundaryCondition turn = condition(
        Kind::rotation, "turn",
        nodesWhere(model.mesh, [](Point p) { return p[0] > 9.99 && p[2] > -3.99 && p[1] < 8.99; }),
        {true, true, true}, {0, 0, 0}, {Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}}});
    turn.line = {Point{10, 3, -2}, Point{1, 0, 0}};
    turn.angle = 0.5;
    for (const BoundaryCondition& one : {pressure, traction, gravity, slide, turn})
        model.boundaryConditions.push_back(one);
    model.control.massDamping = 2e4;
    return model;
}

/// 1/2 sum m v.v
double kinetic(const Solver& solver, const std::vector<Point>& velocity)
{
    double sum = 0;
    const std::vector<double>& mass = solver.nodes().setUp().mass;
    for (std::size_t i = 0; i < mass.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum += 0.5 * mass[i] * velocity[i][c] * velocity[i][c];
    return sum;
}

/// Work F^n . (dx^(n-1/2) + dx^(n+1/2)) / 2 less h F^n . (v^(n-1/2) + v^(n+1/2)) / 2, the change of
/// kinetic energy: (dt+ - dt-) / 4 F^n . (v+ - v-) with F^n = m (v+ - v-) / h + xi m (v+ + v-) / 2.
/// It vanishes where two steps are equal.
double unequalStepsWork(const Solver& solver,
                        const std::vector<Point>& before,
                        const std::vector<Point>& after,
                        double stepBefore,
                        double stepAfter,
                        double damping)
{
    const double h = (stepBefore + stepAfter) / 2;
    double sum = 0;
    const std::vector<double>& mass = solver.nodes().setUp().mass;
    for (std::size_t i = 0; i < mass.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double change = after[i][c] - before[i][c],
                         mean = (after[i][c] + before[i][c]) / 2;
            sum += mass[i] * (change / h + damping * mean) * change;
        }
    return sum * (stepAfter - stepBefore) / 4;
}

struct Audit {
    double largestError = 0; ///< of the identity, relative to the largest energy or work
    double unequal = 0;      ///< largest sum of unequalStepsWork, same scale
    double stepRatio = 1;    ///< largest step over smallest, the first left out
};

/// Checks K(v^(n+1/2)) - K(v^0) = works after every one of `steps` steps.
Audit audit(const Model& model, int steps)
{
    const auto solver = startedSolver(model, true);
    std::vector<Point> before = solver->nodes().setUp().velocity;
    const double start = kinetic(*solver, before);
    double previous = 0, correction = 0, least = 1e300, most = 0;
    Audit out;
    for (int n = 0; n < steps; ++n) {
        solver->advance(1, 1);
        const double step = solver->clock().step;
        const std::vector<Point> after = halfStepVelocities(*solver);
        correction +=
            unequalStepsWork(*solver, before, after, previous, step, model.control.massDamping);
        const NodalWorks w = solver->ledger().nodalWorks();
        const double gained = kinetic(*solver, after) - start;
        const double booked = w.internal + w.contact + w.external + w.drives - w.damping;
        const double scale =
            std::max({start, std::abs(w.internal), std::abs(w.external), std::abs(w.drives)});
        out.largestError =
            std::max(out.largestError, std::abs(gained - (booked - correction)) / scale);
        out.unequal = std::max(out.unequal, std::abs(correction) / scale);
        if (n > 0) {
            least = std::min(least, step);
            most = std::max(most, step);
        }
        before = after;
        previous = step;
    }
    out.stepRatio = most / least;
    const NodalWorks w = solver->ledger().nodalWorks();
    for (const double part : {w.internal, w.contact, w.external, w.drives, w.damping})
        EXPECT_GT(std::abs(part), 1e-6 * start) << "the scene misses a force family";
    EXPECT_GT(solver->ledger().energies().plastic, 0);
    EXPECT_GT(solver->ledger().energies().friction, 0);
    return out;
}

TEST(EnergyIdentity, HoldsToRoundingWithConstantStep)
{
    Model model = busyScene();
    model.control.fixedTimeStep = 3e-8;
    const Audit result = audit(model, 500);
    EXPECT_EQ(result.stepRatio, 1);
    EXPECT_LT(result.largestError, 1e-10);
}

/// A damped body in flight: what it loses is in the ledger at every time, of one with elements and
/// of a rigid one.
TEST(EnergyIdentity, LedgerOfADampedFlightCloses)
{
    for (const PartKind kind : {PartKind::elastic, PartKind::rigidFree}) {
        Model model = boxModel({2, 2, 2}, {2, 2, 2}, aluminium(kind, HourglassForm::physical));
        throwPart(model, "box", {1e4, 0, 5e3});
        model.initialVelocities.back().part = kind == PartKind::rigidFree ? 0 : -1;
        model.control.massDamping = 2e5;
        model.control.fixedTimeStep = 5e-8;
        const auto solver = startedSolver(model);
        const double start = solver->ledger().energies().kinetic;
        for (int n = 0; n < 100; ++n) {
            solver->advance(1, 1);
            EXPECT_LT(std::abs(solver->ledger().energies().error), 1e-12 * start);
        }
        EXPECT_LT(solver->ledger().energies().kinetic, 0.2 * start);
    }
}

/// The same pushed by a rough wall that is met exactly, whose force is known in the step alone.
TEST(EnergyIdentity, HoldsToRoundingOnAWallThatIsMetExactly)
{
    Model model = busyScene();
    RigidSurface wall;
    wall.name = "wall";
    wall.point = {0.95, 0, 0};
    wall.axis = {1, 0, 0.1};
    for (double& c : wall.axis) c /= std::hypot(1, 0.1);
    wall.motion = RigidSurface::Motion::velocity;
    wall.value = {4e4, 0, 0};
    model.rigidSurfaces.push_back(wall);
    ContactPair& pair = addContact(model, "wall", skin(model.mesh, 1), {});
    pair.surface = 0;
    pair.friction = 0.3;
    const Audit result = audit(model, 500);
    EXPECT_LT(result.largestError, 1e-10);
}

TEST(EnergyIdentity, HoldsToRoundingWithVariableStep)
{
    const Audit result = audit(busyScene(), 500);
    EXPECT_GT(result.stepRatio, 1.05);
    EXPECT_LT(result.largestError, 1e-10);
}

TEST(EnergyIdentity, TrapezoidalWorksDifferFromItLittleWhereTheStepVaries)
{
    const Audit result = audit(busyScene(), 500);
    EXPECT_GT(result.unequal, 1e-12);
    EXPECT_LT(result.unequal, 1e-3);
}

TEST(EnergyIdentity, LedgerOfTheRunCloses)
{
    const auto solver = startedSolver(busyScene());
    solver->advance(1.5e-5, 100000);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
}

TEST(EnergyIdentity, AuditDoesNotChangeTheMotion)
{
    Model model = busyScene();
    model.boundaryConditions.resize(2);
    model.control.massDamping = 0;
    const auto plain = startedSolver(model), audited = startedSolver(model, true);
    plain->advance(1, 200);
    audited->advance(1, 200);
    EXPECT_EQ(stateChecksum(*plain), stateChecksum(*audited));
    // Patches move most nodes of the one, the node pass all of the other: the same work, summed in
    // another order.
    EXPECT_TRUE(plain->nodes().setUp().movedByPatches);
    EXPECT_FALSE(audited->nodes().setUp().movedByPatches);
    const double work = audited->ledger().energies().external;
    EXPECT_GT(std::abs(work), 0);
    EXPECT_NEAR(plain->ledger().energies().external, work, 1e-12 * std::abs(work));
}

} // namespace
} // namespace fpm::test
