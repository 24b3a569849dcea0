#include "run/RunForecast.h"

#include "run/StepSetters.h"
#include "run/resultFrame.h"
#include "support/logFile.h"
#include "unit/model/CaseFolder.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

Model cube()
{
    Model model =
        boxModel({4, 4, 4}, {4, 4, 4}, aluminium(PartKind::elastic, HourglassForm::physical));
    model.control.endTime = 1e-3;
    model.control.writeInterval = 1e-4;
    model.control.historyInterval = 1e-6;
    History energies;
    energies.name = "energies";
    model.control.histories = {energies};
    return model;
}

RunForecast forecastOf(const Model& model, double step, std::int64_t maxSteps = -1)
{
    const CaseFolder folder;
    return forecastRun(*startedSolver(model), model, folder.root(), step, maxSteps);
}

std::string report(const RunForecast& forecast, double aStep)
{
    const CaseFolder folder;
    {
        Log log = test::logInto(folder.logFile());
        reportForecast(forecast, aStep, log);
    }
    return folder.logText();
}

TEST(RunForecast, CountsStepsFramesAndRows)
{
    Model model = cube();
    RunForecast forecast = forecastOf(model, 1e-7);
    EXPECT_EQ(forecast.steps, 1e4);
    EXPECT_EQ(forecast.frames, 11);
    EXPECT_GT(forecast.historyBytes, 1000 * 14 * 10);
    EXPECT_EQ(forecastOf(model, 1e-7, 2500).frames, 1 + 3);
    // Each frame ends a step: of 1e-5 it takes more than 1e-3 / 1e-5 where frames lie 1.5e-5 apart.
    model.control.writeInterval = 1.5e-5;
    forecast = forecastOf(model, 1e-5);
    EXPECT_EQ(forecast.ownSteps, 100);
    EXPECT_EQ(forecast.steps, 2 * 67);
    model.control.writeInterval = 1e-6;
    forecast = forecastOf(model, 1e-5);
    EXPECT_EQ(forecast.steps, 1000);
    EXPECT_EQ(forecast.frames, 1001);
}

TEST(RunForecast, KnowsTheSizeOfAFrame)
{
    const Model model = cube();
    const CaseFolder folder;
    folder.write(model.mesh);
    const auto solver = startedSolver(model);
    writeFrame(OutputFolder(folder.root()), "0", resultFrame(*solver, model),
               model.mesh.points.size(), model.mesh.hexahedra.size());
    const double file = double(std::filesystem::file_size(folder.root() / "0/fields.vtkhdf"));
    const double forecast = forecastOf(model, 1e-7).frameBytes; // in blocks, with the folder's own
    EXPECT_GT(forecast, file);
    EXPECT_LT(forecast, file + 3 * 4096);
}

TEST(RunForecast, WarnsOfFramesThatCostMoreThanSteps)
{
    Model model = cube();
    const auto warns = [&](double interval, double step, double aStep) {
        model.control.writeInterval = interval;
        return report(forecastOf(model, step), aStep).find("frames cost more") != std::string::npos;
    };
    EXPECT_TRUE(warns(1e-6, 1e-5, 0));     // ten frames a step, whatever a step costs
    EXPECT_TRUE(warns(1e-6, 1e-7, 1e-6));  // 5 s of frames, 10 ms of steps
    EXPECT_FALSE(warns(1e-6, 1e-7, 1e-2)); // 100 s of steps
    EXPECT_FALSE(warns(1e-4, 1e-7, 1e-6)); // a dozen frames are no matter
    EXPECT_FALSE(warns(1e-6, 1e-7, 0));    // not known yet
}

TEST(RunForecast, WarnsOfADiskAndAMemoryThatAreTooSmall)
{
    RunForecast forecast = forecastOf(cube(), 1e-7);
    EXPECT_EQ(report(forecast, 1e-3).find("warning"), std::string::npos);
    forecast.memoryBytes = 1e6;
    EXPECT_NE(report(forecast, 1e-3).find("of memory, 1 MB are there"), std::string::npos);
    forecast = forecastOf(cube(), 1e-7);
    forecast.freeBytes = 5e4;
    EXPECT_NE(report(forecast, 1e-3).find("50 kB free"), std::string::npos);
    EXPECT_NE(report(forecast, 1e-3).find("warning"), std::string::npos);
}

TEST(RunForecast, ARunThatTheDiskCannotHoldDoesNotBegin)
{
    Model model = cube();
    model.control.writeInterval = 1e-10; // 1e7 frames of 20 kB
    const CaseFolder folder;
    const auto solver = startedSolver(model);
    const double room = double(std::filesystem::space(folder.root()).available);
    if (room > 1e7 * 16e3) GTEST_SKIP() << "the disk holds " << room << " bytes";
    Log log = Log::quiet();
    EXPECT_THROW(reportStart(*solver, model, folder.root(), -1, log), Error);
    EXPECT_NO_THROW(reportStart(*solver, model, folder.root(), 10, log));
}

TEST(RunForecast, EndlessRunsAreReported)
{
    Control control;
    control.endTime = 1;
    StepClock clock;
    clock.steps = 100;
    clock.time = 0.5;
    clock.stableStep = clock.step = 1e-7;
    EXPECT_EQ(endlessReason(clock, control, -1), "");
    clock.stableStep = 1e-16;
    EXPECT_NE(endlessReason(clock, control, -1).find("would take"), std::string::npos);
    EXPECT_EQ(endlessReason(clock, control, 1000), "");
    clock.stableStep = 1e-18;
    EXPECT_NE(endlessReason(clock, control, 1000).find("too small to change"), std::string::npos);
    // A sliver of a step to a frame is no fault, nor is the last one.
    clock.stableStep = 1e-7;
    clock.step = 1e-20;
    EXPECT_EQ(endlessReason(clock, control, -1), "");
    control.fixedTimeStep = 1e-15;
    EXPECT_NE(endlessReason(clock, control, -1).find("would take"), std::string::npos);
    clock.time = 1;
    EXPECT_EQ(endlessReason(clock, control, -1), "");
}

TEST(RunForecast, StepsUntilATimeFarAwayAreANumber)
{
    StepClock clock;
    EXPECT_EQ(stepsUntil(clock, 1), 1);
    clock.step = 1e-3;
    EXPECT_EQ(stepsUntil(clock, 1), 1000);
    EXPECT_EQ(stepsUntil(clock, -1), 1);
    EXPECT_EQ(stepsUntil(clock, 1e18), std::int64_t(1e15));
}

/// Elements of length 1, the first tenth of one in a hundred thin.
Model barWithThinEnd()
{
    Model model =
        boxModel({100, 1, 1}, {100, 1, 1}, aluminium(PartKind::elastic, HourglassForm::physical));
    for (Point& p : model.mesh.points)
        if (p[0] < 1.5) p[0] = p[0] < 0.5 ? 0.9 : p[0];
    return model;
}

TEST(StepSetters, AreFoundWithTheirCostAndThePriceOfMassScaling)
{
    Model model = barWithThinEnd();
    const auto before = makeSolver(model);
    const auto setters = stepSetters(*before, model);
    ASSERT_TRUE(setters);
    EXPECT_EQ(setters->elements.count, 1u);
    EXPECT_GT(setters->elements.ratio(), 5);
    ASSERT_EQ(setters->prices.size(), 2u);
    for (const StepSetters::Price& price : setters->prices) {
        model.parts[0].targetStep = price.targetStep;
        const auto scaled = makeSolver(model);
        double own = 0, made = 0;
        for (std::size_t i = 0; i < scaled->nodes().setUp().mass.size(); ++i) {
            own += scaled->nodes().setUp().ownMass[i];
            made += scaled->nodes().setUp().mass[i];
        }
        EXPECT_NEAR(made / own - 1, price.addedMass, 1e-6);
        EXPECT_NEAR(firstStep(*scaled, model) / firstStep(*before, model), price.saves, 1e-6);
    }
    EXPECT_GT(setters->prices[1].saves, setters->prices[0].saves);
}

TEST(StepSetters, AnEvenMeshHasNone)
{
    const Model model = cube();
    EXPECT_FALSE(stepSetters(*makeSolver(model), model));
}

} // namespace
} // namespace fpm::test
