#include "stability/MapChart.h"
#include "stability/MapFile.h"
#include "stability/MapReport.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>

namespace fpm {
namespace {

const Scene& sceneOf(const std::string& name)
{
    for (const Scene& scene : probeScenes())
        if (scene.name == name) return scene;
    throw std::logic_error(name);
}

MapSpec stepMap()
{
    return readStabilityDict(Dictionary::parse(R"(
        maps { step { scene twoBars; steps 200;
                      x { parameter timeStepFactor; values (0.2 0.8 2.2); }
                      y { parameter normalScale; values (0.1 1 10); } } })"))
        .front();
}

StabilityMap emptyMap(const MapSpec& spec)
{
    StabilityMap map{spec, {}, {}};
    map.points.resize(spec.x.values.size() * spec.y.values.size());
    map.rows.resize(spec.y.values.size());
    return map;
}

TEST(StabilityMap, FailsBeyondTheEigenvalueAndNowhereThatIsPredictedStable)
{
    StabilityMap map = emptyMap(stepMap());
    completeMap(map, sceneOf("twoBars"), 2, [] {});
    for (std::size_t k = 0; k < map.points.size(); ++k) {
        const double factor = map.spec.x.values[k % 3];
        const Bounds& row = *map.rows[k / 3];
        const Outcome outcome = map.points[k]->result.outcome;
        EXPECT_GT(row.eigenvalue, row.withContact * 0.999) << "the bound is a bound";
        if (factor > 1.02 * row.eigenvalue) {
            EXPECT_EQ(outcome, Outcome::diverged) << k;
        }
        if (map.points[k]->predictedStable) {
            EXPECT_EQ(outcome, Outcome::stable) << k;
        }
    }
    EXPECT_TRUE(map.points[0]->predictedStable);
    EXPECT_FALSE(map.points[1]->predictedStable && map.points[7]->predictedStable);
    EXPECT_NE(conclusionOf(map).find("none does"), std::string::npos) << conclusionOf(map);
}

TEST(StabilityMap, GoesOnWhereItStoppedAndComesOutTheSame)
{
    const test::TemporaryFolder folder;
    const auto file = folder / "map.dat";
    const MapSpec spec = stepMap();
    const std::string key = mapKey(spec, "");
    StabilityMap whole = emptyMap(spec);
    completeMap(whole, sceneOf("twoBars"), 1, [] {});

    StabilityMap part = emptyMap(spec);
    struct Killed {};
    int saved = 0;
    EXPECT_THROW(completeMap(part, sceneOf("twoBars"), 1,
                             [&] {
                                 writeMap(OutputFolder(folder.path()), "map.dat", part, key);
                                 if (++saved == 7) throw Killed{}; // three rows, four points
                             }),
                 Killed);
    StabilityMap again = emptyMap(spec);
    readMap(file, again, key);
    EXPECT_EQ(again.done(), 4U);
    std::atomic<int> made{0};
    Scene counted = sceneOf("twoBars");
    counted.make = [&made, make = counted.make](const Setting& setting) {
        ++made;
        return make(setting);
    };
    completeMap(again, counted, 1, [] {});
    EXPECT_EQ(made, 5);
    for (std::size_t k = 0; k < whole.points.size(); ++k) {
        EXPECT_EQ(again.points[k]->result.outcome, whole.points[k]->result.outcome);
        const double now = again.points[k]->result.energyError,
                     before = whole.points[k]->result.energyError;
        EXPECT_TRUE(now == before || (std::isnan(now) && std::isnan(before))) << k;
    }
    StabilityMap other = emptyMap(spec);
    readMap(file, other, mapKey(spec, "changed"));
    EXPECT_EQ(other.done(), 0U);
}

TEST(StabilityMap, TakesNoPointFromADamagedRow)
{
    const test::TemporaryFolder folder;
    const MapSpec spec = stepMap();
    const std::string key = mapKey(spec, "");
    StabilityMap map = emptyMap(spec);
    for (auto& point : map.points) point = MapPoint{};
    writeMap(OutputFolder(folder.path()), "map.dat", map, key);
    const std::string good = test::readBytes(folder / "map.dat");
    const auto done = [&](const std::string& outcome) {
        std::string text = good;
        const auto row = text.find('\n', text.find(" done outcome")) + 1;
        std::size_t at = row; // of the fourth word
        for (int blanks = 0; blanks < 3; ++at) blanks += text[at] == ' ';
        text.replace(at, text.find(' ', at) - at, outcome);
        test::writeBytes(folder / "map.dat", text);
        StabilityMap again = emptyMap(spec);
        readMap(folder / "map.dat", again, key);
        return again.done();
    };

    const std::size_t all = map.points.size();
    EXPECT_EQ(done("0"), all);
    EXPECT_EQ(done("6"), all);
    for (const std::string outcome : {"7", "-1", "1.5", "nan", "1e300"})
        EXPECT_EQ(done(outcome), all - 1) << outcome;
}

TEST(StabilityMap, EverySceneIsStableAsItIs)
{
    for (const Scene& scene : probeScenes()) {
        const Trial trial = scene.make({});
        const TrialResult result = runTrial(trial, {}, boundsOf(trial.model), {});
        EXPECT_EQ(result.outcome, Outcome::stable)
            << scene.name << ": " << nameOf(result.outcome) << ", energy " << result.energyError;
        if (!trial.model.contactPairs.empty()) {
            EXPECT_GT(result.penetration, 0) << scene.name;
        }
    }
}

TEST(StabilityMap, TellsEachKindOfFailure)
{
    const auto outcome = [](const std::string& scene, const std::map<std::string, double>& values) {
        Setting setting;
        for (const auto& [name, value] : values) setting.set(name, value);
        Trial trial = sceneOf(scene).make(setting);
        applyCommon(trial.model, setting);
        return runTrial(trial, setting, boundsOf(trial.model), {}).outcome;
    };
    EXPECT_EQ(outcome("twoBars", {{parameter::timeStep, 2.5}}), Outcome::diverged);
    EXPECT_EQ(outcome("twoBars", {{parameter::penalty, 3}, {parameter::timeStep, 0.7}}),
              Outcome::energyDrift);
    EXPECT_EQ(outcome("twoBars", {{parameter::penalty, 3e-3}, {parameter::speed, 20}}),
              Outcome::penetration);
    EXPECT_EQ(outcome("twoBars",
                      {{parameter::gap, 0.6}, {parameter::speed, 50}, {parameter::search, 1000}}),
              Outcome::tunnelled);
}

/// A map of two rows, steps 0.2, 0.8 and 2.2; what is predicted: 1 and `quality`.
StabilityMap judgedMap(double quality)
{
    MapSpec spec = stepMap();
    spec.y.values = {1, 10};
    StabilityMap map = emptyMap(spec);
    for (auto& point : map.points) point = MapPoint{};
    for (auto& row : map.rows) row = Bounds{1e-7, 1, quality, 0};
    map.points[2]->result.outcome = map.points[5]->result.outcome = Outcome::diverged;
    return map;
}

TEST(MapReport, CallsABoundWhatNothingFailsBelow)
{
    StabilityMap map = judgedMap(0);
    const std::string text = conclusionOf(map);
    EXPECT_NE(text.find("failure begins at 2.2 to 2.2 of the bound from elements and contact"),
              std::string::npos)
        << text;
    EXPECT_NE(mapChart(map, "").find(">bound from elements and contact<"), std::string::npos);
}

TEST(MapReport, CallsNothingABoundThatFailsBelowIt)
{
    StabilityMap map = judgedMap(0);
    map.points[4]->result.outcome = Outcome::energyDrift;
    EXPECT_NE(conclusionOf(map).find("alone is no safe bound here: first failure at 0.8 of it "
                                     "(energy drift, normalScale 10)"),
              std::string::npos)
        << conclusionOf(map);
    const std::string svg = mapChart(map, "");
    EXPECT_NE(svg.find(">from elements and contact, fails at 0.8 of it<"), std::string::npos);
    EXPECT_EQ(svg.find(">bound from"), std::string::npos);

    map.points[3]->result.outcome = Outcome::penetration; // soft springs, at any step
    EXPECT_EQ(onsetOfContact(map)->least, 0.8);

    map = judgedMap(0.5);
    map.points[4]->result.outcome = Outcome::energyDrift;
    EXPECT_NE(conclusionOf(map).find("; with omega_c dt <= 0.8 it is one: failure begins at 1.6"),
              std::string::npos)
        << conclusionOf(map);
    map.points[3]->result.outcome = Outcome::inverted;
    EXPECT_NE(conclusionOf(map).find("; nor is it with omega_c dt <= 0.8: first failure at 0.4 of "
                                     "both (inverted, normalScale 10)"),
              std::string::npos)
        << conclusionOf(map);
}

TEST(MapReport, MarksTheCaseAndTellsItsMargin)
{
    StabilityMap map = judgedMap(0.5);
    EXPECT_EQ(ownSentence(map), "") << "a scene of its own";
    map.spec.scene = "case";
    EXPECT_NE(ownSentence(map).find("not on the map"), std::string::npos);
    EXPECT_EQ(mapChart(map, "").find(">this case<"), std::string::npos);
    map.own = OwnPoint{0.4, 3, {}, {1e-7, 1, 0.5, 0}};
    map.points[4]->result.outcome = Outcome::energyDrift;
    EXPECT_EQ(ownSentence(map),
              "this case: timeStepFactor 0.4, normalScale 3: stable; the step that is "
              "predicted to be stable is 0.5, 1.25 times as far; the first failure beside it is at "
              "timeStepFactor 0.8, "
              "normalScale 10, 2 times as far");
    EXPECT_NE(mapChart(map, "").find(">this case<"), std::string::npos);
    map.own->x = 0.9;
    EXPECT_NE(ownSentence(map).find("; not safe: timeStepFactor 0.8, normalScale 10 fails already"),
              std::string::npos)
        << ownSentence(map);
    map.own->y = 0.3; // below the lowest row
    EXPECT_NE(ownSentence(map).find("off the map"), std::string::npos);
    EXPECT_NE(ownSentence(map).find("at timeStepFactor 2.2, normalScale 1,"), std::string::npos)
        << ownSentence(map);
}

TEST(StabilityMap, FindsTheCaseOnItsMap)
{
    Trial trial = sceneOf("twoBars").make({});
    trial.model.contactPairs[0].normalScale = 2;
    MapSpec spec = stepMap();
    spec.scene = "case";
    const auto own = ownPoint(spec, caseScene(trial.model));
    ASSERT_TRUE(own);
    EXPECT_EQ(own->y, 2);
    // The step that fpmExplicit takes: 0.9 of the bound, or omega_c dt = 0.8.
    EXPECT_NEAR(own->x, std::min(0.9 * own->bounds.withContact, own->bounds.quality), 1e-9);
    EXPECT_EQ(own->point.result.outcome, Outcome::stable);
    EXPECT_TRUE(own->point.predictedStable);

    trial.model.contactPairs.push_back(trial.model.contactPairs[0]);
    trial.model.contactPairs[1].normalScale = 3;
    EXPECT_FALSE(ownValue(trial.model, parameter::penalty)) << "its pairs differ";
    EXPECT_EQ(ownValue(trial.model, parameter::search), 0);
    EXPECT_EQ(ownValue(trial.model, parameter::hourglass),
              trial.model.parts[0].hourglassCoefficient);
    EXPECT_FALSE(ownPoint(stepMap(), sceneOf("twoBars"))) << "no case";
}

TEST(MapChart, ShowsOutcomesAndBounds)
{
    StabilityMap map = emptyMap(stepMap());
    for (auto& point : map.points) point = MapPoint{};
    map.points[2]->result.outcome = Outcome::diverged;
    for (auto& row : map.rows) row = Bounds{1e-7, 0.8, 0.5, 1.2};
    const std::string svg = mapChart(map, "bars & steps");
    EXPECT_NE(svg.find("bars &amp; steps"), std::string::npos);
    EXPECT_NE(svg.find(">diverged<"), std::string::npos);
    EXPECT_EQ(svg.find(">inverted<"), std::string::npos);
    EXPECT_NE(svg.find(">largest eigenvalue<"), std::string::npos);
}

} // namespace
} // namespace fpm
