#include "run/SectionFields.h"

#include "kernels/element/Deletion.h"
#include "model/PartMaterial.h"
#include "run/resultFrame.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

std::vector<Point> pointsOf(Solver& solver)
{
    const NodeValues values = solver.nodes().values({});
    std::vector<Point> points;
    for (std::size_t i = 0; i < values.count; ++i) points.push_back(values.at(0, i));
    return points;
}

SectionFields fieldsOf(Solver& solver, const Model& model)
{
    return sectionFields(solver, model, pointsOf(solver));
}

/// A strip of cubes of 1 mm, one element thick, that bends; one corner moves by itself, so that
/// there is something spurious too.
Model strip(const Part& part, double speed = 300)
{
    Model model = boxModel({8, 2, 1}, {8, 2, 1}, part);
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const Point& p = model.mesh.points[i];
        const bool corner = p[0] == 0 && p[1] == 0 && p[2] == 0;
        model.initialVelocities.push_back(
            {"", {Index(i)}, {0, corner ? speed : 0, speed * (p[0] - 4) * (p[0] - 4) / 4}});
    }
    return model;
}

Part undamped(PartKind kind, HourglassForm form)
{
    Part part = aluminium(kind, form);
    part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    return part;
}

double sumOf(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

/// Elastic energy of the stress at the integration points, elements of volume 1.
double stretchEnergy(Solver& solver)
{
    const std::vector<double> s = solver.elements().values().stress;
    double sum = 0;
    for (std::size_t e = 0; 6 * e < s.size(); ++e)
        sum += elasticEnergy<double>(
            solver.elements().setUp().materials[0],
            {s[6 * e], s[6 * e + 1], s[6 * e + 2], s[6 * e + 3], s[6 * e + 4], s[6 * e + 5]});
    return sum;
}

TEST(SectionFields, EnergiesOfThePhysicalFormAreThoseOfTheLedger)
{
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single}) {
        Model model = strip(undamped(PartKind::elastic, HourglassForm::physical));
        model.control.precision = precision;
        const auto solver = startedSolver(model);
        solver->advance(4e-6, 1000000);
        const SectionFields fields = fieldsOf(*solver, model);
        const Energies energies = solver->ledger().energies();
        const double bending = sumOf(fields.bending), hourglass = sumOf(fields.hourglass);
        EXPECT_GT(bending, 0.2 * energies.internal); // it does bend
        EXPECT_NEAR(bending + stretchEnergy(*solver), energies.internal, 5e-3 * energies.internal);
        EXPECT_GT(hourglass, 0);
        EXPECT_NEAR(hourglass, energies.hourglass, 5e-3 * energies.hourglass);
        EXPECT_EQ(sumOf(fields.utilisation), 0); // it never yields
    }
}

TEST(SectionFields, EnergyOfTheStiffnessFormIsThatOfTheLedger)
{
    const Model model = strip(undamped(PartKind::elastic, HourglassForm::stiffness));
    const auto solver = startedSolver(model);
    solver->advance(4e-6, 1000000);
    const SectionFields fields = fieldsOf(*solver, model);
    const double ledger = solver->ledger().energies().hourglass;
    EXPECT_GT(ledger, 0);
    EXPECT_NEAR(sumOf(fields.hourglass), ledger, 5e-3 * ledger);
    EXPECT_EQ(sumOf(fields.bending), 0);
}

TEST(SectionFields, UtilisationIsOneWhereTheSectionFlowsAndNeverMore)
{
    Part part = undamped(PartKind::elastoplastic, HourglassForm::physical);
    part.hardening = {{0, 285}}; // which does not depend on how the section shares its strain
    const Model model = strip(part, 2e4);
    const auto solver = startedSolver(model);
    double most = 0, leastAlone = 1;
    for (int i = 0; i < 20; ++i) {
        solver->advance(1, 10);
        const SectionFields fields = fieldsOf(*solver, model);
        const ElementValues values = solver->elements().values();
        for (std::size_t e = 0; e < fields.utilisation.size(); ++e) {
            EXPECT_LE(fields.utilisation[e], 1 + 1e-6); // hourglass strains are floats
            most = std::max(most, fields.utilisation[e]);
            const double* s = &values.stress[6 * e];
            const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
            const double q = std::sqrt(0.5 * (a * a + b * b + c * c)
                                       + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
            if (fields.utilisation[e] > 0.99)
                leastAlone = std::min(leastAlone, q / part.hardening[0].yieldStress);
        }
    }
    EXPECT_NEAR(most, 1, 1e-6);
    EXPECT_LT(leastAlone, 0.7); // the stress at the centre alone would not tell
}

// Torn in all directions, or with a free surface and no cohesion: no Mises stress is borne there.
TEST(SectionFields, UtilisationIsOneAtTheApexOfACone)
{
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single})
        for (const double cohesion : {2.0, 0.0}) {
            Part part = undamped(kindOf<DruckerPrager>, HourglassForm::physical);
            part.density = 2e-9;
            part.youngsModulus = 5000;
            part.poissonsRatio = 0.25;
            part.lawValues = {cohesion, 30, 0};
            const auto utilisations = [&](double strainRate) {
                Model model = boxModel({1, 1, 1}, {1, 1, 1}, part);
                model.control.precision = precision;
                for (std::size_t i = 0; i < 8; ++i) {
                    const Point& p = model.mesh.points[i];
                    model.initialVelocities.push_back(
                        {"",
                         {Index(i)},
                         {strainRate * (p[0] + 0.1 * p[1]), strainRate * p[1], strainRate * p[2]}});
                }
                const auto solver = startedSolver(model);
                std::vector<double> out;
                for (int step = 0; step < 8; ++step) {
                    solver->advance(1, 1);
                    out.push_back(fieldsOf(*solver, model).utilisation[0]);
                }
                return out;
            };
            const std::vector<double> torn = utilisations(1e4);
            for (std::size_t step = 0; step < 5; ++step)
                EXPECT_EQ(torn[step], 1);                          // then it
                                                                   // springs back
            const std::vector<double> pressed = utilisations(-20); // it springs back later
            for (std::size_t step = 0; step < 2; ++step) {
                EXPECT_GT(pressed[step], 0);
                EXPECT_LT(pressed[step], 0.5);
            }
        }
}

TEST(SectionFields, AFrameHasThoseThatSomePartHas)
{
    const auto namesOf = [](const Part& part) {
        const Model model = strip(part);
        const auto solver = startedSolver(model);
        std::vector<std::string> names;
        for (const ResultField& field : resultFrame(*solver, model).elementFields)
            names.push_back(field.name);
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(
        namesOf(aluminium(PartKind::elastoplastic, HourglassForm::physical)),
        (Names{"S", "Mises", "PEEQ", "Part", "HourglassEnergy", "BendingEnergy", "Utilisation"}));
    EXPECT_EQ(namesOf(aluminium(PartKind::elastic, HourglassForm::stiffness)),
              (Names{"S", "Mises", "PEEQ", "Part", "HourglassEnergy"}));
    EXPECT_EQ(namesOf(aluminium(PartKind::elastic, HourglassForm::viscous)),
              (Names{"S", "Mises", "PEEQ", "Part"}));
}

} // namespace
} // namespace fpm::test
