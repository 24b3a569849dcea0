// The GPU against the CPU, to the last bit: every kernel in every precision, on scenes of seconds.
// FPM_PARITY_BACKEND names another backend to compare (openmp), so that these scenes are tried
// where there is no GPU.

#include "base/Error.h"
#include "gpu/parityScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace fpm::test {
namespace {

constexpr int fullSteps = 160;

int stepsAsked()
{
    const char* asked = std::getenv("FPM_PARITY_STEPS");
    return asked ? std::atoi(asked) : fullSteps;
}

std::string backendUnderTest()
{
    const char* named = std::getenv("FPM_PARITY_BACKEND");
    return named ? named : "cuda";
}

/// What two backends must agree on: the state, and all that the host reads.
struct Outcome {
    std::uint64_t state = 0;
    std::map<std::string, std::vector<double>> read;

    void add(const std::string& name, const std::vector<double>& values)
    {
        std::vector<double>& all = read[name];
        all.insert(all.end(), values.begin(), values.end());
    }
};

void expectEqual(const Outcome& got, const Outcome& expected)
{
    EXPECT_EQ(got.state, expected.state);
    for (const auto& [name, values] : expected.read) {
        const std::vector<double>& found = got.read.at(name);
        ASSERT_EQ(found.size(), values.size()) << name;
        const auto [mine, other] = std::mismatch(found.begin(), found.end(), values.begin());
        EXPECT_TRUE(mine == found.end())
            << name << " " << mine - found.begin() << ": " << *mine << ", expected " << *other;
    }
}

Outcome outcomeOf(Solver& solver, const Model& model)
{
    Outcome out{stateChecksum(solver), {}};
    const Energies e = solver.ledger().energies();
    out.add("energies", {e.time, e.kinetic, e.internal, e.plastic, e.hourglass, e.bulkViscosity,
                         e.contact, e.friction, e.contactDamping, e.damping, e.external});
    const NodalWorks w = solver.ledger().nodalWorks();
    out.add("works", {w.internal, w.contact, w.external, w.drives, w.damping});
    for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair) {
        const PairForce f = solver.contact().force(pair);
        out.add("pair force", {f.force.begin(), f.force.end()});
        out.add("pair", {double(f.active), double(f.released), double(f.inside), f.springEnergy,
                         f.friction, f.damping});
        const PairStatus t = solver.contact().status(pair);
        out.add("touch", {double(t.active), t.maxDepth, t.meanDepth, double(t.deepest), t.thickness,
                          t.normal, t.speed});
        out.add("slip and friction",
                {t.slip[0], t.slip[1], t.slip[2], t.friction[0], t.friction[1], t.friction[2]});
    }
    for (std::size_t body = 0; body < solver.bodies().setUp().part.size(); ++body) {
        const BodyMotionValues b = solver.bodies().motion(body);
        for (const Point& p : {b.displacement, b.velocity, b.spin, b.force, b.moment, b.momentum})
            out.add("body", {p.begin(), p.end()});
    }
    std::vector<double> gaps = solver.contact().gaps();
    for (double& gap : gaps) // no target within reach, which equals itself here
        if (std::isnan(gap)) gap = 1e300;
    out.add("gaps", gaps);
    out.add("step, contact limit", {solver.clock().step, solver.contact().bound().frequency});
    out.add("nodes", solver.nodes().values({}).values);
    const ElementValues elements = solver.elements().values();
    out.add("stress", elements.stress);
    out.add("plastic strain", elements.plasticStrain);
    return out;
}

/// After the steps asked for; `calls`: that the host interrupts them; `audit`: with all works of
/// nodes.
Outcome outcomeOf(Model model, const std::string& backend, int calls = 1, bool audit = false)
{
    model.control.backend = backend;
    model.control.threads = 2;
    const auto solver = startedSolver(model, audit);
    const int steps = stepsAsked();
    for (int call = 0; call < calls; ++call) {
        solver->advance(1, steps * (call + 1) / calls - steps * call / calls);
        if (calls > 1) solver->ledger().energies();
    }
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_EQ(solver->clock().steps, steps);
    return outcomeOf(*solver, model);
}

class Parity : public testing::TestWithParam<Precision>
{
    void SetUp() override
    {
        try {
            Model model = boxModel({1, 1, 1}, {1, 1, 1},
                                   aluminium(PartKind::elastic, HourglassForm::stiffness));
            model.control.backend = backendUnderTest();
            makeSolver(model);
        } catch (const Error& error) {
            if (error.code() != ExitCode::device) throw;
            GTEST_SKIP() << error.what();
        }
    }
};

TEST_P(Parity, EveryKernelLeavesTheBitsOfTheProcessor)
{
    for (Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        scene.model.control.precision = GetParam();
        expectEqual(outcomeOf(scene.model, backendUnderTest()), outcomeOf(scene.model, "serial"));
    }
}

TEST_P(Parity, TwoRunsAreEqual)
{
    Model model = plain();
    model.control.precision = GetParam();
    expectEqual(outcomeOf(model, backendUnderTest()), outcomeOf(model, backendUnderTest()));
}

TEST_P(Parity, PausesOfTheHostDoNotChangeTheState)
{
    Model model = plain();
    model.control.precision = GetParam();
    expectEqual(outcomeOf(model, backendUnderTest(), 16), outcomeOf(model, "serial"));
}

TEST_P(Parity, WorksOfNodesAreEqual)
{
    std::vector<Scene> scenes;
    addMotions(scenes);
    for (Scene& scene : scenes) {
        SCOPED_TRACE(scene.name);
        scene.model.control.precision = GetParam();
        expectEqual(outcomeOf(scene.model, backendUnderTest(), 1, true),
                    outcomeOf(scene.model, "serial", 1, true));
    }
}

/// Half of the steps here, the others there, both ways.
TEST_P(Parity, AStateGoesOnOnTheOtherBackend)
{
    const int steps = stepsAsked();
    for (Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        scene.model.control.precision = GetParam();
        scene.model.control.threads = 2;
        Model there = scene.model;
        there.control.backend = backendUnderTest();
        const Outcome expected = outcomeOf(scene.model, "serial");
        scene.model.control.backend = "serial";
        for (const auto& [first, second] :
             {std::pair{&scene.model, &there}, {&there, &scene.model}}) {
            const auto begins = startedSolver(*first);
            begins->advance(1, steps / 2);
            const auto ends = makeSolver(*second);
            ends->restore(begins->state());
            ends->advance(1, steps - steps / 2);
            EXPECT_EQ(stateChecksum(*ends), expected.state);
        }
    }
}

/// The scenes do what they are named for: else equal bits would say little.
TEST(ParityScenes, TouchSlideYieldAndErode)
{
    for (const Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        Index touched = 0, deleted = 0;
        const auto solver = startedSolver(scene.model);
        for (int call = 0; call < fullSteps / 10; ++call) {
            solver->advance(1, 10);
            touched = std::max(touched, solver->contact().force(0).active);
        }
        EXPECT_GT(touched, 0);
        if (scene.name == "erosion") {
            for (const bool gone : solver->elements().values().deleted) deleted += gone;
            EXPECT_GT(deleted, 0);
        }
        if (scene.name.find("large strain") != std::string::npos) {
            const std::vector<double> strain = solver->elements().values().plasticStrain;
            EXPECT_GT(*std::max_element(strain.begin(), strain.end()), 0.25);
        }
        if (scene.name.find("plastic") != std::string::npos) {
            EXPECT_GT(solver->ledger().energies().plastic, 0);
        }
    }
}

std::string precisionName(const testing::TestParamInfo<Precision>& tried)
{
    return tried.param == Precision::double_ ? "double"
           : tried.param == Precision::mixed ? "mixed"
                                             : "single";
}

INSTANTIATE_TEST_SUITE_P(Precisions,
                         Parity,
                         testing::Values(Precision::double_, Precision::mixed, Precision::single),
                         precisionName);

} // namespace
} // namespace fpm::test
