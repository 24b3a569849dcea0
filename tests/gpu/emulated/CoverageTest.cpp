// The emulated parity tests leave no kernel of the CUDA backend out.

#include "bench/copy.h"
#include "gpu/parityScenes.h"
#include "solver/Solver.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// No test of the solver may leave a fault of the device behind, such as one found at the end.
class NoFault : public testing::Environment
{
    void TearDown() override { EXPECT_EQ(cudaStandIn::lastFault(), ""); }
};
[[maybe_unused]] const auto* const noFault = testing::AddGlobalTestEnvironment(new NoFault);

TEST(EmulatedCoverage, TheScenesLaunchEveryKernelInEveryPrecision)
{
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single})
        for (Scene& scene : scenes()) {
            SCOPED_TRACE(scene.name);
            scene.model.control.precision = precision;
            scene.model.control.backend = "cuda";
            const auto solver = startedSolver(scene.model);
            solver->advance(1, 4);
            solver->nodes().values({0});
            for (std::size_t pair = 0; pair < scene.model.contactPairs.size(); ++pair)
                solver->contact().status(pair);
            solver->contact().gaps();
        }
    bench::bandwidthOfGpu(1000, 1);
    std::size_t launches = 0, largest = 0, count = 0;
    for (const auto& [name, kernel] : cudaStandIn::kernels()) {
        if (name.find("standInTest") != std::string::npos) continue;
        EXPECT_GT(kernel.launches, 0) << name;
        ++count;
        launches += kernel.launches;
        largest = std::max(largest, kernel.argumentBytes);
    }
    EXPECT_GE(count, 80u);
    RecordProperty("kernels", int(count));
    RecordProperty("launches", int(launches));
    RecordProperty("largestArgument", int(largest));
}

} // namespace
} // namespace fpm::test
