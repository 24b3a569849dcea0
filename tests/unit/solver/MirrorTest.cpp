#include "base/Error.h"
#include "solver/contact/MirrorPlanes.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fpm::test {
namespace {

/// A block that strikes another one askew, in a plane x = 0 of mirror symmetry: whole, or its half
/// x >= 0. Nodes lie on the plane on both sides of the contact.
Model strike(bool half, int passes, double friction)
{
    Model model;
    const double left = half ? 0 : 1;
    addBox(model.mesh, "lower", {half ? 4 : 8, 5, 3}, {-4 * left, 0, -2}, {4 + 4 * left, 5, 2});
    addBox(model.mesh, "upper", {half ? 3 : 6, 4, 3}, {-2 * left, 1, 0.01}, {2 + 2 * left, 3, 2});
    renumber(model.mesh, 32);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::physical, "lower"),
                   aluminium(PartKind::elastoplastic, HourglassForm::stiffness, "upper")};
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "upper"), {0, 2e4, -3e4}});
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -1.99; }));
    if (half) {
        model.boundaryConditions.push_back(condition(
            BoundaryCondition::Kind::fixed, "mirror",
            nodesWhere(model.mesh, [](Point p) { return p[0] == 0; }), {true, false, false}));
        model.boundaryConditions.back().mirror = true;
    }
    ContactPair& pair = addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                                   facing(model.mesh, "lower", {0, 0, 1}));
    pair.friction = friction;
    pair.tangentialScale = 0.1; // harder springs make rounding grow faster where they slip,
    pair.slipDamping = 0;       // and so does a force of the slip rate
    pair.passes = passes;
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

/// Nodes of the plane inside a ridge are as near to the faces on both sides and press on both: what
/// is left is rounding that grows.
TEST(Mirror, HalfTheModelMeetsAsTheWholeOneDoes)
{
    for (const int passes : {1, 2})
        for (const double friction : {0.0, 0.3}) {
            const auto whole = startedSolver(strike(false, passes, friction)),
                       half = startedSolver(strike(true, passes, friction));
            double most = 0, apart = 0; // a whole spring on half a node: 0.16
            for (int sample = 0; sample < 20; ++sample) {
                whole->advance(1, 10);
                half->advance(1, 10);
                ASSERT_NEAR(half->clock().time, whole->clock().time, 1e-7 * whole->clock().time);
                const Point a = whole->contact().force(0).force, b = half->contact().force(0).force;
                most = std::max(most, std::abs(a[2]));
                for (const std::size_t c : {1U, 2U})
                    apart = std::max(apart, std::abs(2 * b[c] - a[c]));
            }
            EXPECT_GT(most, 1e3) << passes << " passes";
            EXPECT_LT(apart, 1e-8 * most) << passes << " passes, friction " << friction;
            EXPECT_NEAR(2 * half->ledger().energies().friction, whole->ledger().energies().friction,
                        1e-6 * whole->ledger().energies().friction);
        }
}

/// However many conditions define a plane of symmetry, it is one plane.
TEST(Mirror, APlaneInManyConditionsIsOne)
{
    const auto once = startedSolver(strike(true, 1, 0.3));
    Model model = strike(true, 1, 0.3);
    BoundaryCondition& mirror = model.boundaryConditions.back();
    const std::vector<Index> nodes = mirror.nodes;
    for (const char* part : {"upper", "lower"})
        for (int n = 0; n < 6; ++n) {
            BoundaryCondition more = model.boundaryConditions.back();
            more.nodes.clear();
            for (const Index node : nodesOfPart(model.mesh, part))
                if (std::binary_search(nodes.begin(), nodes.end(), node))
                    more.nodes.push_back(node);
            model.boundaryConditions.push_back(more);
        }
    model.boundaryConditions.erase(model.boundaryConditions.begin() + 1); // the whole plane's
    const auto parts = startedSolver(model);
    once->advance(1, 60);
    parts->advance(1, 60);
    EXPECT_GT(std::abs(once->contact().force(0).force[2]), 500);
    EXPECT_EQ(once->contact().force(0).force, parts->contact().force(0).force);
    EXPECT_EQ(once->ledger().energies().friction, parts->ledger().energies().friction);
}

/// A layer held on both sides by one condition lies between two planes.
TEST(Mirror, TwoPlanesInOneConditionAreTwo)
{
    Model model = strike(true, 1, 0.3);
    model.boundaryConditions.back().nodes =
        nodesWhere(model.mesh, [](Point p) { return p[0] == 0 || p[0] == 4; });
    const std::vector<MirrorPlane> planes = mirrorPlanes(model);
    ASSERT_EQ(planes.size(), 2U);
    for (const MirrorPlane& plane : planes)
        for (std::size_t node = 0; node < model.mesh.points.size(); ++node)
            EXPECT_EQ(plane.holds[node],
                      model.mesh.points[node][0] * plane.normal[0] == plane.distance);
}

/// A condition meant for a plane that holds a thick body is refused by its name.
TEST(Mirror, MoreThanEightPlanesAreRefused)
{
    Model model;
    addBox(model.mesh, "block", {1, 1, 8}, {0, 0, 0}, {1, 1, 8}); // nine layers of nodes
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::fixed, "flat",
                                                 nodesOfPart(model.mesh, "block"),
                                                 {false, false, true}));
    model.boundaryConditions.back().mirror = true;
    try {
        mirrorPlanes(model);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("'flat'"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace fpm::test
