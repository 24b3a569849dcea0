#include "run/ContactPressure.h"

#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

TEST(ContactPressure, IsTheForceIntoTheBodyOverTheAreaOfItsNodes)
{
    Model model;
    addBox(model.mesh, "block", {4, 2, 1}, {0, 0, 0}, {8, 2, 1});
    const std::vector<ElementSide> bottom = facing(model.mesh, "block", {0, 0, -1});
    addContact(model, "one", bottom, {});
    addContact(model, "two", bottom, {}); // the same sides again: no more area
    // 3 per area, at each node over its share, and something along the surface.
    std::vector<Point> force(model.mesh.points.size(), Point{0, 0, 0});
    for (const ElementSide& side : bottom)
        for (const Index node : model.mesh.sideNodes(side)) {
            force[std::size_t(node)][2] += 3 * 2.0 * 1.0 / 4;
            force[std::size_t(node)][0] = 7;
        }
    const std::vector<double> pressure = contactPressure(model, model.mesh.points, force, {});
    for (std::size_t node = 0; node < pressure.size(); ++node)
        EXPECT_NEAR(pressure[node], model.mesh.points[node][2] == 0 ? 3 : 0, 1e-12);
}

TEST(ContactPressure, StretchedSurfacesAndDeletedElementsCountAsTheyAre)
{
    Model model;
    addBox(model.mesh, "block", {2, 1, 1}, {0, 0, 0}, {2, 1, 1});
    addContact(model, "one", facing(model.mesh, "block", {0, 0, -1}), {});
    std::vector<Point> points = model.mesh.points, force(points.size(), Point{0, 0, 1});
    for (Point& p : points) p[1] *= 2;
    const auto at = [&](const std::vector<double>& pressure, double x) {
        for (std::size_t node = 0; node < points.size(); ++node)
            if (points[node] == Point{x, 0, 0}) return pressure[node];
        return -1.0;
    };
    const std::vector<double> whole = contactPressure(model, points, force, {});
    EXPECT_NEAR(at(whole, 0), 1 / 0.5, 1e-12); // a quarter of a face of 1 x 2
    EXPECT_NEAR(at(whole, 1), 1 / 1.0, 1e-12);
    const std::vector<double> half = contactPressure(model, points, force, {false, true});
    EXPECT_NEAR(at(half, 1), 1 / 0.5, 1e-12);
    EXPECT_EQ(at(half, 2), 0);
}

} // namespace
} // namespace fpm::test
