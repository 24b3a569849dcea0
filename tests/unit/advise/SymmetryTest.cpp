#include "advise/Symmetry.h"

#include "unit/advise/symmetricScene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fpm::test {
namespace {

/// Axes of the planes that were found, and where.
std::vector<std::pair<std::size_t, double>> planesOf(const Model& model)
{
    std::vector<std::pair<std::size_t, double>> planes;
    for (const MirrorMap& map : findSymmetry(model))
        if (map.holds()) planes.push_back({map.plane.axis, map.plane.place});
    return planes;
}

using Planes = std::vector<std::pair<std::size_t, double>>;
const Planes both{{0, 0.0}, {1, 1.0}}, onlyX{{0, 0.0}}, onlyY{{1, 1.0}}, none{};

BoundaryCondition& named(Model& model, const std::string& name)
{
    for (BoundaryCondition& condition : model.boundaryConditions)
        if (condition.name == name) return condition;
    throw std::logic_error(name);
}

Index nodeAt(const Model& model, Point place)
{
    return nodesWhere(model.mesh, [&](Point p) { return p == place; }).front();
}

} // namespace

TEST(Symmetry, FindsBothPlanesOfASymmetricScene)
{
    const Model model = symmetricScene();
    EXPECT_EQ(planesOf(model), both);
    const auto maps = findSymmetry(model);
    EXPECT_NE(maps[2].obstacle.find("has no mirror image"), std::string::npos);
    for (std::size_t node = 0; node < model.mesh.points.size(); ++node) {
        const Point image = model.mesh.points[std::size_t(maps[0].node[node])];
        EXPECT_EQ(image[0], -model.mesh.points[node][0]);
        EXPECT_EQ(image[1], model.mesh.points[node][1]);
    }
}

TEST(Symmetry, OneMovedNodeIsAnImperfectionThatWasMeant)
{
    Model model = symmetricScene();
    model.mesh.points[std::size_t(nodeAt(model, {1, 0.5, 1}))][2] += 1e-6;
    EXPECT_EQ(planesOf(model), none);
    model = symmetricScene();
    model.mesh.points[std::size_t(nodeAt(model, {0, 0.5, 1}))][2] += 1e-6;
    EXPECT_EQ(planesOf(model), onlyX);
}

TEST(Symmetry, AnAsymmetricLoadBreaksIt)
{
    Model model = symmetricScene();
    named(model, "weight").value = {1, 0, -8};
    EXPECT_EQ(planesOf(model), onlyY);
    model = symmetricScene();
    named(model, "weight").value = {0, 1, -8};
    EXPECT_EQ(planesOf(model), onlyX);
    model = symmetricScene();
    std::erase(named(model, "weight").nodes, nodeAt(model, {1, 0.5, 1}));
    EXPECT_EQ(planesOf(model), none);
}

TEST(Symmetry, ConditionsOnTheTwoSidesMustMirrorEachOther)
{
    Model model = symmetricScene();
    named(model, "left").value = {-4, 0, 0};
    EXPECT_EQ(planesOf(model), onlyY);
    model = symmetricScene();
    named(model, "left").value = {5, 0, 0}; // a translation, no mirror image
    EXPECT_EQ(planesOf(model), onlyY);
    model = symmetricScene();
    named(model, "left").amplitude = {Amplitude::Kind::table, {{0, 0}, {1, 1}}};
    EXPECT_EQ(planesOf(model), onlyY);
}

TEST(Symmetry, AnAsymmetricInitialVelocityBreaksIt)
{
    Model model = symmetricScene();
    model.initialVelocities[0].velocity = {0, 1e-3, -1e3};
    EXPECT_EQ(planesOf(model), onlyX);
    model = symmetricScene();
    InitialVelocity spin = model.initialVelocities[0];
    spin.rotates = true;
    spin.velocity = {0, 0, 0};
    spin.centre = {0, 1, 0.5};
    spin.spin = {10, 0, 0}; // about the normal of x = 0
    model.initialVelocities.push_back(spin);
    EXPECT_EQ(planesOf(model), onlyX);
}

TEST(Symmetry, RotationsAboutTheNormalAloneAreMirrored)
{
    Model model = symmetricScene();
    BoundaryCondition& turn = named(model, "ground");
    turn.kind = BoundaryCondition::Kind::rotation;
    turn.angle = 3;
    turn.line = {Point{7, 1, -1}, Point{1, 0, 0}};
    EXPECT_EQ(planesOf(model), onlyX);
    turn.line = {Point{0, 1, -1}, Point{0, 0, 1}};
    EXPECT_EQ(planesOf(model), none);
    turn.line = {Point{0, 2, -1}, Point{0, 1, 0}}; // its axis crosses y = 1
    EXPECT_EQ(planesOf(model), onlyY);
}

TEST(Symmetry, GravityOfOnePartIsNotThatOfAnother)
{
    Model model = symmetricScene();
    BoundaryCondition pull;
    pull.kind = BoundaryCondition::Kind::gravity;
    pull.name = "first";
    pull.constrains = {true, true, true};
    pull.value = {7, 0, 0};
    pull.parts = {0};
    model.boundaryConditions.push_back(pull);
    pull.name = "second";
    pull.value = {-7, 0, 0};
    pull.parts = {1};
    model.boundaryConditions.push_back(pull);
    EXPECT_EQ(planesOf(model), onlyY);
}

TEST(Symmetry, ContactSurfacesMustMirrorThemselves)
{
    Model model = symmetricScene();
    const ElementSide corner = model.contactPairs[0].targetSides.front();
    std::erase(model.contactPairs[0].targetSides, corner);
    EXPECT_EQ(planesOf(model), none);
    model = symmetricScene();
    model.contactPairs[0].kind = ContactKind::general;
    EXPECT_EQ(planesOf(model), none);
}

TEST(Symmetry, AnalyticSurfacesMustMirrorThemselves)
{
    Model model = symmetricScene();
    RigidSurface ball;
    ball.kind = RigidSurface::Kind::sphere;
    ball.point = {0, 1, -3};
    model.rigidSurfaces = {ball};
    model.contactPairs[0].surface = 0;
    EXPECT_EQ(planesOf(model), both);
    model.rigidSurfaces[0].point = {0, 1.5, -3};
    EXPECT_EQ(planesOf(model), onlyX);
    model.rigidSurfaces[0].kind = RigidSurface::Kind::plane;
    model.rigidSurfaces[0].axis = {0, 0.6, 0.8};
    EXPECT_EQ(planesOf(model), onlyX);
    model.rigidSurfaces[0].axis = {0, 0, 1};
    model.rigidSurfaces[0].motion = RigidSurface::Motion::velocity;
    model.rigidSurfaces[0].value = {3, 0, 1};
    EXPECT_EQ(planesOf(model), onlyY);
}

TEST(Symmetry, FormulationsWithPreferredDirectionsAreNotTrusted)
{
    Model model = symmetricScene();
    model.parts[0].rotation = RotationForm::arcsine;
    EXPECT_EQ(planesOf(model), none);
    // One element whose zeta lies along x while that of its image is along z.
    for (const auto& [rotation, planes] :
         {std::pair{RotationForm::midSurface, onlyY}, std::pair{RotationForm::polar, both}}) {
        model = symmetricScene();
        model.parts[1].rotation = rotation;
        for (Hexahedron& nodes : model.mesh.hexahedra) {
            const Point first = model.mesh.points[std::size_t(nodes[0])];
            if (first[0] != -1 || first[2] < 0) continue;
            const Hexahedron old = nodes;
            for (std::size_t i = 0; i < 8; ++i)
                nodes[i] = old[std::array{0UL, 3UL, 7UL, 4UL, 1UL, 2UL, 6UL, 5UL}[i]];
        }
        model.contactPairs.clear(); // its sides have other numbers now
        model.mesh.contact.clear();
        EXPECT_EQ(planesOf(model), planes);
    }
}

TEST(Symmetry, AnOddNumberOfElementsCannotBeCut)
{
    Model model;
    model.mesh = boxMesh({3, 2, 1});
    renumber(model.mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::stiffness)};
    const auto maps = findSymmetry(model);
    EXPECT_NE(maps[0].obstacle.find("passes through 2 elements"), std::string::npos);
    EXPECT_TRUE(maps[1].holds());
    EXPECT_NE(maps[2].obstacle.find("passes through 6 elements"), std::string::npos);
}

TEST(Symmetry, HalvedBodiesKeepWhatNumbersGiveThem)
{
    Model model = symmetricScene();
    model.parts[1].kind = PartKind::rigidFree;
    EXPECT_EQ(planesOf(model), none); // its nodes are contactors
    model.contactPairs.clear();
    EXPECT_EQ(planesOf(model), both);
    model.parts[1].inertia.mass = 1;
    EXPECT_EQ(planesOf(model), none);
}

} // namespace fpm::test
