// Lets the stand-in run the kernels that nvcc made, translated from PTX, in the place of those that
// g++ made.

#include "gpu/ptx/ptxOperations.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace ptx {

namespace {

std::map<std::string, cudaStandIn::Body>& translated()
{
    static std::map<std::string, cudaStandIn::Body> all;
    return all;
}
struct Fused {
    std::string module;
    const unsigned char* told;
    std::size_t count;
};
std::vector<Fused>& fusedOfModules()
{
    static std::vector<Fused> all;
    return all;
}
std::set<std::string>& launched()
{
    static std::set<std::string> all;
    return all;
}

/// Ends the program where a kernel has no translation: g++'s would prove nothing.
cudaStandIn::Body bodyOf(const void* kernel)
{
    static std::map<const void*, cudaStandIn::Body> known;
    const auto at = known.find(kernel);
    if (at != known.end()) return at->second;
    Dl_info symbol{};
    dladdr(kernel, &symbol);
    const std::string name = symbol.dli_sname ? symbol.dli_sname : "a kernel without a name";
    const auto found = translated().find(name);
    if (found == translated().end()) {
        std::fprintf(stderr, "PTX: no translation of %s\n", name.c_str());
        std::abort();
    }
    launched().insert(name);
    return known[kernel] = found->second;
}

constexpr double mostBlunt = 0.2;

class PtxInsteadOfCpp : public testing::Environment
{
    void SetUp() override { cudaStandIn::replacement = bodyOf; }
    void TearDown() override { EXPECT_EQ(cudaStandIn::lastFault(), ""); }
};
[[maybe_unused]] const auto* const environment =
    testing::AddGlobalTestEnvironment(new PtxInsteadOfCpp);

} // namespace

Known::Known(const char* name, cudaStandIn::Body body)
{
    translated()[name] = body;
}

KnownFused::KnownFused(const char* module, const unsigned char* told, std::size_t count)
{
    fusedOfModules().push_back({module, told, count});
}

/// Of all modules; with a parameter, since such tests run in the order in which they are linked:
/// after the parity tests.
class PtxCoverage : public testing::TestWithParam<int>
{};
INSTANTIATE_TEST_SUITE_P(All, PtxCoverage, testing::Values(0));

TEST_P(PtxCoverage, TheScenesLaunchedEveryKernel)
{
    for (const auto& [name, body] : translated()) EXPECT_TRUE(launched().contains(name)) << name;
    EXPECT_GE(translated().size(), 80u);
    RecordProperty("kernels", int(translated().size()));
}

/// Else equal bits would say nothing of these: nvcc might have fused them or not. Where a factor is
/// a power of two they never differ.
TEST_P(PtxCoverage, TheScenesTellFusedMultiplyAddsFromProductsAndSums)
{
    for (const char* precision : {"Double", "Mixed", "Single"}) {
        std::ptrdiff_t blunt = 0, done = 0;
        for (const Fused& module : fusedOfModules()) {
            if (module.module.find(precision) == std::string::npos) continue;
            const auto with = [&](unsigned char bits) {
                return std::count(module.told, module.told + module.count, bits);
            };
            std::printf("%s: %zu fused multiply-adds, %td done, %td of them never told\n",
                        module.module.c_str(), module.count, with(1) + with(3), with(1));
            blunt += with(1);
            done += with(1) + with(3);
        }
        std::printf("%s: %.1f %% never told\n", precision, 100 * double(blunt) / double(done));
        EXPECT_GT(done, 0) << precision;
        EXPECT_LT(double(blunt), mostBlunt * double(done)) << precision;
    }
}

} // namespace ptx
