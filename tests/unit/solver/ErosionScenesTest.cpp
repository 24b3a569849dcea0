#include "unit/solver/kindScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fpm::test {
namespace {

std::ptrdiff_t deletedIn(Solver& solver)
{
    return std::ranges::count(solver.elements().values().deleted, true);
}

/// Surfaces renewed where elements were deleted go on at the plane of symmetry as they did before.
TEST(Mirror, HalfTheModelErodesAsTheWholeOneDoes)
{
    for (const double friction : {0.0, 0.3}) {
        const auto whole = startedSolver(punch(false, friction)),
                   half = startedSolver(punch(true, friction));
        double most = 0, apart = 0;
        for (int sample = 0; sample < 28; ++sample) {
            whole->advance(1, 10);
            half->advance(1, 10);
            ASSERT_FALSE(whole->clock().failed || half->clock().failed);
            ASSERT_NEAR(half->clock().time, whole->clock().time, 1e-6 * whole->clock().time);
            ASSERT_EQ(2 * deletedIn(*half), deletedIn(*whole)) << "look " << sample;
            const Point a = whole->contact().force(0).force, b = half->contact().force(0).force;
            most = std::max(most, std::abs(a[2]));
            apart = std::max(apart, std::abs(2 * b[2] - a[2]));
        }
        EXPECT_GT(deletedIn(*whole), 16);
        EXPECT_LT(apart, 1e-10 * most) << "friction " << friction;
        EXPECT_NEAR(2 * half->ledger().energies().friction, whole->ledger().energies().friction,
                    1e-10 * whole->ledger().energies().friction);
    }
}

/// The force of a pair is that of the contactors that stay, also before the step after a deletion.
TEST(Erosion, ForcesOfContactorsThatHaveLeftCountNoMore)
{
    Part part = aluminium(PartKind::elastoplastic, HourglassForm::stiffness);
    part.erosion.plasticStrain = 0.01;
    Model model = boxModel({2, 1, 1}, {2, 1, 1}, part);
    addBox(model.mesh, "lid", {3, 2, 1}, {0.1, 0.1, 0.99}, {1.8, 0.8, 0.5});
    renumber(model.mesh);
    model.parts.push_back(aluminium(PartKind::elastic, HourglassForm::stiffness, "lid"));
    const std::vector<Index> left = nodesWhere(model.mesh, [](Point p) { return p[0] < 1e-9; });
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "crush", left,
                                                 {true, true, true}, {1e4, 0, 0}));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] > 1e-9; }));
    addContact(model, "touch", facing(model.mesh, "lid", {0, 0, -1}),
               facing(model.mesh, "box", {0, 0, 1}));
    model.control.backend = "serial";
    for (const double friction : {0.0, 0.2}) {
        model.contactPairs[0].friction = friction;
        const auto solver = startedSolver(model);
        const double whole = solver->contact().force(0).force[2];
        EXPECT_EQ(solver->contact().force(0).active, 12);
        while (solver->clock().deletions == 0 && solver->clock().time < 8e-5)
            solver->advance(9e-5, 1);
        ASSERT_EQ(std::ranges::count(solver->elements().values().deleted, true), 1);
        const PairForce renewed = solver->contact().force(0);
        EXPECT_EQ(renewed.active, 6);
        EXPECT_NEAR(renewed.force[2], 0.5 * whole, 1e-9 * whole);
        solver->advance(9e-5, 1);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(solver->contact().force(0).force[c], renewed.force[c], 1e-9 * whole);
    }
}

} // namespace
} // namespace fpm::test
