#include "kernels/contact/ContactPassView.h"
#include "solver/contact/SurfaceErosion.h"
#include "unit/solver/kindScenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

Index elementAt(const Mesh& mesh, Point place)
{
    Index nearest = -1;
    double best = 1e300;
    for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
        double square = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            double centre = 0;
            for (const Index node : mesh.hexahedra[e])
                centre += mesh.points[std::size_t(node)][c] / 8;
            square += (centre - place[c]) * (centre - place[c]);
        }
        if (square < best) {
            best = square;
            nearest = Index(e);
        }
    }
    return nearest;
}

Model layers(double speed, double limit)
{
    // A stiff stamp through a soft plate of two elements onto a base.
    Model model;
    addBox(model.mesh, "base", {6, 6, 2}, {-3, -3, -3.1}, {6, 6, 2});
    addBox(model.mesh, "plate", {6, 6, 2}, {-3, -3, -1}, {6, 6, 1});
    addBox(model.mesh, "stamp", {3, 3, 4}, {-0.9, -0.9, 0.01}, {1.8, 1.8, 4});
    renumber(model.mesh, 32);
    Part soft = aluminium(PartKind::elastoplastic, HourglassForm::stiffness, "plate");
    soft.erosion.plasticStrain = limit;
    soft.erosion.inverted = true;
    Part stiff = aluminium(PartKind::elastic, HourglassForm::stiffness, "stamp");
    stiff.youngsModulus = 210000;
    stiff.density = 7.85e-9;
    model.parts = {aluminium(PartKind::elastic, HourglassForm::stiffness, "base"), soft, stiff};
    holdFixed(model, nodesWhere(model.mesh, [](Point p) {
                  return p[2] < -3.09 || (p[2] < 0.001 && std::abs(p[0]) > 2.99 && p[2] > -1.01);
              }));
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "stamp"), {0, 0, -speed}});
    addContact(model, "stampPlate", facing(model.mesh, "stamp", {0, 0, -1}),
               facing(model.mesh, "plate", {0, 0, 1}));
    addContact(model, "stampBase", facing(model.mesh, "stamp", {0, 0, -1}),
               facing(model.mesh, "base", {0, 0, 1}));
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

} // namespace

TEST(ErosionSurfaces, WhatADeletedElementCoveredJoinsTheSurface)
{
    Model model = layers(1e5, 0.1);
    const Mesh& mesh = model.mesh;
    const SurfaceErosion erosion(model);
    std::vector<bool> deleted(mesh.hexahedra.size(), false);
    const std::vector<ElementSide> top = facing(mesh, "plate", {0, 0, 1});
    EXPECT_EQ(erosion.renewedSides(top, deleted), top);

    // One element of the upper row: its side leaves, four walls and a floor join.
    const Index upper = elementAt(mesh, {-0.5, -0.5, -0.25}),
                lower = elementAt(mesh, {-0.5, -0.5, -0.75});
    deleted[std::size_t(upper)] = true;
    std::vector<ElementSide> sides = erosion.renewedSides(top, deleted);
    EXPECT_EQ(sides.size(), top.size() - 1 + 5);
    const auto holds = [&](Index element, Point direction) {
        return std::ranges::any_of(sides, [&](const ElementSide& side) {
            const Point n = normal(mesh, side);
            return side.element == element
                   && n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2] > 0.9;
        });
    };
    EXPECT_TRUE(holds(lower, {0, 0, 1}));
    EXPECT_TRUE(holds(elementAt(mesh, {0.5, -0.5, -0.25}), {-1, 0, 0}));

    // The one below as well: the hole goes through, eight walls.
    deleted[std::size_t(lower)] = true;
    sides = erosion.renewedSides(top, deleted);
    EXPECT_EQ(sides.size(), top.size() - 1 + 8);
    EXPECT_FALSE(holds(lower, {0, 0, 1}));

    // An element of the lower row alone is not in contact with the top.
    deleted[std::size_t(upper)] = false;
    EXPECT_EQ(erosion.renewedSides(top, deleted), top);
}

TEST(ErosionSurfaces, OnlyWhatChangedIsTakenAnew)
{
    Model model = layers(1e5, 0.1);
    SolverSetUp data = makeSetUp(model);
    SurfaceErosion erosion(model);
    std::vector<bool> deleted(model.mesh.hexahedra.size(), false);
    EXPECT_FALSE(erosion.renewContact(data, deleted));
    const ContactPassSetup before = data.contact.passes[0];
    deleted[std::size_t(elementAt(model.mesh, {-0.5, -0.5, -0.25}))] = true;
    EXPECT_TRUE(erosion.renewContact(data, deleted));
    EXPECT_FALSE(erosion.renewContact(data, deleted));
    const PassRenewal renewal = compared(before, data.contact.passes[0]);
    EXPECT_EQ(data.contact.passes[0].faceThickness.size(), before.faceThickness.size() + 4);
    EXPECT_EQ(std::ranges::count(renewal.face, -1), 1);
    for (std::size_t i = 0; i < renewal.contactor.size(); ++i)
        EXPECT_EQ(renewal.contactor[i], Index(i));
    // A surface of which nothing is left has no contactors.
    for (Index e = 0; e < data.elements.count; ++e)
        if (model.mesh.partOf(e) == model.mesh.findPart("plate")) deleted[std::size_t(e)] = true;
    EXPECT_TRUE(erosion.renewContact(data, deleted));
    EXPECT_TRUE(data.contact.passes[0].contactor.empty());
    EXPECT_FALSE(data.contact.passes[1].contactor.empty());
}

TEST(ErosionSurfaces, PlanesOfSymmetryStay)
{
    Model model = layers(1e5, 0.1);
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::fixed, "mirror",
                  nodesWhere(model.mesh, [](Point p) { return std::abs(p[0] - 3) < 1e-9; }),
                  {true, false, false}));
    model.boundaryConditions.back().mirror = true;
    SolverSetUp data = makeSetUp(model);
    const auto mirrored = [](const ContactPassSetup& pair) {
        return std::ranges::count(pair.neighbour, mirrorEdge(0));
    };
    EXPECT_EQ(mirrored(data.contact.passes[0]), 6); // of the plate's top
    SurfaceErosion erosion(model);
    std::vector<bool> deleted(model.mesh.hexahedra.size(), false);
    deleted[std::size_t(elementAt(model.mesh, {2.5, -0.5, -0.25}))] = true; // on the plane
    EXPECT_TRUE(erosion.renewContact(data, deleted));
    EXPECT_EQ(mirrored(data.contact.passes[0]),
              6 + 2); // its side is replaced by a floor and two walls
}

// The stamp goes through the plate, whose elements disappear one after the other, and lands on the
// base: momentum and energy are kept, and contact goes on with what is left.
TEST(Erosion, AStampGoesThroughAPlateAndLandsOnTheBase)
{
    const Model model = layers(4e5, 0.3);
    const auto solver = startedSolver(model);
    const std::size_t faces = solver->contact().setUp().passes[0].faceThickness.size();
    double worst = 0, early = 0, late = 0, base = 0;
    const std::vector<Index> stamp = nodesOfPart(model.mesh, "stamp");
    const double start = momentum(*solver, stamp)[2];
    for (int call = 0; call < 200 && !solver->clock().failed; ++call) {
        solver->advance(2.5e-5, 10);
        worst = std::max(worst, std::abs(solver->ledger().energies().balance));
        const double force = solver->contact().force(0).force[2];
        if (solver->clock().deletions == 0)
            early = std::max(early, force);
        else
            late = std::max(late, force);
        base = std::max(base, solver->contact().force(1).force[2]);
    }
    ASSERT_FALSE(solver->clock().failed);
    EXPECT_GT(solver->clock().deletions, 0);
    EXPECT_GT(early, 0);
    EXPECT_GT(late, 0.1 * early); // contact with the plate goes on after the first deletion
    EXPECT_GT(base, 0);
    EXPECT_NE(solver->contact().setUp().passes[0].faceThickness.size(), faces);
    EXPECT_GT(momentum(*solver, stamp)[2], start);
    EXPECT_LT(worst, 0.01);
    const ElementValues values = solver->elements().values();
    double eroded = 0;
    int rows[2] = {0, 0};
    for (std::size_t e = 0; e < values.deleted.size(); ++e) {
        eroded += values.eroded[e];
        if (!values.deleted[e]) continue;
        double height = 0;
        for (const Index node : model.mesh.hexahedra[e])
            height += model.mesh.points[std::size_t(node)][2] / 8;
        ++rows[height > -0.5];
        EXPECT_GT(values.plasticStrain[e], 0);
        for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(values.stress[6 * e + k], 0);
    }
    EXPECT_GT(eroded, 0);
    EXPECT_LT(eroded, solver->ledger().energies().internal);
    EXPECT_GT(rows[0], 0);
    EXPECT_GT(rows[1], 0);
}

// Nodes that patches move themselves become contactors when what covered them is deleted.
TEST(Erosion, WhoMovesTheNodesOfAPatchDoesNotChangeTheState)
{
    Model model = layers(4e5, 0.3);
    const auto patch = startedSolver(model);
    model.control.assembly = Assembly::gather;
    const auto gather = startedSolver(model);
    const std::size_t listed = patch->nodes().setUp().listed.size();
    patch->advance(1, 800);
    gather->advance(1, 800);
    EXPECT_GT(patch->nodes().setUp().listed.size(), listed);
    EXPECT_EQ(stateChecksum(*patch), stateChecksum(*gather));
}

TEST(Erosion, TheTimeStepIsNotLimitedByDeletedElements)
{
    Part part = aluminium(PartKind::elastoplastic, HourglassForm::stiffness);
    part.erosion.plasticStrain = 0.01;
    Model model = boxModel({2, 1, 1}, {2, 1, 1}, part);
    // The left cell is crushed to a tenth, the right one is left alone.
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::velocity, "crush",
                  nodesWhere(model.mesh, [](Point p) { return p[0] < 1e-9; }), {true, true, true},
                  {1e4, 0, 0}));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] > 1e-9; }));
    const auto solver = startedSolver(model);
    const double first = [&] {
        solver->advance(1, 2);
        return solver->clock().elementStep;
    }();
    solver->advance(9e-5, 1000000);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_GE(solver->clock().elementStep, first);
    const ElementValues values = solver->elements().values();
    EXPECT_EQ(std::ranges::count(values.deleted, true), 1);
}

/// Faces of unequal stiffness have springs that keep their stiffness; when the odd one is deleted,
/// the rest are equal and need no memory.
TEST(Erosion, FacesMayBecomeAlike)
{
    Part part = aluminium(PartKind::elastoplastic, HourglassForm::stiffness);
    part.erosion.plasticStrain = 0.01;
    Model model = boxModel({2, 1, 1}, {2, 1, 1}, part);
    for (Point& p : model.mesh.points)
        if (p[0] < 1e-9) p[0] = 0.2; // the left cell is narrower, the right one a cube
    addBox(model.mesh, "lid", {2, 2, 1}, {1.2, 0.1, 0.99}, {0.7, 0.8, 0.5});
    renumber(model.mesh);
    model.parts.push_back(aluminium(PartKind::elastic, HourglassForm::stiffness, "lid"));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::velocity, "crush",
                  nodesWhere(model.mesh, [](Point p) { return p[0] < 0.21; }), {true, true, true},
                  {1e4, 0, 0}));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] > 0.21; }));
    addContact(model, "touch", facing(model.mesh, "lid", {0, 0, -1}),
               facing(model.mesh, "box", {0, 0, 1}));
    model.control.backend = "serial";
    const auto solver = startedSolver(model);
    EXPECT_TRUE(solver->contact().setUp().passes[0].unequalFaces);
    solver->advance(1, 2);
    const PairForce before = solver->contact().force(0);
    EXPECT_EQ(before.active, 9);
    solver->advance(9e-5, 1000000);
    ASSERT_EQ(std::ranges::count(solver->elements().values().deleted, true), 1);
    EXPECT_FALSE(solver->contact().setUp().passes[0].unequalFaces);
    EXPECT_EQ(solver->contact().force(0).active, 9);
    EXPECT_NEAR(solver->contact().force(0).force[2], before.force[2], 1e-9 * before.force[2]);
}

/// `layers` in general contact with friction and damping.
Model generalLayers(PartKind stamp)
{
    Model model = layers(4e5, isRigid(stamp) ? 0.02 : 0.3); // the body is light
    model.parts[2].kind = stamp;
    if (isRigid(stamp)) model.parts[2].inertia = {4e-9, false, true, {}, {1e-9, 1e-9, 1e-9}};
    model.initialVelocities[0].part = 2;
    model.contactPairs.clear();
    model.mesh.contact.clear();
    ContactPair& pair = addGeneral(model);
    pair.friction = 0.3;
    pair.normalDamping = 0.1;
    return model;
}

/// In general contact a deletion changes contactors and targets alike, and the slots of nodes that
/// touch several bodies; what friction and damping have taken stays booked.
TEST(Erosion, GoesOnInGeneralContactWithFriction)
{
    for (const auto& [stamp, edges] : {std::pair{PartKind::elastic, false},
                                       {PartKind::rigidFree, false},
                                       {PartKind::elastic, true}}) {
        Model model = generalLayers(stamp);
        model.contactPairs[0].edges = edges;
        const auto solver = startedSolver(model);
        double friction = 0, damping = 0;
        std::int64_t deletions = 0;
        int byBody = 0; // deletions while the rigid body bounds the step
        for (int call = 0; call < 400 && !solver->clock().failed; ++call) {
            solver->advance(2.5e-5, 1);
            const Energies e = solver->ledger().energies();
            EXPECT_LT(std::abs(e.balance), 0.01);
            // Lagged by half a step damping may give back a little, never what is booked.
            EXPECT_GE(e.friction, 0.999 * friction);
            EXPECT_GE(e.contactDamping, 0.999 * damping);
            friction = e.friction;
            damping = e.contactDamping;
            // The bound of the next step is that of the contact springs of now, bodies included.
            const ContactBound limit = solver->contact().bound();
            const bool renewed = solver->clock().deletions != deletions;
            byBody += renewed && limit.part == 2;
            deletions = solver->clock().deletions;
            solver->advance(2.5e-5, 1);
            if (solver->clock().time < 2.5e-5) {
                EXPECT_NEAR(limit.frequency, solver->clock().contactFrequency,
                            (renewed ? 1e-9 : 1e-15) * limit.frequency);
            }
        }
        ASSERT_FALSE(solver->clock().failed);
        EXPECT_GT(deletions, 0);
        EXPECT_GT(friction, 0);
        EXPECT_GT(damping, 0);
        EXPECT_EQ(byBody > 0, stamp == PartKind::rigidFree);
    }
}

/// An eroding body on a moving plane: the plane and its amplitude are entered once, and what the
/// plane has done stays booked for contactors that are none any more.
TEST(Erosion, GoesOnAgainstAMovingPlane)
{
    Model model;
    addBox(model.mesh, "block", {3, 3, 4}, {0, 0, 0}, {3, 3, 4});
    renumber(model.mesh, 32);
    Part part = aluminium(PartKind::elastoplastic, HourglassForm::stiffness, "block");
    part.erosion.plasticStrain = 0.2;
    model.parts = {part};
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] > 3.99; }));
    RigidSurface plane;
    plane.name = "plane";
    plane.axis = {0, 0, 1};
    plane.motion = RigidSurface::Motion::displacement;
    plane.value = {0, 0, 2};
    plane.amplitude = {Amplitude::Kind::table, {{0, 0}, {4e-5, 1}}};
    addContact(model, "touch", skin(model.mesh, 0), {}).surface = 0;
    model.contactPairs[0].friction = 0.2;
    model.rigidSurfaces = {plane};
    model.control.backend = "serial";
    const auto solver = startedSolver(model);
    const std::size_t rows = solver->nodes().setUp().amplitudeRows.size(),
                      contactors = solver->contact().setUp().passes[0].contactor.size();
    double work = 0;
    for (int call = 0; call < 100 && solver->clock().time < 4e-5; ++call) {
        solver->advance(4e-5, 10);
        ASSERT_FALSE(solver->clock().failed);
        const Energies e = solver->ledger().energies();
        EXPECT_LT(std::abs(e.balance), 0.01);
        EXPECT_GE(e.external, 0.99 * work); // it never springs back much
        work = e.external;
    }
    EXPECT_GT(solver->clock().deletions, 0);
    EXPECT_EQ(solver->contact().setUp().surfaces.size(), 1u);
    EXPECT_EQ(solver->nodes().setUp().amplitudeRows.size(), rows);
    EXPECT_NE(solver->contact().setUp().passes[0].contactor.size(), contactors);
    EXPECT_GT(work, 0);
}

/// A side that is gone bears no pressure: nodes that are left without elements do not fly off.
TEST(Erosion, PressureEndsWithTheElementItActsOn)
{
    Part part = aluminium(PartKind::elastoplastic, HourglassForm::stiffness);
    part.erosion.plasticStrain = 0.01;
    Model model = boxModel({2, 1, 1}, {2, 1, 1}, part);
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::velocity, "crush",
                  nodesWhere(model.mesh, [](Point p) { return p[0] < 1e-9; }), {true, true, true},
                  {1e4, 0, 0}));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] > 1e-9; }));
    BoundaryCondition pressure =
        condition(BoundaryCondition::Kind::pressure, "p", {}, {true, true, true}, {5, 0, 0});
    pressure.sides = facing(model.mesh, "box", {0, 0, 1});
    pressure.nodes = nodesOf(model.mesh, pressure.sides);
    model.boundaryConditions.push_back(pressure);
    const auto solver = startedSolver(model);
    const auto load = [&] { // on the two upper nodes of the left end; no contact
        const auto nodes =
            nodesWhere(model.mesh, [](Point p) { return p[0] < 1e-9 && p[2] > 0.99; });
        const NodeValues values = solver->nodes().values(nodes);
        return values.at(3, 0)[2] + values.at(3, 1)[2];
    };
    EXPECT_NEAR(load(), -2.5, 1e-9);
    solver->advance(9e-5, 1000000);
    ASSERT_EQ(std::ranges::count(solver->elements().values().deleted, true), 1);
    EXPECT_EQ(load(), 0);
    EXPECT_NEAR(
        solver->nodes()
            .values(nodesWhere(model.mesh,
                               [](Point p) { return p[0] > 1.99 && p[1] < 0.01 && p[2] > 0.99; }))
            .at(3, 0)[2],
        -1.25, 0.3); // the right one still has it
}

} // namespace fpm::test
