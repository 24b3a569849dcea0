#include "base/Format.h"
#include "model/PartMaterial.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

// Drucker-Prager through the solver; MaterialsTest has every law in every vector width.

namespace fpm::test {
namespace {

using Kind = BoundaryCondition::Kind;

/// Soil, tonne, mm, s: cohesion 2 MPa, 30 degrees of friction.
Part soil(double dilation, HexahedronForm form = HexahedronForm::reduced)
{
    Part part = aluminium(kindOf<DruckerPrager>, HourglassForm::physical);
    part.density = 2e-9;
    part.youngsModulus = 5000;
    part.poissonsRatio = 0.25;
    part.lawValues = {2, 30, dilation};
    part.hexahedron = form;
    return part;
}

std::vector<Index> at(const Mesh& mesh, std::size_t axis, double place)
{
    return nodesWhere(mesh, [=](Point p) { return std::abs(p[axis] - place) < 1e-6; });
}

/// Holds the nodes of the coordinate planes in their normal direction.
void holdPlanes(Model& model)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<bool, 3> components{};
        components[axis] = true;
        model.boundaryConditions.push_back(
            condition(Kind::fixed, format("plane{}", axis), at(model.mesh, axis, 0), components));
    }
}

} // namespace

// N sigma_side - 2 c sqrt(N), N = (1 + sin phi) / (1 - sin phi), where the sides are free.
TEST(DruckerPragerElement, IsCrushedAtTheStrengthOfMohrAndCoulomb)
{
    for (const HexahedronForm form : {HexahedronForm::reduced, HexahedronForm::selective})
        for (const double dilation : {0.0, 30.0}) {
            Model model = boxModel({1, 1, 1}, {1, 1, 1}, soil(dilation, form));
            holdPlanes(model);
            model.boundaryConditions.push_back(
                condition(Kind::velocity, "press", at(model.mesh, 2, 1), {false, false, true},
                          {0, 0, -20}, {Amplitude::Kind::smooth, {{0, 0}, {2e-4, 1}}}));
            const auto solver = startedSolver(model);
            solver->advance(8e-4, 100000);
            const ElementValues values = solver->elements().values();
            // What inertia and bulk viscosity leave on the sides counts N = 3 times.
            const double strength = 4 * std::sqrt(3);
            EXPECT_NEAR(values.stress[2] - 3 * values.stress[0], -strength, 1e-9 * strength);
            EXPECT_NEAR(values.stress[0], values.stress[1], 1e-9 * strength);
            EXPECT_NEAR(values.stress[0], 0, 2e-3 * strength);
            EXPECT_GT(values.plasticStrain[0], 0.008);
            EXPECT_LT(std::abs(solver->ledger().energies().balance), 1e-3);
        }
}

// A bar bent far beyond yield. With one element in height it bears the plastic moment of the
// section (DruckerPragerTest), with four that of their stretch; no hourglassing takes part in
// either.
TEST(DruckerPragerBlock, BendsWithOneLayerAsWithFour)
{
    const auto work = [](const Part& part, Index layers) {
        Model model = boxModel({10, 2, layers}, {10, 2, 1}, part);
        holdFixed(model, at(model.mesh, 0, 0));
        model.boundaryConditions.push_back(
            condition(Kind::velocity, "bend", at(model.mesh, 0, 10), {false, false, true},
                      {0, 0, 1000}, {Amplitude::Kind::smooth, {{0, 0}, {2e-4, 1}}}));
        const auto solver = startedSolver(model);
        solver->advance(1e-3, 1000000);
        EXPECT_FALSE(solver->clock().failed);
        const Energies energies = solver->ledger().energies();
        EXPECT_LT(std::abs(energies.balance), 0.01);
        EXPECT_GT(energies.plastic, 0.5 * energies.internal);
        EXPECT_LT(energies.hourglass, 0.01 * energies.internal);
        return energies.external;
    };
    for (const double dilation : {0.0, 30.0}) {
        const double one = work(soil(dilation), 1), four = work(soil(dilation), 4);
        EXPECT_NEAR(one, four, 0.06 * four);
    }
}

// Torn in all directions, with the corners of every element shaken against each other: at the apex
// no deviator resists, yet nothing grows.
TEST(DruckerPragerBlock, StaysInShapeAtTheApex)
{
    for (const double dilation : {0.0, 30.0}) {
        Model model = boxModel({4, 4, 4}, {4, 4, 4}, soil(dilation));
        holdPlanes(model);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<bool, 3> components{};
            components[axis] = true;
            Point value{0, 0, 0};
            value[axis] = 400;
            model.boundaryConditions.push_back(condition(Kind::velocity, format("pull{}", axis),
                                                         at(model.mesh, axis, 4), components,
                                                         value));
        }
        // An hourglass pattern of the inner nodes.
        for (const double sign : {-1.0, 1.0})
            model.initialVelocities.push_back(
                {"shake",
                 nodesWhere(model.mesh,
                            [=](Point p) {
                                const int sum = int(std::lround(p[0] + p[1] + p[2]));
                                const bool inside = p[0] > 0.5 && p[0] < 3.5 && p[1] > 0.5
                                                    && p[1] < 3.5 && p[2] > 0.5 && p[2] < 3.5;
                                return inside && (sum % 2 == 0) == (sign > 0);
                            }),
                 {0, 0, 300 * sign}});
        const auto solver = startedSolver(model);
        solver->advance(4e-4, 1000000);
        EXPECT_FALSE(solver->clock().failed);
        const double apex = 2 / std::tan(std::numbers::pi / 6);
        double far = 0;
        const ElementValues values = solver->elements().values();
        for (std::size_t k = 0; k < values.stress.size(); k += 6)
            for (std::size_t c = 0; c < 3; ++c)
                far = std::max(far, std::abs(values.stress[k + c] - apex));
        EXPECT_LT(far, 0.05 * apex);
        // Nodes lie where the stretch of the block has them.
        const NodeValues nodes = solver->nodes().values({});
        const double stretch = 1 + 400 * solver->clock().time / 4;
        double off = 0;
        for (std::size_t i = 0; i < nodes.count; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                off =
                    std::max(off, std::abs(nodes.at(0, i)[c] - stretch * model.mesh.points[i][c]));
        EXPECT_LT(off, 0.01); // of an element
        EXPECT_LT(solver->ledger().energies().hourglass,
                  1e-3 * solver->ledger().energies().internal);
        EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
    }
}

} // namespace fpm::test
