// The GPU against the CPU, to the last bit: every kernel in every precision, on scenes of seconds.
// FPM_PARITY_BACKEND names another backend to compare (openmp), so that these scenes are tried
// where there is no GPU.

#include "base/Error.h"
#include "unit/solver/kindScenes.h"

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

/// A block strikes a larger one and slides; several patches.
Model impact(PartKind kind, HourglassForm form)
{
    Model model =
        twoBlocks(aluminium(kind, form), aluminium(PartKind::elastic, HourglassForm::stiffness),
                  {3e4, -2e4, -1e5}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    return model;
}

Model plain()
{
    return impact(PartKind::elastoplastic, HourglassForm::physical);
}

struct Scene {
    std::string name;
    Model model;
};

/// Elements and materials: one scene a kernel, and the options of the general one.
void addElements(std::vector<Scene>& scenes)
{
    for (const auto& [name, form] : {std::pair{"stiffness", HourglassForm::stiffness},
                                     std::pair{"viscous", HourglassForm::viscous},
                                     std::pair{"physical", HourglassForm::physical}})
        for (const PartKind kind : {PartKind::elastic, PartKind::elastoplastic}) {
            const std::string material = kind == PartKind::elastic ? "elastic " : "plastic ";
            scenes.push_back({material + name, impact(kind, form)});
            scenes.push_back({"polar " + material + name, impact(kind, form)});
            scenes.back().model.parts[1].rotation = RotationForm::polar;
        }
    Model selective = plain();
    selective.parts[1].hexahedron = HexahedronForm::selective;
    selective.parts[1].rotation = RotationForm::hughesWinget;
    scenes.push_back({"selective", selective});
    Model general = plain();
    Flow& flow = general.parts[1].flow;
    flow.kinematicModulus = 500;
    flow.rate = RateDependence::johnsonCook;
    flow.referenceRate = 1;
    flow.rateCoefficient = 0.01;
    flow.heatFraction = 0.9;
    flow.specificHeat = 9e8;
    flow.softeningExponent = 1;
    flow.meltingTemperature = 900;
    general.parts[1].hourglassPlastic = HourglassPlastic::tangent;
    scenes.push_back({"kinematic, rate, heat", general});
    Model floats = plain();
    for (Part& part : floats.parts) part.hourglassStorage = HourglassStorage::float_;
    scenes.push_back({"hourglass forces as float", floats});
    Model eroding = plain();
    eroding.parts[1].erosion.plasticStrain = 0.02;
    scenes.push_back({"erosion", eroding});
    Model scaled = plain();
    for (Part& part : scaled.parts) part.massFactor = 4;
    scenes.push_back({"mass scaling", scaled});
}

/// Kinds of contact, laws and searches.
void addContacts(std::vector<Scene>& scenes)
{
    Model twice = plain(), all = plain(), fold = closingFold(), paper = plain(), damped = plain();
    twice.contactPairs[0].passes = 2;
    scenes.push_back({"two passes", twice});
    all.mesh.contact.clear();
    all.contactPairs.clear();
    addGeneral(all).friction = 0.3;
    scenes.push_back({"general contact", all});
    const std::vector<ElementSide> sides = skin(fold.mesh, 0);
    addContact(fold, "own", sides, sides).kind = ContactKind::self;
    scenes.push_back({"self-contact", fold});
    for (Part& part : paper.parts) part.rotation = RotationForm::arcsine;
    paper.control.midStepStrain = false;
    ContactPair& pair = paper.contactPairs[0];
    pair.search = ContactSearch::closestParticle;
    pair.projection = ContactProjection::cold;
    pair.paperFriction = true;
    scenes.push_back({"algorithm of the paper", paper});
    damped.contactPairs[0].normalDamping = 0.2;
    damped.contactPairs[0].dynamicFriction = 0.1;
    damped.contactPairs[0].frictionDecay = 1e-5;
    scenes.push_back({"contact damping, decaying friction", damped});

    Model wall = plain();
    wall.mesh.contact.clear();
    wall.contactPairs.clear();
    RigidSurface surface;
    surface.name = "wall";
    addContact(wall, "wall", facing(wall.mesh, "upper", {0, 0, -1}), {}).surface = 0;
    wall.contactPairs[0].friction = 0.2;
    wall.rigidSurfaces.push_back(surface);
    scenes.push_back({"analytic wall", wall});
}

/// Drives, loads, damping, free rigid bodies, relaxation.
void addMotions(std::vector<Scene>& scenes)
{
    using Kind = BoundaryCondition::Kind;
    Model body = plain();
    body.parts[1].kind = PartKind::rigidFree;
    body.initialVelocities[0].part = 1;
    scenes.push_back({"free rigid body", body});
    Model driven = plain();
    driven.control.massDamping = 100;
    const auto top = nodesWhere(driven.mesh, [](Point p) { return p[2] > 5.99; });
    driven.boundaryConditions.push_back(
        condition(Kind::velocity, "push", top, {true, false, true}, {1e4, 0, -1e5}));
    BoundaryCondition weight = condition(Kind::gravity, "weight", {}, {}, {0, 0, -1e9});
    weight.parts = {0, 1};
    driven.boundaryConditions.push_back(weight);
    BoundaryCondition press = condition(Kind::pressure, "press", {}, {}, {200, 0, 0});
    press.sides = facing(driven.mesh, "upper", {1, 0, 0});
    driven.boundaryConditions.push_back(press);
    scenes.push_back({"drive, gravity, pressure, damping", driven});
    Model relaxing = plain();
    relaxing.control.relaxationTolerance = 1e-6;
    scenes.push_back({"dynamic relaxation", relaxing});
}

std::vector<Scene> scenes()
{
    std::vector<Scene> all;
    addElements(all);
    addContacts(all);
    addMotions(all);
    return all;
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
