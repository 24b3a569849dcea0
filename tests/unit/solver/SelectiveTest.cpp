#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <random>

// The selective hexahedron in whole meshes: the patch of MacNeal and Harder, nearly incompressible
// bending, plastic flow in plane strain.

namespace fpm::test {
namespace {

Part steel(double poisson)
{
    Part part = aluminium(PartKind::elastic, HourglassForm::stiffness);
    part.hexahedron = HexahedronForm::selective;
    part.rotation = RotationForm::hughesWinget;
    part.youngsModulus = 1e6;
    part.poissonsRatio = poisson;
    part.density = 1e-3;
    part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    return part;
}

/// The patch of MacNeal and Harder (1985): seven hexahedra, an irregular one inside the unit cube.
Model macNealPatch(const Part& part)
{
    Model model;
    const std::vector<Point> inner{
        {0.249, 0.342, 0.192}, {0.826, 0.288, 0.288}, {0.850, 0.649, 0.263}, {0.273, 0.750, 0.230},
        {0.320, 0.186, 0.643}, {0.677, 0.305, 0.683}, {0.788, 0.693, 0.644}, {0.165, 0.745, 0.702}};
    std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                              {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    points.insert(points.end(), inner.begin(), inner.end());
    model.mesh.points = points;
    model.mesh.hexahedra = {{8, 9, 10, 11, 12, 13, 14, 15}, {0, 1, 2, 3, 8, 9, 10, 11},
                            {12, 13, 14, 15, 4, 5, 6, 7},   {0, 1, 9, 8, 4, 5, 13, 12},
                            {11, 10, 2, 3, 15, 14, 6, 7},   {0, 8, 11, 3, 4, 12, 15, 7},
                            {9, 1, 2, 10, 13, 5, 6, 14}};
    model.mesh.parts.push_back({"box", 0, 7});
    renumber(model.mesh);
    model.parts = {part};
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

bool isCorner(const Point& p)
{
    for (const double x : p)
        if (x != 0 && x != 1) return false;
    return true;
}

/// Drives the corners to x + H x.
void driveCorners(Model& model, const double (&h)[3][3], const Amplitude& amplitude)
{
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const Point p = model.mesh.points[i];
        if (!isCorner(p)) continue;
        Point move{0, 0, 0};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k) move[c] += h[c][k] * p[k];
        model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::displacement, "drive",
                                                     {Index(i)}, {true, true, true}, move,
                                                     amplitude));
    }
}

// Variant 3: corners ramped smoothly over 40 transits of a wave, mass damping; the inner nodes
// find the linear field by themselves.
TEST(Selective, TheInnerNodesOfThePatchFindTheLinearField)
{
    Model model = macNealPatch(steel(0.25));
    const double transit = 1 / std::sqrt(1.2e6 / 1e-3), time = 40 * transit;
    const double h[3][3] = {{1e-3, 5e-4, 5e-4}, {5e-4, 1e-3, 5e-4}, {5e-4, 5e-4, 1e-3}};
    driveCorners(model, h, {Amplitude::Kind::smooth, {{0, 0}, {time, 1}}});
    model.control.massDamping = 3 / transit;
    const auto solver = startedSolver(model);
    solver->advance(1.5 * time, 100000);
    ASSERT_FALSE(solver->clock().failed);
    const NodeValues values = solver->nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const Point p = model.mesh.points[i];
            double exact = 0;
            for (std::size_t k = 0; k < 3; ++k) exact += h[c][k] * p[k];
            EXPECT_NEAR(values.at(0, i)[c] - p[c], exact, 1e-6); // 1e-3 of the largest
        }
    const std::vector<double> stress = solver->elements().values().stress;
    for (std::size_t e = 0; e < 7; ++e)
        for (std::size_t k = 0; k < 6; ++k) // MacNeal and Harder: 2000 and 400
            EXPECT_NEAR(stress[6 * e + k], k < 3 ? 2000 : 400, 5); // large strains: 0.2 %
}

/// Tip deflection of a cantilever in plane strain, 8 x 2 mm, four elements high, over that of a
/// beam with shear; the load is applied at once and comes to rest.
double bentBlock(double poisson)
{
    Part part = steel(poisson);
    Model model = boxModel({16, 1, 4}, {8, 0.5, 2}, part);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] == 0; }));
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::fixed, "plane",
                                                 nodesWhere(model.mesh, [](Point) { return true; }),
                                                 {false, true, false}));
    const double load = 10;
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::force, "tip",
                  nodesWhere(model.mesh, [](Point p) { return p[0] == 8; }), {false, false, true},
                  {0, 0, -load}));
    model.control.relaxationTolerance = 1e-3;
    const auto solver = startedSolver(model);
    solver->advance(1, 200000);
    EXPECT_TRUE(solver->clock().settled);
    const NodeValues values = solver->nodes().values({});
    double tip = 0;
    for (std::size_t i = 0; i < values.count; ++i)
        if (model.mesh.points[i][0] == 8 && model.mesh.points[i][2] == 1)
            tip = 1 - values.at(0, i)[2];
    const double modulus = 1e6 / (1 - poisson * poisson), inertia = 0.5 * 8 / 12;
    const double shear = 1e6 / (2 * (1 + poisson)) * 5.0 / 6 * 0.5 * 2;
    return tip / (load * 512 / (3 * modulus * inertia) + load * 8 / shear);
}

TEST(Selective, ANearlyIncompressibleBlockBendsLikeAnyOther)
{
    const double compressible = bentBlock(0.3), incompressible = bentBlock(0.499);
    EXPECT_NEAR(compressible, 1, 0.05);
    EXPECT_NEAR(incompressible, 1, 0.05);
}

/// A cube whose faces but one pair are between smooth walls is pressed flat: plane strain flow at
/// (2 / sqrt 3) sigma_y. Elements of a distorted mesh must not resist the change of shape.
TEST(Selective, PlasticFlowInPlaneStrainDoesNotLock)
{
    Part part = aluminium(PartKind::elastoplastic, HourglassForm::stiffness);
    part.hexahedron = HexahedronForm::selective;
    part.rotation = RotationForm::hughesWinget;
    part.hardening = {{0, 285}, {1, 285}};
    Model model = boxModel({4, 4, 4}, {4, 4, 4}, part);
    std::mt19937 random(91);
    std::uniform_real_distribution<double> shift(-0.2, 0.2);
    for (Point& p : model.mesh.points) {
        bool outside = false;
        for (const double x : p) outside |= x < 0.01 || x > 3.99;
        if (!outside)
            for (double& x : p) x += shift(random);
    }
    using Kind = BoundaryCondition::Kind;
    const auto plane = [&](std::size_t axis, double place) {
        return nodesWhere(model.mesh, [=](Point p) { return std::abs(p[axis] - place) < 1e-9; });
    };
    for (const std::size_t axis : {0u, 1u, 2u}) {
        std::array<bool, 3> held{false, false, false};
        held[axis] = true;
        model.boundaryConditions.push_back(condition(Kind::fixed, "low", plane(axis, 0), held));
    }
    model.boundaryConditions.push_back(
        condition(Kind::fixed, "side", plane(1, 4), {false, true, false}));
    const double time = 1e-4;
    model.boundaryConditions.push_back(condition(Kind::displacement, "press", plane(2, 4),
                                                 {false, false, true}, {0, 0, -0.4},
                                                 {Amplitude::Kind::smooth, {{0, 0}, {time, 1}}}));
    const auto solver = startedSolver(model);
    solver->advance(0.5 * time, 100000);
    ASSERT_FALSE(solver->clock().failed);
    const std::vector<double> stress = solver->elements().values().stress;
    double mean = 0;
    for (std::size_t e = 0; e < 64; ++e) mean += stress[6 * e + 2] / 64;
    EXPECT_NEAR(mean, -2 / std::sqrt(3.0) * 285, 0.02 * 330);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
    EXPECT_EQ(solver->ledger().energies().hourglass, 0);
}

} // namespace
} // namespace fpm::test
