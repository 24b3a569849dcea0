#include "model/ControlReader.h"

#include "support/logFile.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

Control read(const std::string& text)
{
    Log log = Log::quiet();
    return readControl(Dictionary::parse(text), log);
}

std::vector<History> readFunctions(const std::string& text, Log log = Log::quiet())
{
    BoundaryCondition press;
    press.name = "press";
    press.kind = BoundaryCondition::Kind::velocity;
    press.nodes = {1, 2};
    BoundaryCondition weight;
    weight.name = "weight";
    weight.kind = BoundaryCondition::Kind::force;
    Model model;
    model.mesh = test::boxMesh({{"rod", {0, 0, 0}, {1, 1, 1}}});
    model.boundaryConditions = {press, weight};
    model.parts = {Part{}};
    model.rigidSurfaces.resize(2);
    model.rigidSurfaces[0].name = "wall";
    model.rigidSurfaces[1].name = "upperDie";
    return readHistories(Dictionary::parse("functions { " + text + " }"), model, log);
}

} // namespace

TEST(ControlReader, NeedsNothingButTheEndTime)
{
    const Control control = read("endTime 2;");

    EXPECT_EQ(control.endTime, 2);
    EXPECT_EQ(control.writeInterval, 0.2);
    EXPECT_EQ(control.historyInterval, 0.002);
    EXPECT_EQ(control.timeStepSafety, 0.9);
    EXPECT_EQ(control.backend, "openmp");
    EXPECT_EQ(control.assembly, Assembly::patch);
    EXPECT_TRUE(control.midStepStrain);
    EXPECT_EQ(control.previousRun, "keep");
}

TEST(ControlReader, ReadsWhatIsSaid)
{
    const Control control =
        read("endTime 2; timeStep { safety 0.5; contactLimit 0.7; fixed 1e-3; beyondBound go; } "
             "precision mixed; searchInterval 7; strainGeometry start; assembly gather; threads 3; "
             "energyBalance { "
             "warning 0.1; stop "
             "0.2; } previousRun remove;");

    EXPECT_EQ(control.timeStepSafety, 0.5);
    EXPECT_EQ(control.contactStepLimit, 0.7);
    EXPECT_EQ(control.fixedTimeStep, 1e-3);
    EXPECT_TRUE(control.beyondBound);
    EXPECT_EQ(control.searchInterval, 7);
    EXPECT_EQ(control.precision, Precision::mixed);
    EXPECT_EQ(control.assembly, Assembly::gather);
    EXPECT_FALSE(control.midStepStrain);
    EXPECT_EQ(control.threads, 3);
    EXPECT_EQ(control.energyStop, 0.2);
    EXPECT_EQ(control.previousRun, "remove");
}

TEST(ControlReader, QuasiStaticToolsAreOffUnlessGiven)
{
    const Control off = read("endTime 2;");
    EXPECT_EQ(off.kineticShare, 0);
    EXPECT_EQ(off.relaxationTolerance, 0);
    const Control preset = read("endTime 2; quasiStatic { } dynamicRelaxation { }");
    EXPECT_EQ(preset.kineticShare, 0.05);
    EXPECT_EQ(preset.quasiStaticAfter, 0.2);
    EXPECT_EQ(preset.relaxationTolerance, 1e-3);
    const Control given = read("endTime 2; quasiStatic { kineticShare 0.1; after 1; } "
                               "dynamicRelaxation { tolerance 1e-4; }");
    EXPECT_EQ(given.kineticShare, 0.1);
    EXPECT_EQ(given.quasiStaticAfter, 1);
    EXPECT_EQ(given.relaxationTolerance, 1e-4);
    EXPECT_TRUE(contains(refusal([] { read("endTime 2; dynamicRelaxation { tolerance 1; }"); }),
                         "tolerance"));
}

TEST(ControlReader, ScalesTheMassOfTheChosenParts)
{
    const auto scaled = [](const std::string& text) {
        std::vector<Part> parts(3);
        parts[0].name = "rod";
        parts[1].name = "plate";
        parts[2].name = "die";
        parts[2].kind = PartKind::rigidPrescribed;
        readMassScaling(Dictionary::parse(text), parts);
        return parts;
    };
    EXPECT_EQ(scaled("")[0].massFactor, 1);
    const auto all = scaled("massScaling { factor 100; targetStep 1e-6; }");
    EXPECT_EQ(all[0].massFactor, 100);
    EXPECT_EQ(all[1].targetStep, 1e-6);
    EXPECT_EQ(all[2].massFactor, 1);
    const auto one = scaled("massScaling { targetStep 1e-6; parts (plate); }");
    EXPECT_EQ(one[0].targetStep, 0);
    EXPECT_EQ(one[1].targetStep, 1e-6);
    const auto refused = [&](const std::string& text) { return refusal([&] { scaled(text); }); };
    EXPECT_TRUE(contains(refused("massScaling { parts (die); }"), "no part 'die'"));
    EXPECT_TRUE(contains(refused("massScaling { parts (plat); }"), "plate"));
    EXPECT_TRUE(contains(refused("massScaling { factor 0.5; }"), "factor"));
}

TEST(ControlReader, NamesTheKeysOfOpenFoamThatHaveNoEffect)
{
    const test::CaseFolder folder;
    {
        Log log = test::logInto(folder.logFile());
        readControl(Dictionary::parse("application fpmExplicit; startFrom startTime; startTime 0; "
                                      "stopAt endTime; endTime 1; writeControl runTime; "
                                      "writeFormat ascii; timePrecision 6; purgeWrite 0;"),
                    log);
    }

    EXPECT_TRUE(contains(folder.logText(), "accepted without effect: writeFormat, timePrecision"));
}

TEST(ControlReader, RefusesValuesItCouldNotHonour)
{
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; startFrom firstTime;"); }), "latestTime"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; startFrom -2;"); }), ">= 0"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; stopAt now;"); }), "noWriteNow"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; writeControl cpuTime;"); }), "clockTime"));
    EXPECT_TRUE(
        contains(refusal([] { read("endTime 1; writeControl timeStep;"); }), "writeInterval"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; checkpoint { keep -1; }"); }), "keep"));
    for (const char* step : {"deltaT 1e-8;", "adjustTimeStep yes;", "maxCo 0.5;"})
        EXPECT_TRUE(contains(refusal([&] { read("endTime 1; " + std::string(step)); }),
                             "the time step follows from stability"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; writeInterval 1e-20;"); }), "1e+20 frames"));
    EXPECT_TRUE(
        contains(refusal([] { read("endTime 1e9; historyInterval 1e-9;"); }), "historyInterval 0"));
}

TEST(ControlReader, StartsFromTheBeginningACheckpointOrTheLatest)
{
    EXPECT_FALSE(read("endTime 1;").latest);
    EXPECT_EQ(read("endTime 1;").startTime, 0);
    EXPECT_TRUE(read("endTime 1; startFrom latestTime;").latest);
    EXPECT_EQ(read("endTime 1; startFrom startTime; startTime 0.5;").startTime, 0.5);
    EXPECT_EQ(read("endTime 1; startFrom 0.25;").startTime, 0.25);
}

TEST(ControlReader, ReadsWhenToWriteAndWhenToStop)
{
    const Control preset = read("endTime 1;");
    EXPECT_EQ(preset.checkpoint, (CheckpointControl{600, 0, 2}));
    EXPECT_EQ(preset.stopAt, StopAt::endTime);
    EXPECT_FALSE(preset.runTimeModifiable);
    const Control given = read("endTime 1; stopAt nextWrite; maxWallTime 3600; runTimeModifiable "
                               "yes; writeControl timeStep; writeInterval 100; purgeWrite 3; "
                               "checkpoint { wallInterval 60; steps 1000; keep 5; }");
    EXPECT_EQ(given.stopAt, StopAt::nextWrite);
    EXPECT_EQ(given.maxWallTime, 3600);
    EXPECT_TRUE(given.runTimeModifiable);
    EXPECT_EQ(given.writeControl, WriteControl::timeStep);
    EXPECT_EQ(given.writeInterval, 100);
    EXPECT_EQ(given.purgeWrite, 3);
    EXPECT_EQ(given.checkpoint, (CheckpointControl{60, 1000, 5}));
    EXPECT_EQ(read("endTime 1; writeControl adjustableRunTime;").writeControl,
              WriteControl::runTime);
}

TEST(ControlReader, RefusesTimesAndLimitsOutOfRange)
{
    EXPECT_TRUE(contains(refusal([] { read("endTime 0;"); }), "endTime"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; writeInterval 0;"); }), "writeInterval"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; timeStep { safety 1.5; }"); }), "safety"));
    EXPECT_TRUE(
        contains(refusal([] { read("endTime 1; timeStep { beyondBound go; }"); }), "fixed"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; timeStep { maximum 1; fixed 2; }"); }),
                         "fixed has no maximum"));
    EXPECT_TRUE(contains(refusal([] { read("endTime 1; energyBalance { stop 0.001; }"); }),
                         "would stop before it warns"));
}

TEST(HistoryReader, RecordsTheNodeNearestToAPoint)
{
    const auto histories =
        readFunctions("tip { type point; part rod; position (0.9 1 0.8); fields (velocity); }");

    ASSERT_EQ(histories.size(), 2u);
    EXPECT_EQ(histories[1].kind, History::Kind::energies) << "kept without being asked for";
    EXPECT_EQ(histories[0].node, 7); // corner (1 1 1)
    EXPECT_EQ(histories[0].fields, (std::vector<std::string>{"velocity"}));
}

TEST(HistoryReader, WarnsOfAPointFarFromItsPart)
{
    const test::CaseFolder folder;
    readFunctions("tip { type point; part rod; position (5 0 0); }",
                  test::logInto(folder.logFile()));

    EXPECT_TRUE(contains(folder.logText(), "node 1 at (1 0 0), 4 from the requested position"));
    EXPECT_TRUE(contains(folder.logText(), "warning: history tip"));
}

TEST(HistoryReader, SumsAReactionOverTheNodesOfItsCondition)
{
    EXPECT_EQ(readFunctions("f { type reaction; condition press; }")[0].nodes,
              (std::vector<Index>{1, 2}));
}

TEST(HistoryReader, TakesTheReactionOfAnAnalyticSurfaceAndAFactor)
{
    const History die = readFunctions("f { type reaction; surface upperDie; factor 4; }")[0];
    EXPECT_EQ(die.surface, 1);
    EXPECT_EQ(die.condition, -1);
    EXPECT_EQ(die.factor, 4);
    EXPECT_EQ(readFunctions("f { type reaction; condition press; }")[0].condition, 0);
    EXPECT_TRUE(contains(refusal([] { readFunctions("f { type reaction; surface uperDie; }"); }),
                         "did you mean 'upperDie'?"));
    EXPECT_TRUE(contains(
        refusal([] { readFunctions("f { type reaction; surface wall; condition press; }"); }),
        "both 'condition' and 'surface' are given"));
    EXPECT_TRUE(contains(
        refusal([] { readFunctions("f { type reaction; surface wall; factor 0; }"); }), "factor"));
}

TEST(HistoryReader, RefusesWhatIsNotThere)
{
    EXPECT_TRUE(
        contains(refusal([] { readFunctions("t { type point; part rodd; position (0 0 0); }"); }),
                 "the mesh has no part 'rodd'"));
    EXPECT_TRUE(contains(refusal([] { readFunctions("f { type reaction; condition pres; }"); }),
                         "did you mean 'press'?"));
    EXPECT_TRUE(contains(refusal([] { readFunctions("f { type reaction; condition weight; }"); }),
                         "only what is held or driven has a reaction"));
    EXPECT_TRUE(contains(refusal([] {
                             readFunctions(
                                 "t { type point; part rod; position (0 0 0); fields (velocty); }");
                         }),
                         "did you mean 'velocity'?"));
}

TEST(HistoryReader, RefusesANameThatCouldLeaveTheCase)
{
    EXPECT_FALSE(refusal([] { readFunctions("\"../x\" { type energies; }"); }).empty());
}

TEST(ControlReader, RefusesTheMotionOfABodyThatIsNotRigidFree)
{
    EXPECT_TRUE(contains(refusal([] { readFunctions("a { type rigidBody; part rod; }"); }),
                         "part 'rod' is not rigidFree"));
}

TEST(HistoryReader, TakesThePartWhoseMomentumIsAsked)
{
    const History motion = readFunctions("a { type part; part rod; }")[0];
    EXPECT_EQ(motion.kind, History::Kind::part);
    EXPECT_EQ(motion.part, 0);
    EXPECT_TRUE(contains(refusal([] { readFunctions("a { type part; part rood; }"); }),
                         "the mesh has no part 'rood'"));
}
