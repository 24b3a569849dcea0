#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// A quarter of a rod strikes a quarter of a plate of two loose layers, held at its edges.
Model struckPlate()
{
    Model model;
    addBox(model.mesh, "lower", {10, 10, 1}, {0, 0, 0}, {20, 20, 1});
    addBox(model.mesh, "upper", {10, 10, 1}, {0, 0, 1}, {20, 20, 1});
    addBox(model.mesh, "rod", {3, 3, 6}, {0, 0, 2.01}, {5, 5, 12});
    renumber(model.mesh);
    for (const char* name : {"lower", "upper", "rod"})
        model.parts.push_back(
            aluminium(name[0] == 'r' ? PartKind::elastic : PartKind::elastoplastic,
                      HourglassForm::physical, name));
    model.initialVelocities.push_back({"fall", nodesOfPart(model.mesh, "rod"), {0, 0, -5e4}});
    for (int axis : {0, 1})
        model.boundaryConditions.push_back(
            condition(BoundaryCondition::Kind::fixed, axis == 0 ? "symX" : "symY",
                      nodesWhere(model.mesh, [=](Point p) { return p[std::size_t(axis)] == 0; }),
                      {axis == 0, axis == 1, false}));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[0] > 19.9 || p[1] > 19.9; }));
    addContact(model, "strike", facing(model.mesh, "rod", {0, 0, -1}),
               facing(model.mesh, "upper", {0, 0, 1}));
    addContact(model, "layers", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}));
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

struct Struck {
    double centre = 0, impulse = 0, plastic = 0, balance = 0;
};

/// Where the middle of the struck face is after 40 microseconds, the momentum the rod lost, and
/// what yielded.
Struck strike(const Model& model)
{
    const auto solver = startedSolver(model);
    const std::vector<Index> rod = nodesOfPart(model.mesh, "rod");
    const double before = momentum(*solver, rod)[2];
    solver->advance(4e-5, 100000);
    EXPECT_EQ(solver->clock().failed, 0);
    EXPECT_EQ(solver->contact().force(0).released + solver->contact().force(1).released, 0);
    const std::vector<Index> centre =
        nodesWhere(model.mesh, [](Point p) { return p[0] == 0 && p[1] == 0 && p[2] == 0; });
    return {solver->nodes().values(centre).at(0, 0)[2], momentum(*solver, rod)[2] - before,
            solver->ledger().energies().plastic, std::abs(solver->ledger().energies().balance)};
}

void expectNear(const Struck& a, const Struck& b, double share)
{
    EXPECT_NEAR(a.centre, b.centre, share * std::abs(b.centre));
    EXPECT_NEAR(a.impulse, b.impulse, share * std::abs(b.impulse));
    EXPECT_NEAR(a.plastic, b.plastic, share * std::abs(b.plastic));
    EXPECT_LT(a.balance, 0.01);
}

} // namespace

TEST(PaperAlgorithm, BendsAStruckPlateAsOursDoes)
{
    Model model = struckPlate();
    const Struck ours = strike(model);
    EXPECT_LT(ours.centre, -0.5);
    EXPECT_GT(ours.plastic, 0);

    for (Part& part : model.parts) part.rotation = RotationForm::arcsine;
    model.control.midStepStrain = false;
    for (ContactPair& pair : model.contactPairs) {
        pair.search = ContactSearch::closestParticle;
        pair.projection = ContactProjection::cold;
    }
    expectNear(strike(model), ours, 0.02);
}

TEST(PaperAlgorithm, ColdProjectionFindsWhereTheTrackerIs)
{
    Model model = struckPlate();
    const Struck tracked = strike(model);
    for (const ContactSearch search : {ContactSearch::faces, ContactSearch::closestParticle}) {
        for (ContactPair& pair : model.contactPairs) {
            pair.search = search;
            pair.projection = ContactProjection::cold;
        }
        expectNear(strike(model), tracked, 1e-3);
    }
}

TEST(PaperAlgorithm, ColdProjectionPassesFromFaceToFaceAsItSlides)
{
    for (const ContactSearch search : {ContactSearch::faces, ContactSearch::closestParticle}) {
        Model model = twoBlocks(aluminium(PartKind::elastic, HourglassForm::stiffness),
                                aluminium(PartKind::elastic, HourglassForm::stiffness),
                                {2e5, 0, -1e4}, 0, 0.001);
        std::vector<double> forces[2];
        for (const bool cold : {false, true}) {
            model.contactPairs[0].search = search;
            model.contactPairs[0].projection =
                cold ? ContactProjection::cold : ContactProjection::tracked;
            const auto solver = startedSolver(model);
            while (solver->clock().time < 1e-5) { // slides by more than a face
                solver->advance(1e-5, 1);
                forces[cold].push_back(solver->contact().force(0).force[2]);
            }
            EXPECT_EQ(solver->contact().force(0).released + solver->contact().force(0).overEdge, 0);
        }
        ASSERT_EQ(forces[0].size(), forces[1].size());
        const double scale = *std::max_element(forces[0].begin(), forces[0].end());
        EXPECT_GT(scale, 0);
        for (std::size_t i = 0; i < forces[0].size(); ++i)
            EXPECT_NEAR(forces[0][i], forces[1][i], 1e-6 * scale) << i;
    }
}

} // namespace fpm::test
