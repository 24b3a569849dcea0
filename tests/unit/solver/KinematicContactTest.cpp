#include "kernels/contact/distribute/PassSums.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

RigidSurface plane(const std::string& name, Point point, Point normal)
{
    RigidSurface surface;
    surface.name = name;
    surface.point = point;
    surface.axis = normal;
    return surface;
}

ContactPair& press(Model& model, const std::vector<ElementSide>& sides, const RigidSurface& surface)
{
    ContactPair& pair = addContact(model, "touch" + surface.name, sides, {});
    pair.surface = Index(model.rigidSurfaces.size());
    model.rigidSurfaces.push_back(surface);
    return pair;
}

/// A block of aluminium with a corner at the origin, in constant steps.
Model block(Point velocity, Point origin = {0, 0, 1e-3})
{
    Model model;
    addBox(model.mesh, "block", {3, 3, 4}, origin, {3, 3, 4});
    renumber(model.mesh, 16);
    Part part = aluminium(PartKind::elastic, HourglassForm::physical, "block");
    // Its force lags half a step, which an impact would see in the balance.
    part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    model.parts = {part};
    throwPart(model, "block", velocity);
    model.control.backend = "serial";
    model.control.endTime = 1;
    model.control.fixedTimeStep = 5e-8;
    return model;
}

double deepest(Solver& solver, const Point& normal)
{
    const NodeValues values = solver.nodes().values({});
    double least = 0;
    for (std::size_t i = 0; i < values.count; ++i) {
        const Point x = values.at(0, i);
        least = std::min(least, x[0] * normal[0] + x[1] * normal[1] + x[2] * normal[2]);
    }
    return -least;
}

double distance(const Point& a, const Point& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The force that is read at a time is that which acts: its impulse is the change of momentum in
/// every single step. No node is ever inside, and the step is that of the elements.
TEST(KinematicContact, ForceIsTheChangeOfMomentumAndNothingIsEntered)
{
    Model model = block({2e3, -1e3, -1e4});
    press(model, skin(model.mesh, 0), plane("floor", {0, 0, 0}, {0, 0, 1})).friction = 0.2;
    const auto solver = startedSolver(model);
    solver->advance(1, 1);
    const double size = lengthOf(momentum(*solver));
    Index touched = 0;
    for (int n = 0; n < 400; ++n) {
        const Point before = momentum(*solver);
        const PairForce pair = solver->contact().force(0);
        touched = std::max(touched, pair.active);
        solver->advance(1, 1);
        Point expected = before;
        for (std::size_t c = 0; c < 3; ++c) expected[c] += 5e-8 * pair.force[c];
        EXPECT_LT(distance(momentum(*solver), expected), 1e-13 * size);
        EXPECT_LT(deepest(*solver, {0, 0, 1}), 1e-13);
        EXPECT_EQ(solver->clock().contactFrequency, 0);
        EXPECT_NEAR(solver->clock().stableStep, solver->clock().elementStep, 1e-20);
    }
    EXPECT_EQ(touched, 16);
    EXPECT_GT(momentum(*solver)[2], 0.5 * 2.7e-9 * 36 * 1e4); // it has come back
    const Energies e = solver->ledger().energies();
    EXPECT_GT(e.contactDamping, 0); // four of twenty layers of mass lost their speed at once
    EXPECT_GT(e.friction, 0);
    EXPECT_LT(std::abs(e.balance), 1e-4);
}

TEST(KinematicContact, SlidingForceIsTheCoefficientTimesThePressure)
{
    Model model = block({5e4, 0, 0}, {0, 0, 0});
    model.parts[0].poissonsRatio = 0; // all nodes slide along x
    press(model, facing(model.mesh, "block", {0, 0, -1}), plane("floor", {0, 0, 0}, {0, 0, 1}))
        .friction = 0.3;
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::force, "weight",
                                                 nodesOfPart(model.mesh, "block"),
                                                 {true, true, true}, {0, 0, -900}));
    const auto solver = startedSolver(model);
    double pressed = 0;
    for (int n = 0; n < 300; ++n) {
        solver->advance(1, 1);
        const PairForce pair = solver->contact().force(0);
        // The nodes slide along x but for their swing of up to a twentieth, in the square of that.
        EXPECT_NEAR(pair.force[0], -0.3 * pair.force[2], 1e-3 * 0.3 * pair.force[2]);
        pressed += pair.force[2] / 300;
        const PairStatus status = solver->contact().status(0);
        EXPECT_NEAR(status.normal, pair.force[2], 1e-9);
        EXPECT_NEAR(status.friction[0], pair.force[0], 1e-9);
        EXPECT_LT(status.maxDepth, 1e-14);
    }
    EXPECT_NEAR(pressed, 900, 0.05 * 900); // whole swings of its height
}

/// Below the bound nothing slips at all; springs of a penalty yield elastically.
TEST(KinematicContact, StickingNodesDoNotMove)
{
    Model model = block({0, 0, 0}, {0, 0, 0});
    press(model, facing(model.mesh, "block", {0, 0, -1}), plane("floor", {0, 0, 0}, {0, 0, 1}))
        .friction = 0.5;
    model.control.massDamping = 1e5;
    const Amplitude slow{Amplitude::Kind::smooth, {{0, 0}, {2e-5, 1}}};
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::force, "weight",
                                                 nodesOfPart(model.mesh, "block"),
                                                 {true, true, true}, {200, 0, -900}, slow));
    const auto solver = startedSolver(model);
    const std::vector<Index> soles = nodesWhere(model.mesh, [](Point p) { return p[2] == 0; });
    const NodeValues before = solver->nodes().values(soles);
    solver->advance(5e-5, 100000);
    const NodeValues after = solver->nodes().values(soles);
    for (std::size_t i = 0; i < soles.size(); ++i)
        EXPECT_LT(distance(before.at(0, i), after.at(0, i)), 1e-15);
    const PairForce pair = solver->contact().force(0);
    EXPECT_NEAR(pair.force[0], -200, 4);
    EXPECT_NEAR(pair.force[2], 900, 18);
    EXPECT_LT(solver->ledger().energies().friction, 1e-12);
}

/// A cube thrown into a corner: each wall takes the momentum of its direction.
TEST(KinematicContact, CornerOfThreeWalls)
{
    for (const double lean : {0.0, 0.5}) { // the third wall upright or leaning over the cube
        Model model = block({-8e3, -6e3, -7e3}, {1e-2, 1e-2, 1e-2});
        const double size = std::hypot(1.0, lean);
        const Point normals[] = {{0, 0, 1}, {0, 1, 0}, {1 / size, 0, -lean / size}};
        const Point walls[] = {{0, 0, 0}, {0, 0, 0}, {-4 * lean, 0, 0}};
        for (std::size_t wall = 0; wall < 3; ++wall)
            press(model, skin(model.mesh, 0),
                  plane(std::to_string(wall), walls[wall], normals[wall]));
        const auto solver = startedSolver(model);
        solver->advance(1, 1);
        const double scale = lengthOf(momentum(*solver));
        double most[3] = {0, 0, 0};
        for (int n = 0; n < 500; ++n) {
            Point expected = momentum(*solver);
            for (std::size_t wall = 0; wall < 3; ++wall) {
                const Point force = solver->contact().force(wall).force;
                const double press = force[0] * normals[wall][0] + force[1] * normals[wall][1]
                                     + force[2] * normals[wall][2];
                EXPECT_GE(press, 0);
                most[wall] = std::max(most[wall], press);
                for (std::size_t c = 0; c < 3; ++c) {
                    EXPECT_NEAR(force[c], press * normals[wall][c], 1e-9 * (1 + press));
                    expected[c] += 5e-8 * force[c];
                }
            }
            solver->advance(1, 1);
            EXPECT_LT(distance(momentum(*solver), expected), 1e-13 * scale);
            const NodeValues values = solver->nodes().values({});
            for (std::size_t i = 0; i < values.count; ++i)
                for (std::size_t wall = 0; wall < 3; ++wall) {
                    const Point x = values.at(0, i);
                    double gap = 0;
                    for (std::size_t c = 0; c < 3; ++c)
                        gap += (x[c] - walls[wall][c]) * normals[wall][c];
                    ASSERT_GT(gap, -1e-13);
                }
        }
        for (const double press : most) EXPECT_GT(press, 0);
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
    }
}

/// A plane with constant acceleration: its force is m a, and its work the kinetic energy it gives.
TEST(KinematicContact, AcceleratingPlanePushesWithMassTimesAcceleration)
{
    Model model = block({0, 0, 0}, {0, 0, 0});
    RigidSurface ram = plane("ram", {0, 0, 0}, {0, 0, 1});
    ram.motion = RigidSurface::Motion::velocity;
    ram.value = {0, 0, 1e4};
    ram.amplitude = {Amplitude::Kind::table, {{0, 0}, {2e-4, 1}}};
    press(model, skin(model.mesh, 0), ram);
    const auto solver = startedSolver(model, true);
    const double mass = 2.7e-9 * 36, force = mass * 1e4 / 2e-4;
    double mean = 0;
    int count = 0;
    while (solver->clock().time < 1.8e-4) {
        solver->advance(1.9e-4, 1);
        mean += solver->contact().force(0).force[2];
        ++count;
    }
    EXPECT_NEAR(mean / count, force, 0.02 * force);
    EXPECT_NEAR(momentum(*solver)[2], mass * 0.9e4, 0.02 * mass * 0.9e4);
    const Energies e = solver->ledger().energies();
    EXPECT_NEAR(e.external, 0.5 * mass * 0.81e8, 0.02 * 0.5 * mass * 0.81e8);
    EXPECT_LT(std::abs(e.balance), 1e-8);
}

/// What the surfaces do is booked with the nodes and with the pairs, independently of each other.
TEST(KinematicContact, NodalWorkIsThatOfThePairs)
{
    Model model = block({3e3, 2e3, -1e4});
    RigidSurface ball;
    ball.name = "ball";
    ball.kind = RigidSurface::Kind::sphere;
    ball.point = {1.5, 1.7, -4.01};
    ball.radius = 4;
    ball.motion = RigidSurface::Motion::velocity;
    ball.value = {1e3, 0, 5e3};
    press(model, skin(model.mesh, 0), ball).friction = 0.3;
    RigidSurface wall = plane("wall", {-0.5, 0, 0}, {1, 0, 0});
    wall.motion = RigidSurface::Motion::displacement;
    wall.value = {1, 0, 0};
    wall.amplitude = {Amplitude::Kind::smooth, {{0, 0}, {3e-5, 1}}};
    press(model, skin(model.mesh, 0), wall).friction = 0.1;
    // Nodes held in axes of their own, and driven ones.
    BoundaryCondition slide = condition(BoundaryCondition::Kind::fixed, "mirror",
                                        nodesWhere(model.mesh, [](Point p) { return p[1] > 2.99; }),
                                        {true, false, false});
    slide.axes = {{{0, 0.6, 0.8}, {0, -0.8, 0.6}, {1, 0, 0}}};
    model.boundaryConditions.push_back(slide);
    model.boundaryConditions.push_back(condition(
        BoundaryCondition::Kind::velocity, "pull",
        nodesWhere(model.mesh, [](Point p) { return p[0] > 2.99 && p[1] < 2.9 && p[2] < 2; }),
        {false, true, false}, {0, 2e3, 0}));
    for (const double damping : {0.0, 3e4}) {
        model.control.massDamping = damping;
        const auto solver = startedSolver(model, true);
        double scale = 0;
        for (int n = 0; n < 600; ++n) {
            solver->advance(1, 1);
            scale = std::max(scale, solver->ledger().energies().kinetic);
            double ofPairs = 0, closing = 0;
            for (const std::size_t pass : {0u, 1u}) {
                const auto sums = solver->contact().sumsOf(pass);
                ofPairs += sums[sumSurfaceWork] - sums[sumDissipated] - sums[sumDamped];
            }
            // Pairs have booked the half of this time's force that the nodes book with the next
            // step.
            const std::vector<Point> velocity = halfStepVelocities(*solver);
            const NodeValues values = solver->nodes().values({});
            for (std::size_t i = 0; i < values.count; ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    closing += 0.5 * 5e-8 * values.at(4, i)[c] * velocity[i][c];
            ASSERT_NEAR(ofPairs - closing, solver->ledger().nodalWorks().contact, 1e-11 * scale);
        }
        for (const std::size_t pair : {0u, 1u}) {
            EXPECT_GT(solver->contact().force(pair).friction, 1e-4 * scale);
            EXPECT_GT(solver->contact().force(pair).damping, 1e-5 * scale);
        }
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
    }
}

/// A block between two dies: a node under one of them stays on it.
TEST(KinematicContact, DiesAreNotEntered)
{
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single}) {
        Model model = block({0, 0, 0}, {-1.5, -1.5, -2});
        model.control.precision = precision;
        for (const double side : {1.0, -1.0}) {
            RigidSurface die;
            die.kind = RigidSurface::Kind::cylinder;
            die.name = side > 0 ? "upper" : "lower";
            die.point = {0, -10, side * 12};
            die.axis = {0, 1, 0};
            die.length = 20;
            die.radius = 10;
            die.motion = RigidSurface::Motion::displacement;
            die.value = {0, 0, -side * 0.2};
            die.amplitude = {Amplitude::Kind::smooth, {{0, 0}, {4e-5, 1}}};
            press(model, facing(model.mesh, "block", {0, 0, side}), die).friction = 0.2;
        }
        const auto solver = startedSolver(model);
        solver->advance(4e-5, 1000000);
        const PairForce upper = solver->contact().force(0), lower = solver->contact().force(1);
        EXPECT_LT(upper.force[2], -1000);
        const double rounding = precision == Precision::single  ? 1e-3
                                : precision == Precision::mixed ? 1e-5
                                                                : 1e-7;
        EXPECT_NEAR(upper.force[2] + lower.force[2], 0, rounding * std::abs(upper.force[2]));
        for (const std::size_t pair : {0u, 1u})
            EXPECT_LT(solver->contact().status(pair).maxDepth,
                      precision == Precision::single ? 1e-7 : 1e-13);
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 2e-3);
    }
}

/// Under dynamic relaxation a soft block comes to rest between two planes, pressed by E ln 2 A.
TEST(KinematicContact, RelaxesASqueezedBlock)
{
    Model model;
    addBox(model.mesh, "block", {4, 4, 4}, {0, 0, 0}, {40, 40, 40});
    renumber(model.mesh);
    Part soft = aluminium(PartKind::elastic, HourglassForm::physical, "block");
    soft.youngsModulus = 1;
    soft.poissonsRatio = 0;
    soft.density = 1e-9;
    model.parts = {soft};
    RigidSurface top = plane("top", {0, 0, 40}, {0, 0, -1});
    top.motion = RigidSurface::Motion::displacement;
    top.value = {0, 0, -20};
    top.amplitude = {Amplitude::Kind::smooth, {{0, 0}, {3e-2, 1}}};
    press(model, skin(model.mesh, 0), top);
    press(model, skin(model.mesh, 0), plane("bottom", {0, 0, 0}, {0, 0, 1}));
    model.control.backend = "serial";
    model.control.relaxationTolerance = 1e-3;
    const auto solver = startedSolver(model);
    solver->advance(10, 1000000);
    ASSERT_TRUE(solver->clock().settled);
    const double exact = std::log(2.0) * 1600;
    EXPECT_NEAR(-solver->contact().force(0).force[2], exact, 0.01 * exact);
    EXPECT_NEAR(solver->contact().force(1).force[2], exact, 0.01 * exact);
    EXPECT_LT(solver->contact().status(0).maxDepth, 1e-13);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
}

} // namespace
} // namespace fpm::test
