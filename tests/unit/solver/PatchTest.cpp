#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <random>

namespace fpm::test {
namespace {

/// A box whose inner nodes are moved at random, its outer nodes driven with v = A x: every element
/// must see the same stress, whatever its shape.
Model distortedPatch(HourglassForm form, const std::array<Point, 3>& gradient)
{
    Model model = boxModel({4, 4, 4}, {4, 4, 4}, aluminium(PartKind::elastic, form));
    model.parts[0].linearBulkViscosity = model.parts[0].quadraticBulkViscosity = 0;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.2, 0.2);
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        Point& p = model.mesh.points[i];
        bool outside = false;
        for (const double x : p) outside |= x < 0.01 || x > 3.99;
        if (!outside)
            for (double& x : p) x += shift(random);
        Point velocity{0, 0, 0};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k) velocity[c] += gradient[c][k] * p[k];
        model.initialVelocities.push_back({"", {Index(i)}, velocity});
        if (outside)
            model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "drive",
                                                         {Index(i)}, {true, true, true}, velocity));
    }
    return model;
}

class Patch : public testing::TestWithParam<HourglassForm>
{};

/// Largest difference of a stress component from that of the first element.
double spread(const std::vector<double>& stress)
{
    double most = 0;
    for (std::size_t i = 6; i < stress.size(); ++i)
        most = std::max(most, std::abs(stress[i] - stress[i % 6]));
    return most;
}

/// Largest force on a node that is not driven.
double innerForce(const Model& model, Solver& solver)
{
    double most = 0;
    const NodeValues values = solver.nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i) {
        bool inside = true;
        for (const double x : model.mesh.points[i]) inside &= x > 0.01 && x < 3.99;
        if (!inside) continue;
        for (const double f : values.at(3, i)) most = std::max(most, std::abs(f));
    }
    return most;
}

TEST_P(Patch, StretchedDistortedMeshHasUniformStress)
{
    const double rate = 2e-4; // strain 2e-10 at the end: geometry stays as it is
    const Model model =
        distortedPatch(GetParam(), {{{rate, 0, 0}, {0, -0.3 * rate, 0}, {0, 0, -0.3 * rate}}});
    const auto solver = startedSolver(model);
    solver->advance(1e-6, 1000);
    ASSERT_FALSE(solver->clock().failed);
    const std::vector<double> stress = solver->elements().values().stress;
    EXPECT_NEAR(stress[0], 70000 * rate * 1e-6, 1e-8 * stress[0]); // uniaxial
    EXPECT_LT(spread(stress), 1e-10 * stress[0]);
    EXPECT_LT(innerForce(model, *solver), 1e-10 * stress[0]);
}

TEST_P(Patch, ShearedAndTurnedDistortedMeshHasUniformStress)
{
    const double r = 1e-4;
    const Model model =
        distortedPatch(GetParam(), {{{0, 1.5 * r, -0.4 * r}, {0.8 * r, 0, 0.3 * r}, {-r, r, 0}}});
    const auto solver = startedSolver(model);
    solver->advance(1e-6, 1000);
    ASSERT_FALSE(solver->clock().failed);
    const std::vector<double> stress = solver->elements().values().stress;
    EXPECT_NEAR(stress[3], 70000 / 2.6 * 2.3 * r * 1e-6, 1e-8 * stress[3]);
    EXPECT_LT(spread(stress), 1e-10 * stress[3]);
    EXPECT_LT(innerForce(model, *solver), 1e-10 * stress[3]);
}

TEST_P(Patch, AtFiniteStrainTheSpreadIsOfSecondOrder)
{
    // The middle surfaces of differently shaped elements turn differently in a stretch, by the
    // order of the strain, and the stress with them.
    const double strain = 2e-3;
    const Model model = distortedPatch(
        GetParam(), {{{1e6 * strain, 0, 0}, {0, -3e5 * strain, 0}, {0, 0, -3e5 * strain}}});
    const auto solver = startedSolver(model);
    solver->advance(1e-6, 1000);
    const std::vector<double> stress = solver->elements().values().stress;
    EXPECT_LT(spread(stress), strain * stress[0]);
}

std::string formName(const testing::TestParamInfo<HourglassForm>& info)
{
    return info.param == HourglassForm::stiffness ? "stiffness"
           : info.param == HourglassForm::viscous ? "viscous"
                                                  : "physical";
}

INSTANTIATE_TEST_SUITE_P(Forms,
                         Patch,
                         testing::Values(HourglassForm::stiffness,
                                         HourglassForm::viscous,
                                         HourglassForm::physical),
                         formName);

} // namespace
} // namespace fpm::test
