#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

using Kind = BoundaryCondition::Kind;

/// Steel brick of 0.3 x 0.2 x 0.1 m, free.
Model brick()
{
    Part part;
    part.name = "box";
    part.kind = PartKind::rigidFree;
    part.density = 7850;
    Model model = boxModel({3, 2, 1}, {0.3, 0.2, 0.1}, part);
    model.control.fixedTimeStep = 1e-5;
    return model;
}
void spin(Model& model, Point omega)
{
    InitialVelocity initial;
    initial.nodes = nodesOfPart(model.mesh, "box");
    initial.part = 0;
    initial.rotates = true;
    initial.centre = {0.15, 0.1, 0.05};
    initial.spin = omega;
    model.initialVelocities.push_back(initial);
}

double distance(const Point& a, const Point& b)
{
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
                     + (a[2] - b[2]) * (a[2] - b[2]));
}

TEST(RigidBody, TakesMassCentreAndInertiaFromTheMesh)
{
    const auto solver = startedSolver(brick());
    const RigidBody& body = solver->bodies().setUp().bodies[0];
    EXPECT_NEAR(body.mass, 47.1, 1e-12);
    EXPECT_NEAR(body.start.x, 0.15, 1e-15);
    EXPECT_NEAR(body.inertia.x.x, 0.19625, 1e-13);
    EXPECT_NEAR(body.inertia.y.y, 0.39250, 1e-13);
    EXPECT_NEAR(body.inertia.z.z, 0.51025, 1e-13);
    EXPECT_NEAR(body.inertia.x.y, 0, 1e-14);
}

TEST(RigidBody, TakesWhatIsGivenInstead)
{
    Model model = brick();
    GivenInertia& given = model.parts[0].inertia;
    given.mass = 10;
    given.hasCentre = given.hasInertia = true;
    given.centre = {0.1, 0.1, 0.1};
    given.inertia = {3, 4, 5, 0.1, 0.2, 0.3};
    const auto solver = startedSolver(model);
    const RigidBody& body = solver->bodies().setUp().bodies[0];
    EXPECT_EQ(body.mass, 10);
    EXPECT_EQ(body.start.z, 0.1);
    EXPECT_EQ(body.inertia.y.z, 0.2);
    const Mat3<double> one = body.inertia * body.inverseInertia;
    EXPECT_NEAR(one.x.x, 1, 1e-15);
    EXPECT_NEAR(one.x.y, 0, 1e-15);
}

/// Sign changes of the angular velocity about the intermediate axis: exact times 0.19860, 0.54999,
/// 0.90138 s.
TEST(RigidBody, FreeBrickFlips)
{
    Model model = brick();
    spin(model, {0.1, 100, 0.1});
    const auto solver = startedSolver(model);
    const BodyMotionValues first = solver->bodies().motion(0);
    EXPECT_NEAR(first.kinetic, 1962.5035, 1e-4);
    std::vector<double> flips;
    double before = 100, timeBefore = 0;
    while (solver->clock().time < 1) {
        solver->advance(1, 20);
        const double now = solver->bodies().motion(0).localSpin[1], time = solver->clock().time;
        if (now * before < 0)
            flips.push_back(timeBefore + (time - timeBefore) * before / (before - now));
        before = now;
        timeBefore = time;
    }
    ASSERT_EQ(flips.size(), 3u);
    const double exact[3] = {0.19860, 0.54999, 0.90138};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(flips[i], exact[i], 1e-3 * exact[i]);
    const BodyMotionValues last = solver->bodies().motion(0);
    EXPECT_NEAR(last.kinetic, first.kinetic, 1e-10 * first.kinetic);
    EXPECT_EQ(last.momentum, first.momentum);
    EXPECT_NEAR(solver->ledger().energies().kinetic, first.kinetic, 1e-10 * first.kinetic);
    // The nodes are those of an undeformed brick about its centre.
    const NodeValues nodes = solver->nodes().values({});
    const std::vector<Point>& start = model.mesh.points;
    for (std::size_t i = 0; i < nodes.count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NEAR(distance(nodes.at(0, i), nodes.at(0, j)), distance(start[i], start[j]),
                        1e-14);
}

/// Times at which the angular velocity about the brick's own y changes its sign, from the
/// velocities of its end faces z along its own x.
std::vector<double> flipsOfNodes(Model model, double end)
{
    const Mesh& mesh = model.mesh;
    const auto face = [&](std::size_t axis, double value) {
        return nodesWhere(mesh, [=](Point p) { return std::abs(p[axis] - value) < 1e-6; });
    };
    const std::vector<Index> low = face(2, 0), high = face(2, 0.1), left = face(0, 0),
                             right = face(0, 0.3);
    const auto solver = startedSolver(model);
    const auto mean = [&](int quantity, const std::vector<Index>& nodes) {
        const NodeValues values = solver->nodes().values(nodes);
        Point sum{};
        for (std::size_t i = 0; i < values.count; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += values.at(quantity, i)[c] / double(values.count);
        return sum;
    };
    std::vector<double> flips;
    double before = 0, timeBefore = 0;
    while (solver->clock().time < end) {
        solver->advance(end, 40);
        const Point up = mean(1, high), down = mean(1, low), a = mean(0, left), b = mean(0, right);
        double now = 0;
        for (std::size_t c = 0; c < 3; ++c) now += (up[c] - down[c]) * (b[c] - a[c]);
        const double time = solver->clock().time;
        if (now * before < 0)
            flips.push_back(timeBefore + (time - timeBefore) * before / (before - now));
        before = now;
        timeBefore = time;
    }
    return flips;
}

/// A brick of steel flips as the rigid body with the inertia of its lumped masses.
TEST(RigidBody, ADeformableBrickFlipsAsTheRigidOneOfItsNodes)
{
    Model steel = brick();
    spin(steel, {0.1, 100, 0.1});
    steel.control.fixedTimeStep = 0;
    Part& part = steel.parts[0];
    part = aluminium(PartKind::elastic, HourglassForm::physical);
    part.density = 7850;
    part.youngsModulus = 2.1e11;
    Model rigid = brick();
    spin(rigid, {0.1, 100, 0.1});
    const auto solver = startedSolver(steel);
    GivenInertia& given = rigid.parts[0].inertia;
    given.hasInertia = true;
    for (std::size_t i = 0; i < steel.mesh.points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double m = solver->nodes().setUp().mass[i], x = steel.mesh.points[i][c];
            const double square = m * std::pow(x - std::array{0.15, 0.1, 0.05}[c], 2);
            given.inertia[(c + 1) % 3] += square;
            given.inertia[(c + 2) % 3] += square;
        }
    const std::vector<double> a = flipsOfNodes(steel, 0.7), b = flipsOfNodes(rigid, 0.7);
    ASSERT_GE(b.size(), 1u);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 0.01 * b[i]);
}

TEST(RigidBody, NodesHaveTheVelocityOfTheirBody)
{
    Model model = brick();
    spin(model, {3, -20, 7});
    const auto solver = startedSolver(model);
    NodeValues before = solver->nodes().values({});
    solver->advance(1, 100);
    before = solver->nodes().values({});
    solver->advance(1, 1);
    const NodeValues now = solver->nodes().values({});
    solver->advance(1, 1);
    const NodeValues after = solver->nodes().values({});
    for (std::size_t i = 0; i < now.count; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double v = (after.at(0, i)[c] - before.at(0, i)[c]) / 2e-5;
            const double a = (after.at(0, i)[c] - 2 * now.at(0, i)[c] + before.at(0, i)[c]) / 1e-10;
            EXPECT_NEAR(now.at(1, i)[c], v, 1e-6);
            EXPECT_NEAR(now.at(2, i)[c], a, 1e-3);
        }
}

TEST(RigidBody, FallsAsEverythingDoes)
{
    Model model = brick();
    BoundaryCondition gravity = condition(Kind::gravity, "g", nodesOfPart(model.mesh, "box"),
                                          {true, true, true}, {0, 0, -9.81});
    gravity.parts = {0};
    model.boundaryConditions.push_back(gravity);
    model.initialVelocities.push_back({"", nodesOfPart(model.mesh, "box"), {2, 0, 0}, {}, {}, 0});
    const auto solver = startedSolver(model);
    solver->advance(0.1, 100000);
    const BodyMotionValues body = solver->bodies().motion(0);
    EXPECT_NEAR(body.displacement[0], 0.2, 1e-12);
    EXPECT_NEAR(body.displacement[2], -9.81 * 0.1 * 0.1 / 2, 1e-12);
    EXPECT_NEAR(body.velocity[2], -0.981, 1e-12);
    EXPECT_NEAR(body.force[2], -9.81 * 47.1, 1e-10);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-6);
}

TEST(RigidBody, AForceBesideTheCentreTurnsIt)
{
    Model model = brick();
    const auto corner =
        nodesWhere(model.mesh, [](Point p) { return p[0] > 0.29 && p[1] > 0.19 && p[2] < 0.01; });
    model.boundaryConditions.push_back(
        condition(Kind::force, "f", corner, {true, true, true}, {0, 5, 0}));
    const auto solver = startedSolver(model);
    const BodyMotionValues body = solver->bodies().motion(0);
    EXPECT_EQ(body.force, (Point{0, 5, 0}));
    EXPECT_NEAR(body.moment[0], 0.05 * 5, 1e-14);
    EXPECT_NEAR(body.moment[2], 0.15 * 5, 1e-14);
    const NodeValues at = solver->nodes().values(corner);
    // a = F / m + alpha x r, along y: alpha_z r_x - alpha_x r_z
    EXPECT_NEAR(at.at(2, 0)[1], 5 / 47.1 + 0.75 / 0.51025 * 0.15 + 0.25 / 0.19625 * 0.05, 1e-12);
}

TEST(RigidBody, IsHeldByItsConditions)
{
    Model model = brick();
    spin(model, {30, 20, 10});
    BoundaryCondition plane =
        condition(Kind::fixed, "mirror", nodesOfPart(model.mesh, "box"), {true, false, false});
    plane.part = 0;
    plane.turns = {false, true, true};
    model.boundaryConditions.push_back(plane);
    model.boundaryConditions.push_back(
        condition(Kind::force, "f", {0}, {true, true, true}, {40, 50, 60}));
    const auto solver = startedSolver(model, true);
    solver->advance(0.01, 10000);
    const BodyMotionValues body = solver->bodies().motion(0);
    EXPECT_EQ(body.displacement[0], 0);
    EXPECT_GT(std::abs(body.displacement[1]), 1e-5);
    EXPECT_EQ(body.spin[1], 0);
    EXPECT_EQ(body.spin[2], 0);
    EXPECT_GT(std::abs(body.spin[0] - 30), 0.01);
    const NodeValues nodes = solver->nodes().values({});
    for (std::size_t i = 0; i < nodes.count; ++i)
        EXPECT_NEAR(nodes.at(0, i)[0], model.mesh.points[i][0], 1e-15);
}

/// A rigid block strikes a deformable one off its centre.
Model strike(double friction = 0.3)
{
    Part upper;
    upper.kind = PartKind::rigidFree;
    upper.density = 2.7e-9;
    Model model = twoBlocks(upper, aluminium(PartKind::elastic, HourglassForm::physical),
                            {2e4, -1e4, -8e4}, friction, 0.01);
    model.initialVelocities[0].part = 1;
    return model;
}

/// m V of the half step, from V and F of the full step.
Point bodyMomentum(Solver& solver)
{
    const BodyMotionValues body = solver.bodies().motion(0);
    Point out{};
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = solver.bodies().setUp().bodies[0].mass * body.velocity[c]
                 - 0.5 * solver.clock().step * body.force[c];
    return out;
}

TEST(RigidBody, BouncesOffADeformableBlockAndMomentumStays)
{
    const Model model = strike();
    const auto solver = startedSolver(model, true);
    const std::vector<Index> lower = nodesOfPart(model.mesh, "lower");
    const Point start = bodyMomentum(*solver);
    double touched = 0;
    for (int call = 0; call < 40; ++call) {
        solver->advance(4e-5, 20);
        touched = std::max(touched, double(solver->contact().force(0).active));
        const Point body = bodyMomentum(*solver), block = momentum(*solver, lower);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(body[c] + block[c], start[c], 1e-12 * std::abs(start[2]));
    }
    solver->advance(4e-5, 1000000);
    EXPECT_GT(touched, 5);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_GT(solver->bodies().motion(0).velocity[2], -4e4);
    EXPECT_GT(std::abs(solver->bodies().motion(0).spin[0]), 10);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
}

/// K of nodes and body at the half step is the sum of the works, to rounding.
TEST(RigidBody, LedgerOfNodesAndBodyIsExact)
{
    Model model = strike();
    model.control.fixedTimeStep = 2e-8;
    model.control.massDamping = 1e4;
    BoundaryCondition gravity = condition(Kind::gravity, "g", nodesOfPart(model.mesh, "upper"),
                                          {true, true, true}, {1e9, 0, -3e9});
    gravity.parts = {0, 1};
    gravity.nodes = nodesWhere(model.mesh, [](Point) { return true; });
    model.boundaryConditions.push_back(gravity);
    BoundaryCondition pressure =
        condition(Kind::pressure, "p", {}, {true, true, true}, {400, 0, 0});
    pressure.sides = facing(model.mesh, "upper", {1, 0, 0});
    pressure.nodes = nodesOf(model.mesh, pressure.sides);
    model.boundaryConditions.push_back(pressure);
    const auto solver = startedSolver(model, true);
    const auto kinetic = [&] {
        // The body's from v^(n-1/2) . v^(n+1/2) would not do: take the state itself.
        double sum = 0;
        const std::vector<Point> v = halfStepVelocities(*solver);
        const std::vector<Index> lower = nodesOfPart(model.mesh, "lower");
        for (const Index node : lower)
            for (const double c : v[std::size_t(node)])
                sum += 0.5 * solver->nodes().setUp().mass[std::size_t(node)] * c * c;
        return sum + solver->bodies().motion(0).halfStepKinetic;
    };
    solver->advance(1, 1); // the first step is half a one
    const double start = kinetic();
    const NodalWorks first = solver->ledger().nodalWorks();
    const auto booked = [](const NodalWorks& w) {
        return w.internal + w.contact + w.external + w.drives - w.damping;
    };
    for (int call = 0; call < 20; ++call) {
        solver->advance(1, 25);
        EXPECT_NEAR(kinetic() - start, booked(solver->ledger().nodalWorks()) - booked(first),
                    1e-10 * start);
    }
    EXPECT_GT(std::abs(solver->ledger().nodalWorks().contact), 1e-4 * start);
    EXPECT_GT(std::abs(solver->ledger().nodalWorks().external), 1e-4 * start);
    EXPECT_GT(solver->ledger().nodalWorks().damping, 1e-4 * start);
}

TEST(RigidBody, ItsElementsDoNotLimitTheStep)
{
    Model model = strike(0);
    const auto reference = startedSolver(model);
    reference->advance(1, 2);
    Model fine = model;
    // The layer below the top moves up: elements of a hundredth of the height.
    for (Point& p : fine.mesh.points)
        if (std::abs(p[2] - 4.81) < 0.01) p[2] = 6;
    const auto solver = startedSolver(fine);
    solver->advance(1, 2);
    EXPECT_EQ(solver->clock().elementStep, reference->clock().elementStep);
}

TEST(RigidBody, ItsMassBoundsTheStepOfItsContactSprings)
{
    // A light body on stiff springs: without it in the bound the contact would explode.
    Model model = strike(0);
    model.parts[1].density = 2.7e-13;
    const auto solver = startedSolver(model);
    solver->advance(2e-6, 1000000);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_GT(solver->clock().contactFrequency, 0);
    EXPECT_LE(solver->clock().contactFrequency * solver->clock().step, 0.8 * (1 + 1e-9));
    EXPECT_LT(solver->ledger().energies().kinetic, 0.5 * 2.7e-13 * 180 * 6.9e9 * 1.1);
}

class RigidBodyBits : public testing::TestWithParam<Precision>
{};

TEST_P(RigidBodyBits, AreTheSameOnThreadsAndVectorWidths)
{
    const auto run = [](const char* backend, int threads, const char* simd) {
        Model model = strike();
        model.control.precision = GetParam();
        model.control.backend = backend;
        model.control.threads = threads;
        model.control.simd = simd;
        const auto solver = startedSolver(model);
        solver->advance(1, 60);
        EXPECT_GT(solver->ledger().energies().friction, 0);
        return stateChecksum(*solver);
    };
    const std::uint64_t serial = run("serial", 1, "scalar");
    EXPECT_EQ(run("serial", 1, "auto"), serial);
    EXPECT_EQ(run("openmp", 2, "avx2"), serial);
}

INSTANTIATE_TEST_SUITE_P(Precisions,
                         RigidBodyBits,
                         testing::Values(Precision::double_, Precision::mixed, Precision::single));

} // namespace
} // namespace fpm::test
