#include "mesh/Quality.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

RigidSurface plane(Point point, Point normal)
{
    RigidSurface surface;
    surface.name = "wall";
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

/// A bar of 160 cells, nu = 0, that flies at 10 m/s against a rigid wall: one wave, known exactly.
Model bar(Point velocity)
{
    Model model;
    addBox(model.mesh, "bar", {2, 2, 160}, {0, 0, 1e-3}, {1, 1, 40});
    renumber(model.mesh);
    Part part = aluminium(PartKind::elastic, HourglassForm::stiffness, "bar");
    part.poissonsRatio = 0;
    model.parts = {part};
    model.initialVelocities.push_back({"fly", nodesOfPart(model.mesh, "bar"), velocity});
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

double meanForce(Solver& solver, double from, double to)
{
    solver.advance(from, 1000000);
    double impulse = 0;
    while (solver.clock().time < to) {
        solver.advance(to, 1);
        impulse += solver.clock().step * solver.contact().force(0).force[2];
    }
    return impulse / (solver.clock().time - from);
}

TEST(RigidSurface, WallForceOfABarIsItsImpedanceTimesItsSpeed)
{
    Model model = bar({0, 0, -1e4});
    press(model, facing(model.mesh, "bar", {0, 0, -1}), plane({0, 0, 0}, {0, 0, 1}));
    const auto solver = startedSolver(model);
    const double c = std::sqrt(70000 / 2.7e-9), run = 40 / c, force = 2.7e-9 * c * 1e4;
    EXPECT_NEAR(meanForce(*solver, 0.4 * run, 1.6 * run), force, 0.003 * force);
    EXPECT_EQ(solver->contact().force(0).active, 9);
    solver->advance(3 * run, 1000000); // it has left after two runs, with its speed turned round
    EXPECT_EQ(solver->contact().force(0).active, 0);
    const double before = 2.7e-9 * 40 * 1e4;
    EXPECT_NEAR(momentum(*solver)[2], before, 0.02 * before);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.001);
}

TEST(RigidSurface, MovingWallDoesItsWorkOnTheBar)
{
    for (const bool byVelocity : {true, false}) {
        Model model = bar({0, 0, 0});
        RigidSurface wall = plane({0, 0, 0}, {0, 0, 1});
        wall.motion =
            byVelocity ? RigidSurface::Motion::velocity : RigidSurface::Motion::displacement;
        wall.value = {0, 0, byVelocity ? 1e4 : 1.0};
        if (!byVelocity) wall.amplitude = {Amplitude::Kind::table, {{0, 0}, {1e-4, 1}}};
        press(model, facing(model.mesh, "bar", {0, 0, -1}), wall);
        const auto solver = startedSolver(model);
        const double c = std::sqrt(70000 / 2.7e-9), run = 40 / c, force = 2.7e-9 * c * 1e4;
        EXPECT_NEAR(meanForce(*solver, 0.4 * run, 1.6 * run), force, 0.003 * force);
        const Energies e = solver->ledger().energies();
        EXPECT_NEAR(e.external, 1e4 * momentum(*solver)[2], 0.005 * e.external);
        EXPECT_LT(std::abs(e.balance), 0.001);
        solver->advance(4 * run, 1000000);
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.001);
        EXPECT_NEAR(momentum(*solver)[2], 2 * 2.7e-9 * 40 * 1e4, 0.04 * 2.7e-9 * 40 * 1e4);
    }
}

/// A soft block (SI) on a plane in a field of gravity, given as forces.
struct Slide {
    double angle = 0, mu = 0.3;
    Point start{0, 0, 0};
    Enforcement enforcement = Enforcement::kinematic;
    Amplitude amplitude; ///< of the weight
    Point end{0, 0, 0};
    Energies energies;
    double stop = -1; ///< time of the largest displacement

    Model model() const
    {
        Model model;
        addBox(model.mesh, "block", {2, 2, 1}, {0, 0, 0}, {0.1, 0.1, 0.05});
        renumber(model.mesh);
        Part part = aluminium(PartKind::elastic, HourglassForm::stiffness, "block");
        part.density = 1000;
        part.youngsModulus = 1e7;
        part.poissonsRatio = 0;
        model.parts = {part};
        ContactPair& pair =
            press(model, facing(model.mesh, "block", {0, 0, -1}), plane({0, 0, 0}, {0, 0, 1}));
        pair.friction = mu;
        pair.enforcement = enforcement;
        pair.tangentialScale = 1;
        pair.normalDamping = 0.2;
        // Gravity: an eighth of each element's weight at each of its nodes.
        for (const Index node : nodesOfPart(model.mesh, "block")) {
            double share = 0;
            for (const Hexahedron& h : model.mesh.hexahedra)
                share += double(std::count(h.begin(), h.end(), node)) / 8 / 4;
            const double weight = 0.5 * 9.81 * share;
            model.boundaryConditions.push_back(
                condition(BoundaryCondition::Kind::force, "weight", {node}, {true, true, true},
                          {weight * std::sin(angle), 0, -weight * std::cos(angle)}, amplitude));
        }
        model.initialVelocities.push_back({"slide", nodesOfPart(model.mesh, "block"), start});
        model.control.backend = "serial";
        model.control.endTime = 1;
        return model;
    }
    Point centre(Solver& solver) const
    {
        const NodeValues values = solver.nodes().values({});
        Point sum{0, 0, 0};
        for (std::size_t i = 0; i < values.count; ++i)
            for (std::size_t c = 0; c < 3; ++c) sum[c] += values.at(0, i)[c] / double(values.count);
        return sum;
    }
    void run(double time)
    {
        const auto solver = startedSolver(model());
        const Point begin = centre(*solver);
        double most = 0;
        for (int call = 1; call <= 200; ++call) {
            solver->advance(time * call / 200, 1000000);
            const Point at = centre(*solver);
            for (std::size_t c = 0; c < 3; ++c) end[c] = at[c] - begin[c];
            if (std::hypot(end[0], end[1]) > most + 1e-6) {
                most = std::hypot(end[0], end[1]);
                stop = time * call / 200;
            }
        }
        energies = solver->ledger().energies();
        EXPECT_FALSE(solver->clock().failed);
        EXPECT_LT(std::abs(energies.balance), 0.001);
    }
};

TEST(RigidSurface, SlidingBlockStopsWhereFrictionHasTakenItsEnergy)
{
    for (const double angle : {0.0, M_PI / 4}) {
        Slide slide;
        slide.start = {std::cos(angle), std::sin(angle), 0};
        slide.run(0.5);
        EXPECT_NEAR(std::hypot(slide.end[0], slide.end[1]), 0.169895, 0.005 * 0.169895);
        EXPECT_NEAR(std::atan2(slide.end[1], slide.end[0]), angle, 2e-3);
        EXPECT_NEAR(slide.stop, 0.33979, 0.005);
        EXPECT_NEAR(slide.energies.friction, 0.25, 0.005 * 0.25);
    }
}

TEST(RigidSurface, BlockOnAnInclineSlidesByTheLawOrSticks)
{
    const auto way = [](double degrees, double mu, const Amplitude& amplitude = {}) {
        Slide slide;
        slide.amplitude = amplitude;
        slide.angle = degrees * M_PI / 180;
        slide.mu = mu;
        slide.run(0.5);
        return slide.end[0];
    };
    EXPECT_NEAR(way(20, 0.3), 0.073713, 0.005 * 0.073713);
    EXPECT_NEAR(way(30, 0.4), 0.188340, 0.005 * 0.188340);
    EXPECT_NEAR(way(30, 0.2), 0.400732, 0.005 * 0.400732);
    const Amplitude slow{Amplitude::Kind::smooth, {{0, 0}, {0.1, 1}}};
    EXPECT_LT(std::abs(way(15, 0.3, slow)), 3e-6);
}

TEST(RigidSurface, StickingBlockCreepsNoFurtherThanItsElasticSlip)
{
    Slide slide;
    slide.enforcement = Enforcement::penalty;
    slide.angle = 15 * M_PI / 180;
    slide.amplitude = {Amplitude::Kind::smooth, {{0, 0}, {0.1, 1}}};
    Model model = slide.model();
    model.control.massDamping = 200; // the swing of the spring dies out
    const auto solver = startedSolver(model);
    const double start = slide.centre(*solver)[0];
    solver->advance(0.3, 1000000);
    const double early = slide.centre(*solver)[0] - start;
    solver->advance(0.9, 10000000);
    const double late = slide.centre(*solver)[0] - start;
    // Nine springs of k A^2 / V with K = E / 3, A = 0.05^2, V = 0.05^3; shear of the block on top.
    const double k = 9 * (1e7 / 3) * 0.05, weight = 0.5 * 9.81 * std::sin(slide.angle);
    EXPECT_GT(early, 0.9 * weight / k);
    EXPECT_LT(early, weight / k + weight / (1e7 / 2 * 0.01) * 0.05);
    EXPECT_NEAR(late, early, 1e-9);
}

/// A block pressed between two dies as between the jaws of a vice.
Model vice(double friction)
{
    Model model;
    addBox(model.mesh, "block", {6, 5, 4}, {-3, -2.5, -2}, {6, 5, 4});
    renumber(model.mesh, 32);
    model.parts = {aluminium(PartKind::elastoplastic, HourglassForm::physical, "block")};
    for (const double side : {1.0, -1.0}) {
        RigidSurface die;
        die.kind = RigidSurface::Kind::cylinder;
        die.name = side > 0 ? "upper" : "lower";
        die.point = {0, -10, side * 12};
        die.axis = {0, 1, 0};
        die.length = 20;
        die.radius = 10;
        die.motion = RigidSurface::Motion::displacement;
        die.value = {0, 0, -side * 0.1};
        die.amplitude = {Amplitude::Kind::smooth, {{0, 0}, {4e-5, 1}}};
        press(model, facing(model.mesh, "block", {0, 0, side}), die).friction = friction;
    }
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

TEST(RigidSurface, TwoDiesPressAlikeAndTheirWorkIsBooked)
{
    for (const double friction : {0.0, 0.3}) {
        const auto solver = startedSolver(vice(friction));
        solver->advance(4e-5, 1000000);
        const PairForce upper = solver->contact().force(0), lower = solver->contact().force(1);
        EXPECT_LT(upper.force[2], -100);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(upper.force[c] + lower.force[c], 0, 1e-8 * std::abs(upper.force[2]));
        EXPECT_NEAR(upper.force[0], 0, 1e-8 * std::abs(upper.force[2]));
        const Energies e = solver->ledger().energies();
        EXPECT_GT(e.external, 0);
        EXPECT_GT(e.plastic, 0);
        EXPECT_LT(std::abs(e.balance), 0.002);
    }
}

TEST(RigidSurface, CylinderEndsWhereItsAxisEnds)
{
    for (const bool infinite : {false, true}) {
        Model model = vice(0);
        for (RigidSurface& die : model.rigidSurfaces) {
            die.length = 10.2; // up to y = 0.2
            die.infinite = infinite;
        }
        const auto solver = startedSolver(model);
        solver->advance(4e-5, 1000000);
        const NodeValues values = solver->nodes().values(model.contactPairs[0].contactorNodes);
        double beyond = 0, under = 0;
        for (std::size_t i = 0; i < values.count; ++i)
            (values.at(0, i)[1] > 0.2 ? beyond : under) += values.at(4, i)[2];
        EXPECT_LT(under, -100);
        if (infinite)
            EXPECT_LT(beyond, -100);
        else
            EXPECT_EQ(beyond, 0);
    }
}

TEST(RigidSurface, SpherePressesABlockFromInsideAndFromOutside)
{
    // A block in a hollow sphere and a ball on a block: the force points to the right side, and a
    // moving sphere carries the momentum it gives.
    for (const bool inside : {false, true}) {
        Model model;
        addBox(model.mesh, "block", {4, 4, 4}, {-2, -2, -2}, {4, 4, 4});
        renumber(model.mesh);
        model.parts = {aluminium(PartKind::elastic, HourglassForm::physical, "block")};
        RigidSurface ball;
        ball.kind = RigidSurface::Kind::sphere;
        ball.name = "ball";
        ball.inside = inside;
        ball.radius = inside ? std::sqrt(12.0) + 1e-3 : 3;
        ball.point = {0, 0, inside ? 0 : 5.001};
        ball.motion = RigidSurface::Motion::velocity;
        ball.value = {0, 0, -1e4};
        press(model, skin(model.mesh, 0), ball);
        model.parts[0].linearBulkViscosity = model.parts[0].quadraticBulkViscosity = 0;
        model.control.backend = "serial";
        model.control.fixedTimeStep = 4e-8;
        const auto solver = startedSolver(model);
        double impulse = 0;
        for (int n = 0; n < 400; ++n) {
            impulse += 4e-8 * solver->contact().force(0).force[2];
            solver->advance(1, 1);
        }
        EXPECT_LT(impulse, 0);
        EXPECT_NEAR(momentum(*solver)[2], impulse, 1e-9 * std::abs(impulse));
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.002);
    }
}

/// One brick, almost rigid beside its soft contact springs, thrown against the wall.
TEST(RigidSurface, ContactDampingSetsTheReboundAndIsBooked)
{
    for (const double zeta : {0.0, 0.1, 0.3}) {
        Model model;
        addBox(model.mesh, "block", {1, 1, 1}, {0, 0, 1e-9}, {1, 1, 1});
        renumber(model.mesh);
        Part part = aluminium(PartKind::elastic, HourglassForm::stiffness, "block");
        part.poissonsRatio = 0;
        model.parts = {part};
        ContactPair& pair =
            press(model, facing(model.mesh, "block", {0, 0, -1}), plane({0, 0, 0}, {0, 0, 1}));
        pair.enforcement = Enforcement::penalty;
        pair.normalScale = 1e-3;
        pair.tangentialScale = 1e-4;
        pair.normalDamping = zeta;
        model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "block"), {0, 0, -1e3}});
        model.control.backend = "serial";
        model.control.endTime = 1;
        const auto solver = startedSolver(model);
        solver->advance(1e-4, 1000000);
        // Four of eight nodes have dampers: zeta / sqrt(2) for the brick. The spring may not pull.
        const double z = zeta / std::sqrt(2.0), root = std::sqrt(1 - z * z);
        const double exact = std::exp(-z * (M_PI - std::atan2(2 * z * root, 1 - 2 * z * z)) / root);
        EXPECT_EQ(solver->contact().force(0).active, 0);
        EXPECT_NEAR(momentum(*solver)[2] / (2.7e-9 * 1e3), exact, 0.01) << zeta;
        const Energies e = solver->ledger().energies();
        EXPECT_LT(std::abs(e.balance), 0.001);
        EXPECT_NEAR(e.contactDamping, 0.5 * 2.7e-9 * 1e6 * (1 - exact * exact),
                    0.02 * 0.5 * 2.7e-9 * 1e6);
    }
}

std::uint64_t stateAfter(Model model, const std::string& backend, int threads, const char* simd)
{
    model.control.backend = backend;
    model.control.threads = threads;
    model.control.simd = simd;
    const auto solver = startedSolver(model);
    solver->advance(1, 200);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_GT(solver->contact().force(0).active, 0);
    EXPECT_GT(solver->ledger().energies().friction, 0);
    return stateChecksum(*solver);
}

TEST(RigidSurface, BitsAreTheSameOnEveryBackend)
{
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single})
        for (const Enforcement enforcement : {Enforcement::kinematic, Enforcement::penalty}) {
            Model model = vice(0.3);
            for (RigidSurface& die : model.rigidSurfaces) {
                die.amplitude.rows[1][0] = 4e-6;
                die.value[0] = 0.3;
            }
            for (ContactPair& pair : model.contactPairs) {
                pair.dynamicFriction = 0.2;
                pair.frictionDecay = 1e-5;
                pair.enforcement = enforcement;
                pair.normalDamping = 0.1;
            }
            model.control.precision = precision;
            const std::uint64_t serial = stateAfter(model, "serial", 1, "scalar");
            EXPECT_EQ(stateAfter(model, "serial", 1, "avx2"), serial);
            if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
                EXPECT_EQ(stateAfter(model, "serial", 1, "avx512"), serial);
            }
            EXPECT_EQ(stateAfter(model, "openmp", 3, "auto"), serial);
        }
}

} // namespace
} // namespace fpm::test
