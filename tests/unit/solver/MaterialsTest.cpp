#include "mesh/Quality.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

// The laws beyond linear elasticity and plain J2 plasticity, through the solver.

namespace fpm::test {
namespace {

struct Law {
    std::string name;
    HourglassForm form;
    Flow flow;
    ElementErosion erosion = {};
    HourglassPlastic plastic = HourglassPlastic::coupled;
};

void PrintTo(const Law& law, std::ostream* out)
{
    *out << law.name;
}

/// Units: tonne, mm, s, MPa, K.
std::vector<Law> laws()
{
    Flow kinematic, viscous, hot;
    kinematic.kinematicModulus = 900;
    viscous.rate = RateDependence::cowperSymonds;
    viscous.referenceRate = 6500;
    viscous.rateCoefficient = 0.25;
    hot.powerModulus = 292;
    hot.powerExponent = 0.31;
    hot.rate = RateDependence::johnsonCook;
    hot.referenceRate = 1;
    hot.rateCoefficient = 0.025;
    hot.softeningExponent = 1.09;
    hot.meltingTemperature = 900;
    hot.heatFraction = 0.9;
    hot.specificHeat = 9e8;
    return {{"kinematic", HourglassForm::physical, kinematic},
            {"cowperSymonds", HourglassForm::stiffness, viscous},
            {"johnsonCook", HourglassForm::viscous, hot},
            {"erosion", HourglassForm::stiffness, {}, {0.02, true}},
            {"elasticBending", HourglassForm::physical, {}, {}, HourglassPlastic::elastic}};
}

Part partOf(const Law& law)
{
    Part part = aluminium(PartKind::elastoplastic, law.form);
    part.flow = law.flow;
    part.erosion = law.erosion;
    part.hourglassPlastic = law.plastic;
    return part;
}

class Materials : public testing::TestWithParam<Law>
{};

/// A block of the law strikes an elastic one and slides with friction.
Model impact(const Law& law, Precision precision)
{
    Model model = twoBlocks(partOf(law), aluminium(PartKind::elastic, HourglassForm::stiffness),
                            {3e4, -2e4, -2e5}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    model.control.precision = precision;
    return model;
}

std::uint64_t checksumOf(Model model, int threads, const char* simd, bool erodes)
{
    model.control.backend = threads > 1 ? "openmp" : "serial";
    model.control.threads = threads;
    model.control.simd = simd;
    const auto solver = startedSolver(model);
    solver->advance(1, 200);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_GT(solver->ledger().energies().plastic, 0);
    EXPECT_EQ(solver->clock().deletions > 0, erodes);
    EXPECT_LT(std::abs(solver->ledger().energies().balance), 0.01);
    return stateChecksum(*solver);
}

TEST_P(Materials, VectorWidthAndThreadsDoNotChangeTheState)
{
    for (const Precision precision : {Precision::double_, Precision::single}) {
        const Model model = impact(GetParam(), precision);
        const bool erodes = GetParam().erosion.any();
        const std::uint64_t scalar = checksumOf(model, 1, "scalar", erodes);
        EXPECT_EQ(checksumOf(model, 1, "avx2", erodes), scalar);
        EXPECT_EQ(checksumOf(model, 2, "auto", erodes), scalar);
        if (__builtin_cpu_supports("x86-64-v4")) {
            EXPECT_EQ(checksumOf(model, 1, "avx512", erodes), scalar);
        }
    }
}

std::string lawName(const testing::TestParamInfo<Law>& info)
{
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Laws, Materials, testing::ValuesIn(laws()), lawName);

TEST(AdiabaticHeating, TheHeatOfAllElementsIsTheirShareOfThePlasticWork)
{
    const Law law = laws()[2];
    const auto plain = startedSolver(impact(law, Precision::double_));
    plain->advance(1, 1);
    for (const int scaling : {0, 1, 2}) // what mass scaling adds takes no heat
        for (const HexahedronForm form : {HexahedronForm::reduced, HexahedronForm::selective}) {
            Model model = impact(law, Precision::double_);
            for (Part& part : model.parts) {
                part.hexahedron = form;
                if (scaling == 1) part.massFactor = 3;
                if (scaling == 2) part.targetStep = 2 * plain->clock().elementStep;
            }
            const auto solver = startedSolver(model);
            solver->advance(1, 400);
            EXPECT_EQ(solver->elements().setUp().scaled > 0, scaling > 0);
            const ElementValues values = solver->elements().values();
            double heat = 0, most = 0;
            for (Index e = 0; e < solver->elements().setUp().count; ++e) {
                const Part& part = model.parts[std::size_t(model.mesh.partOf(e))];
                const double mass = part.density * volume(model.mesh, e),
                             rise = values.temperature[std::size_t(e)] - 293;
                heat += mass * law.flow.specificHeat * rise;
                most = std::max(most, rise);
            }
            // The mean over eight points is not weighted by their volumes.
            const double expected = law.flow.heatFraction * solver->ledger().energies().plastic;
            EXPECT_GT(most, 1);
            EXPECT_NEAR(heat, expected, (form == HexahedronForm::reduced ? 1e-9 : 0.02) * expected);
        }
}

TEST(MaterialMemory, ABackstressIsSixValuesAndATemperatureOne)
{
    const auto bytes = [](const Flow& flow) {
        Part part = aluminium(PartKind::elastoplastic, HourglassForm::stiffness);
        part.flow = flow;
        return makeSolver(boxModel({16, 1, 1}, {16, 1, 1}, part))->fields().bytes();
    };
    Flow kinematic, heats;
    kinematic.kinematicModulus = 1;
    heats.heatFraction = 0.9;
    heats.specificHeat = 9e8;
    EXPECT_EQ(bytes(kinematic) - bytes({}), 16 * 6 * 8u);
    EXPECT_EQ(bytes(heats) - bytes({}), 16 * 8u);
}

// Benchmark B5: a piston at 50 m/s against a half space of aluminium in uniaxial strain: an elastic
// precursor at the yield limit, behind it the slower plastic front.
struct Waves {
    double plateau = 0, plasticStrain = 0, elasticFront = 0, plasticFront = 0;
};

Waves waves(const Flow& flow, std::vector<Hardening> hardening)
{
    Part part = aluminium(PartKind::elastoplastic, HourglassForm::stiffness);
    part.flow = flow;
    part.hardening = hardening;
    const Index cells = 200;
    const double length = 200, speed = 5e4;
    Model model = boxModel({cells, 1, 1}, {length, 1, 1}, part);
    const std::vector<Index> all = nodesWhere(model.mesh, [](Point) { return true; });
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::fixed, "uniaxial", all, {false, true, true}));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::velocity, "piston",
                  nodesWhere(model.mesh, [](Point p) { return p[0] < 1e-9; }), {true, false, false},
                  {speed, 0, 0}));
    const double time = 28e-6;
    const auto solver = startedSolver(model);
    solver->advance(time, 1000000);
    EXPECT_FALSE(solver->clock().failed);
    const ElementValues values = solver->elements().values();
    const NodeValues nodes = solver->nodes().values({});
    // Cells along the bar, by their place in the undeformed mesh.
    std::vector<std::array<double, 3>> cell;
    for (Index e = 0; e < cells; ++e) {
        double place = 0;
        for (const Index node : model.mesh.hexahedra[std::size_t(e)])
            place += model.mesh.points[std::size_t(node)][0] / 8;
        cell.push_back(
            {place, -values.stress[6 * std::size_t(e)], values.plasticStrain[std::size_t(e)]});
    }
    std::sort(cell.begin(), cell.end());
    Waves out;
    int count = 0;
    for (const auto& [place, stress, strain] : cell)
        if (place > 20 && place < 100) {
            out.plateau += stress;
            out.plasticStrain += strain;
            ++count;
        }
    out.plateau /= count;
    out.plasticStrain /= count;
    // Where a front is half done, from the far end.
    const auto front = [&](double level) {
        for (std::size_t i = cell.size() - 1; i > 0; --i)
            if (cell[i - 1][1] >= level && cell[i][1] < level) {
                const double share = (level - cell[i][1]) / (cell[i - 1][1] - cell[i][1]);
                return (cell[i][0] + share * (cell[i - 1][0] - cell[i][0])) / time;
            }
        return 0.0;
    };
    out.elasticFront = front(498.75 / 2);
    out.plasticFront = front((498.75 + out.plateau) / 2);
    return out;
}

TEST(ElasticPlasticWaves, TheFrontsRunAndThePlateauStandsAsTheoryHasIt)
{
    Flow kinematic;
    kinematic.kinematicModulus = 900; // under monotonic load no different
    for (const bool moves : {false, true}) {
        const Waves got =
            moves ? waves(kinematic, {{0, 285}, {1, 285}}) : waves({}, {{0, 285}, {1, 1185}});
        EXPECT_NEAR(got.plateau, 734.63, 0.02 * 734.63);
        EXPECT_NEAR(got.plasticStrain, 0.002648, 0.03 * 0.002648);
        EXPECT_NEAR(got.elasticFront, 5907.65e3, 0.02 * 5907.65e3);
        EXPECT_NEAR(got.plasticFront, 4663.85e3, 0.02 * 4663.85e3);
    }
}

} // namespace
} // namespace fpm::test
