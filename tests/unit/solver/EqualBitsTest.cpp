#include "unit/solver/edgeScenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// One state for every way of running: a plastic block strikes an elastic one and slides with
/// friction; eleven patches, so that threads have something to share and boundary sums an order.
Model impact(Precision precision)
{
    Model model =
        twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {3e4, -2e4, -1e5}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    model.control.precision = precision;
    return model;
}

std::uint64_t
checksumOf(Model model, const std::string& backend, int threads, const char* simd, int steps = 400)
{
    model.control.backend = backend;
    model.control.threads = threads;
    model.control.simd = simd;
    const auto solver = startedSolver(model);
    solver->advance(1, steps);
    EXPECT_EQ(solver->clock().steps, steps);
    EXPECT_FALSE(solver->clock().failed);
    return stateChecksum(*solver);
}

bool hasAvx512()
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
           && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}

class EqualBits : public testing::TestWithParam<Precision>
{};

TEST_P(EqualBits, TheSceneTouchesSlidesAndYieldsInSeveralPatches)
{
    const Model model = impact(GetParam());
    EXPECT_GE(model.mesh.patchStarts.size(), 9u);
    const auto solver = startedSolver(model);
    solver->advance(1, 120);
    EXPECT_GT(solver->contact().force(0).active, 0);
    EXPECT_GT(solver->ledger().energies().friction, 0);
    EXPECT_GT(solver->ledger().energies().plastic, 0);
}

TEST_P(EqualBits, VectorWidthDoesNotChangeTheState)
{
    const Model model = impact(GetParam());
    EXPECT_EQ(checksumOf(model, "serial", 1, "avx2"), checksumOf(model, "serial", 1, "scalar"));
}

TEST_P(EqualBits, Avx512DoesNotChangeTheState)
{
    if (!hasAvx512()) GTEST_SKIP() << "this processor has no AVX-512";
    const Model model = impact(GetParam());
    EXPECT_EQ(checksumOf(model, "serial", 1, "avx512"), checksumOf(model, "serial", 1, "scalar"));
}

TEST_P(EqualBits, ThreadsDoNotChangeTheState)
{
    const Model model = impact(GetParam());
    const int steps = 150; // more threads than cores are slow: they wait for each other
    const std::uint64_t serial = checksumOf(model, "serial", 1, "auto", steps);
    for (const int threads : {1, 2, 3})
        EXPECT_EQ(checksumOf(model, "openmp", threads, "auto", steps), serial)
            << threads << " threads";
}

TEST_P(EqualBits, AChangeOfThreadsDuringTheRunDoesNotChangeTheState)
{
    Model model = impact(GetParam());
    const std::uint64_t serial = checksumOf(model, "serial", 1, "auto", 150);
    model.control.backend = "openmp";
    model.control.threads = 3;
    const auto solver = startedSolver(model);
    for (const int threads : {1, 3, 2, 9, 1}) {
        solver->useThreads(threads);
        solver->advance(1, 30);
        EXPECT_EQ(solver->times().threads, std::min(threads, 3));
    }
    EXPECT_EQ(stateChecksum(*solver), serial);
}

Index patchesThatMoveNodes(const Model& model)
{
    Index count = 0;
    for (const PatchHeader& patch : makeSetUp(model).elements.patches) count += patch.movesInterior;
    return count;
}

/// Nodes that are held or touch are none of those that patches move themselves.
TEST_P(EqualBits, WhoMovesTheNodesOfAPatchDoesNotChangeTheState)
{
    const Model model = impact(GetParam());
    Model gather = model;
    gather.control.assembly = Assembly::gather;
    const SolverSetUp data = makeSetUp(model);
    EXPECT_TRUE(data.nodes.movedByPatches);
    EXPECT_GT(data.nodes.count, Index(data.nodes.listed.size()) + 30);
    EXPECT_FALSE(makeSetUp(gather).nodes.movedByPatches);
    Model held = model;
    holdFixed(held, nodesWhere(held.mesh, [](Point) { return true; }));
    EXPECT_GT(patchesThatMoveNodes(model), 0);
    EXPECT_EQ(patchesThatMoveNodes(gather), 0);
    EXPECT_EQ(patchesThatMoveNodes(held), 0);
    const int steps = 150;
    const std::uint64_t expected = checksumOf(gather, "serial", 1, "scalar", steps);
    for (const char* simd : {"scalar", "avx2", "avx512"}) {
        if (std::string(simd) == "avx512" && !hasAvx512()) continue;
        for (const int threads : {1, 2})
            EXPECT_EQ(checksumOf(model, "openmp", threads, simd, steps), expected)
                << simd << ", " << threads << " threads";
    }
}

TEST_P(EqualBits, PausesOfTheHostDoNotChangeTheState)
{
    const Model model = impact(GetParam());
    const auto solver = startedSolver(model);
    for (int call = 0; call < 16; ++call) {
        solver->advance(1, 25);
        solver->ledger().energies();
        solver->nodes().values({});
    }
    EXPECT_EQ(stateChecksum(*solver), checksumOf(model, "serial", 1, "auto"));
}

/// Two passes; all bodies against all; a part that folds on itself.
std::vector<Model> otherKinds(Precision precision)
{
    Model twice = impact(precision), all = impact(precision), fold = closingFold();
    twice.contactPairs[0].passes = 2;
    all.mesh.contact.clear();
    all.contactPairs.clear();
    addGeneral(all).friction = 0.3;
    const std::vector<ElementSide> sides = skin(fold.mesh, 0);
    addContact(fold, "own", sides, sides).kind = ContactKind::self;
    fold.control.precision = precision;
    Model edges = slidingRoofs();
    edges.control.precision = precision;
    return {twice, all, fold, edges};
}

TEST_P(EqualBits, HoldForTheOtherKindsOfContact)
{
    for (const Model& model : otherKinds(GetParam())) {
        const int steps = 160; // the fold touches after 120
        const auto solver = startedSolver(model);
        Index touched = 0;
        for (int call = 0; call < steps / 10; ++call) {
            solver->advance(1, 10);
            touched = std::max(touched, solver->contact().force(0).active);
        }
        EXPECT_GT(touched, 0);
        const std::uint64_t scalar = checksumOf(model, "serial", 1, "scalar", steps);
        EXPECT_EQ(checksumOf(model, "serial", 1, "avx2", steps), scalar);
        if (hasAvx512()) {
            EXPECT_EQ(checksumOf(model, "serial", 1, "avx512", steps), scalar);
        }
        EXPECT_EQ(checksumOf(model, "openmp", 2, "auto", steps), scalar);
    }
}

std::string precisionName(const testing::TestParamInfo<Precision>& info)
{
    return info.param == Precision::double_ ? "double"
           : info.param == Precision::mixed ? "mixed"
                                            : "single";
}

INSTANTIATE_TEST_SUITE_P(Precisions,
                         EqualBits,
                         testing::Values(Precision::double_, Precision::mixed, Precision::single),
                         precisionName);

TEST(EqualBitsAcrossPrecisions, TheyDifferFromEachOtherButNotByMuch)
{
    std::vector<double> height;
    for (const Precision precision : {Precision::double_, Precision::mixed, Precision::single}) {
        const auto solver = startedSolver(impact(precision));
        solver->advance(5e-6, 100000);
        double sum = 0;
        const NodeValues values = solver->nodes().values({});
        for (std::size_t i = 0; i < values.count; ++i) sum += values.at(0, i)[2];
        height.push_back(sum / double(values.count));
    }
    EXPECT_NE(height[0], height[1]);
    EXPECT_NEAR(height[1], height[0], 1e-4);
    EXPECT_NEAR(height[2], height[0], 1e-3);
}

} // namespace
} // namespace fpm::test
