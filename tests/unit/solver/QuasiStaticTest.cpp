#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

// Mass scaling and dynamic relaxation.

namespace fpm::test {
namespace {

Part bare(HourglassForm form = HourglassForm::physical)
{
    Part part = aluminium(PartKind::elastic, form);
    part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    return part;
}

TEST(MassScaling, AFactorSlowsEverythingByItsRoot)
{
    const auto stepOf = [](double factor) {
        Part part = bare();
        part.massFactor = factor;
        const auto solver = startedSolver(boxModel({4, 2, 2}, {4, 2, 2}, part));
        solver->advance(1, 1);
        return solver->clock().step;
    };
    EXPECT_NEAR(stepOf(100) / stepOf(1), 10, 1e-9);
}

/// Mass times f is time times sqrt(f): with a power of four the very same numbers, hourglass and
/// bulk viscosity included.
TEST(MassScaling, IsTheSameMotionMoreSlowly)
{
    for (const HourglassForm form :
         {HourglassForm::stiffness, HourglassForm::viscous, HourglassForm::physical})
        for (const HexahedronForm element : {HexahedronForm::reduced, HexahedronForm::selective}) {
            const auto after = [&](double slower) {
                Part part = aluminium(PartKind::elastoplastic, form);
                part.hexahedron = element;
                part.massFactor = slower * slower;
                Model model = boxModel({3, 3, 2}, {3, 2, 2}, part);
                model.initialVelocities.push_back(
                    {"both strained and hourglassing",
                     nodesWhere(model.mesh,
                                [](Point p) { return p[0] > 2.5 || int(p[0] + p[2]) % 2 == 0; }),
                     {0, 3e4 / slower, -8e4 / slower}});
                const auto solver = startedSolver(model);
                solver->advance(1e3, 100);
                EXPECT_FALSE(solver->clock().failed);
                EXPECT_GT(solver->ledger().energies().plastic, 0);
                return solver->nodes().values({}).values;
            };
            const std::vector<double> plain = after(1), slow = after(128);
            for (std::size_t i = 0; i < plain.size() / 5; ++i) EXPECT_EQ(slow[i], plain[i]);
        }
}

TEST(MassScaling, ATargetLiftsTheSmallElementsOnly)
{
    Model model = boxModel({4, 1, 1}, {4, 1, 1}, bare());
    for (Point& p : model.mesh.points) // edges 1 1 1 0.25
        if (p[0] == 4) p[0] = 3.25;
    const double c = std::sqrt(70000 * 0.7 / (1.3 * 0.4) / 2.7e-9);
    const double regular = 1 / (c * std::sqrt(3.0)), small = 1 / (c * std::sqrt(18.0));
    model.parts[0].targetStep = regular * 0.999;
    const auto solver = startedSolver(model);
    const ElementSetUp& elements = solver->elements().setUp();
    const NodeSetUp& nodes = solver->nodes().setUp();
    EXPECT_EQ(elements.scaled, 1u);
    double added = 0, own = 0;
    for (std::size_t i = 0; i < nodes.mass.size(); ++i) {
        added += nodes.mass[i] - nodes.ownMass[i];
        own += nodes.ownMass[i];
    }
    EXPECT_NEAR(own, 3.25 * 2.7e-9, 1e-20);
    const double ratio = regular * 0.999 / small;
    EXPECT_NEAR(added, 0.25 * 2.7e-9 * (ratio * ratio - 1), 1e-18);
    solver->advance(1, 1);
    EXPECT_NEAR(solver->clock().elementStep, regular * 0.999, 1e-9 * regular);
}

TEST(MassScaling, ATargetHoldsForSelectiveElementsToo)
{
    Part part = bare();
    part.hexahedron = HexahedronForm::selective;
    part.targetStep = 1e-6;
    part.linearBulkViscosity = 0.06;
    Model model = boxModel({3, 2, 2}, {4, 1, 1}, part);
    model.mesh.points[5][0] += 0.2;
    const auto solver = startedSolver(model);
    solver->advance(1, 1);
    EXPECT_NEAR(solver->clock().elementStep, 1e-6, 1e-12);
}

TEST(MassScaling, TheLedgerStaysClosed)
{
    Part part = bare();
    part.massFactor = 50;
    Model model = boxModel({6, 2, 2}, {6, 2, 2}, part);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] == 0; }));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::force, "load",
                  nodesWhere(model.mesh, [](Point p) { return p[0] == 6; }), {true, true, true},
                  {100, 20, -300}, {Amplitude::Kind::smooth, {{0, 0}, {1e-4, 1}}}));
    const auto solver = startedSolver(model);
    solver->advance(3e-4, 100000);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
    EXPECT_GT(solver->ledger().energies().kineticShare(), 0);
}

/// Tip of a cantilever of one element across, 40 x 2 x 2 mm, under 0.4 N.
Model cantilever()
{
    Model model = boxModel({20, 1, 1}, {40, 2, 2}, bare());
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] == 0; }));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::force, "load",
                  nodesWhere(model.mesh, [](Point p) { return p[0] == 40; }), {false, false, true},
                  {0, 0, -0.4}));
    return model;
}

double tipOf(const Model& model, Solver& solver, double length)
{
    const NodeValues values = solver.nodes().values({});
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < values.count; ++i)
        if (model.mesh.points[i][0] == length) {
            sum += values.at(0, i)[2] - model.mesh.points[i][2];
            ++count;
        }
    return sum / count;
}

TEST(DynamicRelaxation, FindsTheDeflectionOfACantilever)
{
    Model model = cantilever();
    model.control.relaxationTolerance = 1e-3;
    const auto solver = startedSolver(model);
    solver->advance(1, 100000);
    ASSERT_TRUE(solver->clock().settled);
    const double beam =
        -0.4 * 64000 / (3 * 70000 * (16.0 / 12)) - 0.4 * 40 / (70000 / 2.6 * 4 / 1.2);
    EXPECT_NEAR(tipOf(model, *solver, 40), beam, 0.012 * std::abs(beam));
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
    // Critical damping of known frequency needs 1.5 periods of the first mode to come to 1e-3.
    const double frequency = 3.516 / (40.0 * 40) * std::sqrt(70000.0 * 4 / 12 / 2.7e-9),
                 period = 2 * std::numbers::pi / frequency;
    EXPECT_LT(solver->clock().time, 2.5 * period);
    EXPECT_GT(solver->ledger().energies().damping, 0);
}

TEST(DynamicRelaxation, DoesNotEndBeforeTheLoadsAreHeld)
{
    Model model = cantilever();
    const double ramp = 8e-3;
    model.boundaryConditions.back().amplitude = {Amplitude::Kind::smooth, {{0, 0}, {ramp, 1}}};
    model.control.relaxationTolerance = 1e-3;
    const auto solver = startedSolver(model);
    solver->advance(1, 100000);
    ASSERT_TRUE(solver->clock().settled);
    EXPECT_GT(solver->clock().time, ramp);
    const double beam =
        -0.4 * 64000 / (3 * 70000 * (16.0 / 12)) - 0.4 * 40 / (70000 / 2.6 * 4 / 1.2);
    EXPECT_NEAR(tipOf(model, *solver, 40), beam, 0.012 * std::abs(beam));
}

TEST(DynamicRelaxation, DoesNotDependOnWhenTheHostReadsNorOnThreadsNorOnVectorWidth)
{
    Model model = cantilever();
    model.control.relaxationTolerance = 1e-3;
    const auto whole = startedSolver(model), parts = startedSolver(model);
    whole->advance(1, 300);
    for (int n = 0; n < 300; n += 7) parts->advance(1, std::min(7, 300 - n));
    EXPECT_EQ(stateChecksum(*whole), stateChecksum(*parts));
    model.control.backend = "openmp";
    model.control.threads = 2;
    for (const char* simd : {"scalar", "avx2"}) {
        model.control.simd = simd;
        const auto other = startedSolver(model);
        other->advance(1, 300);
        EXPECT_EQ(stateChecksum(*whole), stateChecksum(*other));
    }
}

/// The damping acts on resultants, so contact belongs to the stiffness: a block under load comes to
/// rest on another.
TEST(DynamicRelaxation, PressesTwoBlocksTogether)
{
    Model model = twoBlocks(bare(), bare(), {0, 0, 0}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::force, "load",
                  nodesWhere(model.mesh, [](Point p) { return p[2] > 5.99; }), {false, false, true},
                  {0, 0, -300}));
    model.control.relaxationTolerance = 1e-3;
    const auto solver = startedSolver(model);
    solver->advance(1, 100000);
    ASSERT_TRUE(solver->clock().settled);
    EXPECT_NEAR(solver->contact().force(0).force[2], 300, 0.3);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 5e-3);
}

/// What is held along oblique axes bears a reaction that is no force out of balance.
TEST(DynamicRelaxation, KnowsTheAxesOfItsNodes)
{
    const double c = std::cos(0.5), s = std::sin(0.5);
    Model model = boxModel({6, 1, 1}, {6, 1, 1}, bare());
    const std::vector<Index> held = nodesWhere(model.mesh, [](Point p) { return p[0] == 0; }),
                             pulled = nodesWhere(model.mesh, [](Point p) { return p[0] == 6; });
    for (Point& p : model.mesh.points) p = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
    BoundaryCondition wall =
        condition(BoundaryCondition::Kind::fixed, "wall", held, {true, false, false});
    wall.axes = {Point{c, s, 0}, Point{-s, c, 0}, Point{0, 0, 1}};
    model.boundaryConditions = {wall, condition(BoundaryCondition::Kind::force, "pull", pulled,
                                                {true, true, true}, {70 * c, 70 * s, 0})};
    model.control.relaxationTolerance = 1e-4;
    const auto solver = startedSolver(model);
    solver->advance(1, 20000);
    ASSERT_TRUE(solver->clock().settled);
    const Point end = solver->nodes().values({pulled[0]}).at(0, 0),
                start = model.mesh.points[std::size_t(pulled[0])];
    EXPECT_NEAR(c * (end[0] - start[0]) + s * (end[1] - start[1]), 6e-3, 1e-5);
}

/// A block on an elastic one, pressed by a plane that comes down slowly: it is no rest before that
/// stands still.
TEST(DynamicRelaxation, WaitsForMovingSurfaces)
{
    Model model = boxModel({2, 2, 2}, {2, 2, 2}, bare());
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] == 0; }));
    RigidSurface plane;
    plane.name = "plane";
    plane.point = {0, 0, 2};
    plane.axis = {0, 0, -1};
    plane.motion = RigidSurface::Motion::displacement;
    plane.value = {0, 0, -0.01};
    plane.amplitude = {Amplitude::Kind::table, {{0, 0}, {1e-3, 1}}};
    model.rigidSurfaces = {plane};
    addContact(model, "press", facing(model.mesh, "box", {0, 0, 1}), {}).surface = 0;
    model.control.relaxationTolerance = 1e-2;
    const auto solver = startedSolver(model);
    solver->advance(1, 100000);
    ASSERT_TRUE(solver->clock().settled);
    EXPECT_GT(solver->clock().time, 1e-3);
}

TEST(DynamicRelaxation, WaitsForTheEndOfForgivenOverlaps)
{
    Model model = twoBlocks(bare(), bare(), {0, 0, 0}, 0, -0.01);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99 || p[2] > 5.98; }));
    model.contactPairs[0].initialOverlap = InitialOverlap::ramp;
    model.contactPairs[0].rampTime = 1e-3;
    model.control.relaxationTolerance = 1e-2;
    const auto solver = startedSolver(model);
    solver->advance(1, 100000);
    ASSERT_TRUE(solver->clock().settled);
    EXPECT_GT(solver->clock().time, 1e-3);
}

/// A heavy rigid block comes to rest on an elastic one: the body's inertia and resultant count.
TEST(DynamicRelaxation, BringsARigidBodyToRest)
{
    for (const double density : {2.7e-9, 2.7e-7}) {
        Model model = twoBlocks(bare(), bare(), {0, 0, 0}, 0.3);
        model.parts[1].kind = PartKind::rigidFree;
        model.parts[1].density = density;
        holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
        model.boundaryConditions.push_back(
            condition(BoundaryCondition::Kind::force, "load",
                      nodesWhere(model.mesh, [](Point p) { return p[2] > 5.99; }),
                      {false, false, true}, {0, 0, -300}));
        model.control.relaxationTolerance = 1e-3;
        const auto solver = startedSolver(model);
        solver->advance(1, 100000);
        ASSERT_TRUE(solver->clock().settled);
        EXPECT_NEAR(solver->contact().force(0).force[2], 300, 1);
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 5e-3);
    }
}

// Elastica (Mattiasson 1981): P L^2 / E I = 1 bends the tip by 0.30172 L and draws it in by
// 0.05643 L.
TEST(DynamicRelaxation, FindsTheElastica)
{
    Part part = bare();
    part.youngsModulus = 2e5;
    part.poissonsRatio = 0;
    Model model = boxModel({40, 1, 1}, {200, 5, 5}, part);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] == 0; }));
    const double load = 2e5 * 625 / 12 / (200.0 * 200);
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::force, "load",
                  nodesWhere(model.mesh, [](Point p) { return p[0] == 200; }), {false, false, true},
                  {0, 0, -load}));
    model.control.relaxationTolerance = 1e-3;
    const auto solver = startedSolver(model);
    solver->advance(1, 400000);
    ASSERT_TRUE(solver->clock().settled);
    const NodeValues values = solver->nodes().values({});
    double x = 0;
    for (std::size_t i = 0; i < values.count; ++i)
        if (model.mesh.points[i][0] == 200) x += values.at(0, i)[0] / 4;
    EXPECT_NEAR(-tipOf(model, *solver, 200) / 200, 0.30172, 0.02 * 0.30172);
    EXPECT_NEAR(1 - x / 200, 0.05643, 0.02 * 0.05643);
}

} // namespace
} // namespace fpm::test
