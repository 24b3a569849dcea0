#include "unit/solver/edgeScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fpm::test {
namespace {

/// Whether the fields that are declared as state are all that the next step reads: a solver that is
/// given them goes on with the same bits.
struct Outcome {
    std::uint64_t checksum;
    Energies energies;
    NodalWorks works;
    std::vector<double> forces;
    std::int64_t searches;
};

Outcome outcomeOf(Solver& solver, const Model& model)
{
    Outcome out{stateChecksum(solver),
                solver.ledger().energies(),
                solver.ledger().nodalWorks(),
                {},
                solver.times().searches};
    for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair)
        for (const double f : solver.contact().force(pair).force) out.forces.push_back(f);
    return out;
}

/// Stored while the bodies touch, after `steps`.
void goesOnWithTheSameBits(const Model& model, bool audit = false, std::int64_t steps = 150)
{
    const auto whole = makeSolver(model, audit);
    whole->start();
    whole->advance(1, steps);
    EXPECT_GT(whole->contact().force(0).active, 0);
    const std::vector<FieldSet::Images> state = whole->state();
    whole->advance(1, 60);
    const auto resumed = makeSolver(model, audit);
    resumed->restore(state);
    EXPECT_EQ(resumed->clock().steps, steps);
    resumed->advance(1, 60);

    const Outcome expected = outcomeOf(*whole, model), found = outcomeOf(*resumed, model);
    EXPECT_EQ(found.checksum, expected.checksum);
    EXPECT_EQ(found.energies.total, expected.energies.total);
    EXPECT_EQ(found.energies.external, expected.energies.external);
    EXPECT_EQ(found.energies.balance, expected.energies.balance);
    EXPECT_EQ(found.energies.friction, expected.energies.friction);
    EXPECT_EQ(found.works.contact, expected.works.contact);
    EXPECT_EQ(found.works.damping, expected.works.damping);
    EXPECT_EQ(found.forces, expected.forces);
    EXPECT_EQ(found.searches, expected.searches);
}

Model impact()
{
    Model model =
        twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {3e4, -2e4, -1e5}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    return model;
}

TEST(State, OfAnImpactWithFrictionIsWhole)
{
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single}) {
        Model model = impact();
        model.control.precision = precision;
        goesOnWithTheSameBits(model);
    }
}

TEST(State, OfContactOptionsIsWhole)
{
    Model model = impact();
    ContactPair& pair = model.contactPairs[0];
    pair.passes = 2;
    pair.normalDamping = 0.2;
    goesOnWithTheSameBits(model);
    pair.paperFriction = true;
    pair.initialOverlap = InitialOverlap::ramp;
    pair.rampTime = 1e-4;
    model.control.searchInterval = 7;
    goesOnWithTheSameBits(model);
    pair.search = ContactSearch::closestParticle;
    goesOnWithTheSameBits(model);
}

TEST(State, OfAuditedWorksAndDampingIsWhole)
{
    Model model = impact();
    model.control.massDamping = 50;
    goesOnWithTheSameBits(model, true);
    model.control.massDamping = 0;
    model.control.relaxationTolerance = 1e-12;
    goesOnWithTheSameBits(model);
}

TEST(State, OfAFreeRigidBodyIsWhole)
{
    Model model = impact();
    model.parts[0].kind = PartKind::rigidFree;
    goesOnWithTheSameBits(model, false, 60);
}

/// All outer faces of both bodies against each other, their edges included.
TEST(State, OfGeneralContactOverEdgesIsWhole)
{
    Model model = impact();
    model.contactPairs.clear();
    model.mesh.contact.clear();
    addGeneral(model);
    goesOnWithTheSameBits(model);
}

TEST(State, OfEdgesThatSlideIsWhole)
{
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single}) {
        Model model = slidingRoofs();
        model.control.precision = precision;
        model.contactPairs[0].normalDamping = 0.1;
        goesOnWithTheSameBits(model, false, 20);
    }
}

/// Surfaces that deletions have renewed are made anew before they are given their values.
TEST(State, OfSurfacesThatErodeIsWhole)
{
    for (const bool half : {false, true}) {
        const Model model = punch(half, 0.3);
        const auto solver = startedSolver(model);
        solver->advance(1, 150);
        EXPECT_GE(std::ranges::count(solver->elements().values().deleted, true), 8);
        goesOnWithTheSameBits(model, false, 150);
    }
}

/// Whatever the width of the vectors and the number of threads are.
TEST(State, GoesOnElsewhere)
{
    const Model model = impact();
    const auto whole = startedSolver(model);
    whole->advance(1, 150);
    const std::vector<FieldSet::Images> state = whole->state();
    whole->advance(1, 60);
    for (const std::string simd : {"scalar", "avx2", "avx512"})
        for (const int threads : {1, 3}) {
            Model other = model;
            other.control.backend = "openmp";
            other.control.simd = simd;
            other.control.threads = threads;
            try {
                const auto resumed = makeSolver(other);
                resumed->restore(state);
                resumed->advance(1, 60);
                EXPECT_EQ(stateChecksum(*resumed), stateChecksum(*whole)) << simd << threads;
                EXPECT_EQ(resumed->times().steps, 60);
            } catch (const Error& error) { // a processor without these vectors
                EXPECT_EQ(error.code(), ExitCode::device) << error.what();
            }
        }
}

/// Without one field of it a run ends otherwise: the tests above would see what is not stored.
void needs(const Model& model, const std::vector<std::string>& fields)
{
    const auto whole = makeSolver(model);
    whole->start();
    whole->advance(1, 150);
    const std::vector<FieldSet::Images> state = whole->state();
    whole->advance(1, 60);
    const Outcome expected = outcomeOf(*whole, model);
    for (const std::string& name : fields) {
        std::vector<FieldSet::Images> without = state;
        for (FieldSet::Images& set : without)
            for (auto& [field, image] : set)
                if (field == name) std::fill(image.begin(), image.end(), std::byte(0xff));
        const auto resumed = makeSolver(model);
        resumed->restore(without);
        resumed->advance(1, 60);
        const Outcome found = outcomeOf(*resumed, model);
        EXPECT_FALSE(found.checksum == expected.checksum
                     && found.energies.total == expected.energies.total
                     && found.energies.balance == expected.energies.balance
                     && found.forces == expected.forces && found.searches == expected.searches)
            << name;
    }
}

TEST(State, HasNoIdleFields)
{
    needs(impact(), {"velocity", "state", "plasticStrain", "partialForce", "interiorForce",
                     "patchEnergy", "sum", "face", "tangentialForce", "dissipated", "startEnergy"});
}

/// Where the host comes back, by the clock on the wall, say, changes nothing; and a pause is met at
/// the first step at or after its time, however many steps were asked for.
TEST(State, DoesNotDependOnPauses)
{
    const Model model = impact();
    const auto whole = startedSolver(model), parts = startedSolver(model);
    whole->advance(1, 150);
    const double time = whole->clock().time;
    while (parts->clock().time < time) {
        Pause pause;
        pause.at = time;
        pause.goesOn = [](const StepClock& now) { return now.steps % 3 == 0; };
        parts->advance(1, 100000, pause);
    }
    EXPECT_EQ(parts->clock().steps, 150);
    EXPECT_EQ(stateChecksum(*parts), stateChecksum(*whole));
}

TEST(State, IsRefusedByAnotherModel)
{
    const auto solver = makeSolver(impact());
    Model without = impact();
    without.contactPairs.clear();
    EXPECT_THROW(makeSolver(without)->restore(solver->state()), Error);
}

} // namespace
} // namespace fpm::test
