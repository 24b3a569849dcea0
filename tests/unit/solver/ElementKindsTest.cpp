#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <random>

// Elements beyond the plain ones: every kind runs alike in every vector width and on any number of
// threads, sees a uniform stress in a distorted mesh at finite strain, and keeps its energy.

namespace fpm::test {
namespace {

struct Kind {
    std::string name;
    RotationForm rotation;
    HexahedronForm hexahedron = HexahedronForm::reduced;
};

void PrintTo(const Kind& kind, std::ostream* out)
{
    *out << kind.name;
}

Part partOf(const Kind& kind, PartKind law, HourglassForm form = HourglassForm::stiffness)
{
    Part part = aluminium(law, form);
    part.rotation = kind.rotation;
    part.hexahedron = kind.hexahedron;
    return part;
}

const Kind kinds[] = {{"polar", RotationForm::polar},
                      {"hughesWinget", RotationForm::hughesWinget},
                      {"selective", RotationForm::hughesWinget, HexahedronForm::selective}};

class ElementKinds : public testing::TestWithParam<Kind>
{};

/// A plastic block strikes an elastic one and slides with friction.
Model impact(const Kind& kind, HourglassForm form, Precision precision)
{
    Model model = twoBlocks(partOf(kind, PartKind::elastoplastic, form),
                            partOf(kind, PartKind::elastic), {3e4, -2e4, -1e5}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    model.control.precision = precision;
    return model;
}

std::uint64_t checksumOf(Model model, int threads, const char* simd)
{
    model.control.backend = threads > 1 ? "openmp" : "serial";
    model.control.threads = threads;
    model.control.simd = simd;
    const auto solver = startedSolver(model);
    solver->advance(1, 150);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_GT(solver->ledger().energies().plastic, 0);
    return stateChecksum(*solver);
}

TEST_P(ElementKinds, VectorWidthAndThreadsDoNotChangeTheState)
{
    const HourglassForm forms[] = {HourglassForm::physical, HourglassForm::stiffness,
                                   HourglassForm::viscous};
    const Precision precisions[] = {Precision::double_, Precision::mixed, Precision::single};
    for (int i = 0; i < 3; ++i) {
        const Model model = impact(GetParam(), forms[i], precisions[i]);
        const std::uint64_t scalar = checksumOf(model, 1, "scalar");
        EXPECT_EQ(checksumOf(model, 1, "avx2"), scalar);
        EXPECT_EQ(checksumOf(model, 2, "auto"), scalar);
    }
}

// Benchmark A1, variant 2: x = F X in 200 steps; all elements see one deformation gradient.
TEST_P(ElementKinds, ADistortedMeshHasUniformStressAtFiniteStrain)
{
    Model model = boxModel({3, 3, 3}, {1, 1, 1}, partOf(GetParam(), PartKind::elastic));
    model.parts[0].linearBulkViscosity = model.parts[0].quadraticBulkViscosity = 0;
    const double gradient[3][3] = {{0.2, 0.3, 0}, {0, -0.1, 0.1}, {0.05, 0, 0.1}};
    std::mt19937 random(8);
    std::uniform_real_distribution<double> shift(-0.05, 0.05);
    const double time = 200 * 2e-8;
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        Point& p = model.mesh.points[i];
        bool outside = false;
        for (const double x : p) outside |= x < 0.01 || x > 0.99;
        if (!outside)
            for (double& x : p) x += shift(random);
        Point velocity{0, 0, 0};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k) velocity[c] += gradient[c][k] * p[k] / time;
        model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "drive",
                                                     {Index(i)}, {true, true, true}, velocity));
    }
    model.control.fixedTimeStep = 2e-8;
    const auto solver = startedSolver(model);
    solver->advance(time, 1000);
    ASSERT_FALSE(solver->clock().failed);
    EXPECT_EQ(solver->clock().steps, 200);
    const std::vector<double> stress = solver->elements().values().stress;
    double spread = 0;
    for (std::size_t i = 6; i < stress.size(); ++i)
        spread = std::max(spread, std::abs(stress[i] - stress[i % 6]));
    EXPECT_LT(spread, 1e-10 * largestStress(*solver));
    double inner = 0;
    const NodeValues values = solver->nodes().values({});
    for (std::size_t i = 0; i < values.count; ++i) {
        bool outside = false;
        for (const double x : model.mesh.points[i]) outside |= x < 0.01 || x > 0.99;
        if (outside) continue;
        for (const double f : values.at(3, i)) inner = std::max(inner, std::abs(f));
    }
    EXPECT_LT(inner, 1e-10 * largestStress(*solver) / 9); // of the stress on a face
}

TEST_P(ElementKinds, AFreeBlockThatVibratesAndTurnsKeepsItsEnergy)
{
    Model model = boxModel({3, 3, 3}, {3, 3, 3}, partOf(GetParam(), PartKind::elastic));
    model.parts[0].linearBulkViscosity = model.parts[0].quadraticBulkViscosity = 0;
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const Point& p = model.mesh.points[i];
        model.initialVelocities.push_back(
            {"",
             {Index(i)},
             {-3e4 * (p[1] - 1.5) + 1e4 * p[0], 3e4 * (p[0] - 1.5), 5e3 * p[2] * p[0]}});
    }
    const auto solver = startedSolver(model, true);
    solver->advance(1, 3000);
    ASSERT_FALSE(solver->clock().failed);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 2e-3);
}

std::string kindName(const testing::TestParamInfo<Kind>& info)
{
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, ElementKinds, testing::ValuesIn(kinds), kindName);

// What a part does not use takes no memory.
TEST(ElementMemory, HoldsOnlyWhatThePartKeeps)
{
    const auto bytes = [](PartKind law, HourglassForm form) {
        return makeSolver(boxModel({16, 1, 1}, {16, 1, 1}, aluminium(law, form)))->fields().bytes();
    };
    const std::size_t stiffness = bytes(PartKind::elastoplastic, HourglassForm::stiffness);
    EXPECT_EQ(stiffness - bytes(PartKind::elastoplastic, HourglassForm::viscous), 16 * 12 * 8u);
    EXPECT_EQ(stiffness - bytes(PartKind::elastic, HourglassForm::stiffness), 16 * 8u);
}

TEST(ElementMemory, ASelectiveElementHoldsEightStressesAndEightPlasticStrains)
{
    const auto bytes = [](HexahedronForm form) {
        Part part = aluminium(PartKind::elastoplastic, HourglassForm::viscous);
        part.hexahedron = form;
        return makeSolver(boxModel({16, 1, 1}, {16, 1, 1}, part))->fields().bytes();
    };
    EXPECT_EQ(bytes(HexahedronForm::selective) - bytes(HexahedronForm::reduced), 16 * 7 * 7 * 8u);
}

} // namespace
} // namespace fpm::test
