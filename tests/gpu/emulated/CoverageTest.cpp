// The emulated parity tests leave no kernel of the CUDA backend out.

#include "gpu/parityScenes.h"
#include "solver/Solver.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

TEST(EmulatedCoverage, TheScenesLaunchEveryKernelInEveryPrecision)
{
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single})
        for (Scene& scene : scenes()) {
            SCOPED_TRACE(scene.name);
            scene.model.control.precision = precision;
            scene.model.control.backend = "cuda";
            const auto solver = startedSolver(scene.model);
            solver->advance(1, 4);
            solver->nodeValues({0});
        }
    std::size_t launches = 0, largest = 0;
    for (const auto& [name, kernel] : cudaStandIn::kernels()) {
        if (name.find("StandInTest") != std::string::npos) continue;
        EXPECT_GT(kernel.launches, 0) << name;
        launches += kernel.launches;
        largest = std::max(largest, kernel.argumentBytes);
    }
    EXPECT_GT(launches, 0);
    RecordProperty("kernels", int(cudaStandIn::kernels().size()));
    RecordProperty("largestArgument", int(largest));
}

} // namespace
} // namespace fpm::test
