// The GPU against the CPU, to the last bit: every kernel in every precision, on scenes of seconds.
// FPM_PARITY_BACKEND names another backend to compare (openmp), so that these scenes are tried
// where there is no GPU.

#include "base/Error.h"
#include "gpu/parityScenes.h"

#include <gtest/gtest.h>

#include <cstdlib>

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

/// Checksum after the steps asked for; `calls`: that the host interrupts them.
std::uint64_t checksumOf(Model model, const std::string& backend, int calls = 1)
{
    model.control.backend = backend;
    model.control.threads = 2;
    const auto solver = startedSolver(model);
    const int steps = stepsAsked();
    for (int call = 0; call < calls; ++call) {
        solver->advance(1, steps * (call + 1) / calls - steps * call / calls);
        if (calls > 1) solver->energies();
    }
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_EQ(solver->clock().steps, steps);
    return solver->stateChecksum();
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
        EXPECT_EQ(checksumOf(scene.model, backendUnderTest()), checksumOf(scene.model, "serial"));
    }
}

TEST_P(Parity, TwoRunsAreEqual)
{
    Model model = plain();
    model.control.precision = GetParam();
    EXPECT_EQ(checksumOf(model, backendUnderTest()), checksumOf(model, backendUnderTest()));
}

TEST_P(Parity, PausesOfTheHostDoNotChangeTheState)
{
    Model model = plain();
    model.control.precision = GetParam();
    EXPECT_EQ(checksumOf(model, backendUnderTest(), 16), checksumOf(model, "serial"));
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
            touched = std::max(touched, solver->pairForce(0).active);
        }
        EXPECT_GT(touched, 0);
        if (scene.name == "erosion") {
            for (const bool gone : solver->elementValues().deleted) deleted += gone;
            EXPECT_GT(deleted, 0);
        }
        if (scene.name.find("plastic") != std::string::npos) {
            EXPECT_GT(solver->energies().plastic, 0);
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
