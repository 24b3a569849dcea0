#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// Number of nodes with a gap, each of which lies on the lower side of the block above and must be
/// `expected`.
int countGaps(const Model& model, double expected)
{
    const auto solver = startedSolver(model);
    const std::vector<double> gaps = solver->contact().gaps();
    EXPECT_EQ(gaps.size(), model.mesh.points.size());
    const NodeValues values = solver->nodes().values({});
    int count = 0;
    for (std::size_t node = 0; node < gaps.size(); ++node) {
        if (std::isnan(gaps[node])) continue;
        ++count;
        EXPECT_NEAR(gaps[node], expected, 1e-6);
        EXPECT_NEAR(values.at(0, node)[2], expected, 1e-6);
    }
    return count;
}

Model blocks(double gap)
{
    const Part part = aluminium(PartKind::elastic, HourglassForm::stiffness);
    return twoBlocks(part, part, {0, 0, 0}, 0.3, gap);
}

TEST(ContactGap, IsTheDistanceOfContactorsWithinReachAndNegativeInside)
{
    for (const Precision precision : {Precision::double_, Precision::single})
        for (const double gap : {-0.02, 0.05}) {
            Model model = blocks(gap);
            model.control.precision = precision;
            EXPECT_EQ(countGaps(model, gap), 30) << gap;
        }
    EXPECT_EQ(countGaps(blocks(3), 3), 0); // out of reach
}

TEST(ContactGap, OfTwoPassesBothSidesHaveOne)
{
    Model model = blocks(-0.02);
    model.contactPairs[0].passes = 2;
    const auto solver = startedSolver(model);
    int lower = 0;
    const std::vector<double> gaps = solver->contact().gaps();
    for (std::size_t node = 0; node < gaps.size(); ++node) {
        if (!(gaps[node] < 0)) continue;
        EXPECT_NEAR(gaps[node], -0.02, 1e-6);
        lower += model.mesh.points[node][2] == 0;
    }
    EXPECT_GT(lower, 0);
}

TEST(ContactGap, ReachesAnalyticSurfaces)
{
    Model model;
    addBox(model.mesh, "block", {2, 2, 2}, {0, 0, 0.01}, {2, 2, 2});
    renumber(model.mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::stiffness, "block")};
    addContact(model, "touch", facing(model.mesh, "block", {0, 0, -1}), {}).surface = 0;
    RigidSurface wall;
    wall.name = "wall";
    wall.axis = {0, 0, 1};
    model.rigidSurfaces.push_back(wall);
    model.control.backend = "serial";
    model.control.endTime = 1;
    EXPECT_EQ(countGaps(model, 0.01), 9);
}

} // namespace
} // namespace fpm::test
