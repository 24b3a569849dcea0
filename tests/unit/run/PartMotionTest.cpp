#include "run/PartMotion.h"

#include "io/Table.h"
#include "run/Histories.h"
#include "support/TemporaryFolder.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

PartMotionValues motionOf(Solver& solver, const Model& model, Index part = 0)
{
    return PartMotion(solver, model.mesh, part).of(solver);
}

/// A block of 3 x 4 x 5 mm, 1.62e-7 t, that flies and turns about its centre.
Model flying(Part part)
{
    part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    Model model = boxModel({3, 4, 5}, {3, 4, 5}, part);
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const Point& p = model.mesh.points[i];
        model.initialVelocities.push_back(
            {"", {Index(i)}, {3e4 - 2e3 * (p[1] - 2), -7e4 + 2e3 * (p[0] - 1.5), 1e5}});
    }
    return model;
}

TEST(PartMotion, AFreeBodyKeepsItsMomentaAndItsCentreMovesEvenly)
{
    const Model model =
        flying(aluminium(PartKind::elastic, HourglassForm::physical)); // 2.7e-9 t/mm3
    const auto solver = startedSolver(model);
    const double mass = 2.7e-9 * 60;
    const PartMotionValues first = motionOf(*solver, model);
    const Point centre{1.5, 2, 2.5}, velocity{3e4, -7e4, 1e5};
    // Of masses at the nodes.
    double inertia = 0;
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const Point& p = model.mesh.points[i];
        inertia += solver->nodes().setUp().mass[i]
                   * ((p[0] - 1.5) * (p[0] - 1.5) + (p[1] - 2) * (p[1] - 2));
    }
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(first.centre[c], centre[c], 1e-13);
        EXPECT_NEAR(first.momentum[c], mass * velocity[c], 1e-12 * mass * 1e5);
    }
    EXPECT_NEAR(first.angularMomentum[2], 2e3 * inertia, 1e-12 * 2e3 * inertia);
    EXPECT_NEAR(first.angularMomentum[0], 0, 1e-12 * 2e3 * inertia);
    EXPECT_NEAR(first.kinetic, 0.5 * mass * 1.58e10 + 0.5 * inertia * 4e6, 1e-12 * mass * 1.58e10);

    solver->advance(2e-5, 1000000);

    const PartMotionValues last = motionOf(*solver, model);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(last.momentum[c], first.momentum[c], 1e-11 * mass * 1e5);
        EXPECT_NEAR(last.centre[c], centre[c] + 2e-5 * velocity[c], 1e-11);
        EXPECT_NEAR(last.angularMomentum[c], first.angularMomentum[c], 1e-6 * 2e3 * inertia);
    }
}

TEST(PartMotion, AFallingBodyGainsItsWeightTimesTheTime)
{
    Model model =
        boxModel({2, 2, 2}, {2, 2, 2}, aluminium(PartKind::elastic, HourglassForm::physical));
    BoundaryCondition load = condition(BoundaryCondition::Kind::gravity, "gravity", {},
                                       {true, true, true}, {100, 0, -9810});
    load.parts = {0};
    for (Index node = 0; node < Index(model.mesh.points.size()); ++node) load.nodes.push_back(node);
    model.boundaryConditions.push_back(load);
    const auto solver = startedSolver(model);
    solver->advance(1e-4, 1000000);
    const double mass = 2.7e-9 * 8;
    const PartMotionValues motion = motionOf(*solver, model);
    EXPECT_NEAR(motion.momentum[2], -mass * 9810 * 1e-4, 1e-9 * mass);
    EXPECT_NEAR(motion.momentum[0], mass * 100 * 1e-4, 1e-9 * mass);
    EXPECT_NEAR(motion.centre[2], 1 - 0.5 * 9810 * 1e-8, 1e-7);
}

TEST(PartMotion, PartsThatShareNodesShareTheirMass)
{
    // Two cubes of one mesh with a face in common, the upper one twice as dense.
    Model model;
    addBox(model.mesh, "lower", {1, 1, 1}, {0, 0, 0}, {1, 1, 1});
    Mesh& mesh = model.mesh;
    for (const double y : {0.0, 1.0})
        for (const double x : {0.0, 1.0}) mesh.points.push_back({x, y, 2});
    const Hexahedron low = mesh.hexahedra[0];
    const auto above = [&](double x, double y) { return Index(8 + 2 * int(y) + int(x)); };
    mesh.hexahedra.push_back(
        {low[4], low[5], low[6], low[7], above(0, 0), above(1, 0), above(1, 1), above(0, 1)});
    mesh.parts.push_back({"upper", 1, 1});
    renumber(mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::physical, "lower"),
                   aluminium(PartKind::elastic, HourglassForm::physical, "upper")};
    model.parts[1].density *= 2;
    std::vector<Index> all;
    for (Index node = 0; node < Index(mesh.points.size()); ++node) all.push_back(node);
    model.initialVelocities.push_back({"", all, {0, 0, 1e4}});
    model.control.backend = "serial";
    model.control.endTime = 1;
    const auto solver = startedSolver(model);
    EXPECT_NEAR(motionOf(*solver, model, 0).momentum[2], 2.7e-5, 1e-17);
    EXPECT_NEAR(motionOf(*solver, model, 1).momentum[2], 5.4e-5, 1e-17);
    EXPECT_NEAR(motionOf(*solver, model, 1).centre[2], 1.5, 1e-14);
}

TEST(PartMotion, OfARigidBodyItIsTheStateOfTheBody)
{
    Part part = aluminium(PartKind::rigidFree, HourglassForm::physical);
    part.inertia.mass = 3e-6;
    Model model = boxModel({3, 4, 5}, {3, 4, 5}, part);
    model.control.fixedTimeStep = 1e-7;
    InitialVelocity initial;
    initial.nodes = nodesOfPart(model.mesh, model.parts[0].name);
    initial.part = 0;
    initial.velocity = {0, 50, 0};
    model.initialVelocities.push_back(initial);
    const auto solver = startedSolver(model);
    solver->advance(1e-5, 1000000);
    const PartMotionValues motion = motionOf(*solver, model);
    EXPECT_NEAR(motion.momentum[1], 3e-6 * 50, 1e-18);
    EXPECT_NEAR(motion.centre[1], 2 + 50e-5, 1e-12);
    EXPECT_NEAR(motion.kinetic, 0.5 * 3e-6 * 2500, 1e-15);
}

TEST(PartMotion, IsTheSameToTheLastBitHoweverItIsRun)
{
    const Model model = flying(aluminium(PartKind::elastoplastic, HourglassForm::physical));
    const auto run = [&](const std::string& backend, int threads, const std::string& simd) {
        Model copy = model;
        copy.control.backend = backend;
        copy.control.threads = threads;
        copy.control.simd = simd;
        const auto solver = startedSolver(copy);
        solver->advance(1, 100);
        const PartMotionValues motion = motionOf(*solver, copy);
        return std::tuple(motion.centre, motion.momentum, motion.angularMomentum, motion.kinetic);
    };
    EXPECT_EQ(run("serial", 1, "scalar"), run("openmp", 2, "auto"));
}

TEST(PartMotion, IsAHistoryWithUnits)
{
    Model model = flying(aluminium(PartKind::elastic, HourglassForm::physical));
    model.units = {"mm", "tonne", "s"};
    History history;
    history.name = "block";
    history.kind = History::Kind::part;
    history.part = 0;
    model.control.histories = {history};
    const auto solver = startedSolver(model);
    const TemporaryFolder folder;
    Log log = Log::quiet();
    Histories histories(OutputFolder(folder.path()), model, "", {}, log);
    histories.sample(*solver, Sample(*solver, model));
    const auto file = folder / "postProcessing/block/0/part.dat";
    const Table table = readTable(file);
    EXPECT_EQ(table.columns, (std::vector<std::string>{"time", "cx", "cy", "cz", "px", "py", "pz",
                                                       "lx", "ly", "lz", "kinetic"}));
    ASSERT_EQ(table.rows.size(), 1U);
    EXPECT_NEAR(table.rows[0][6], 2.7e-9 * 60 * 1e5, 1e-14);
    EXPECT_NE(readBytes(file).find("unit s mm mm mm N*s N*s N*s N*mm*s N*mm*s N*mm*s mJ"),
              std::string::npos);
}

} // namespace
} // namespace fpm::test
