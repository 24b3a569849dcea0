#include "stability/MapChart.h"
#include "stability/MapFile.h"

#include <gtest/gtest.h>

#include <atomic>
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
    const auto file = std::filesystem::temp_directory_path() / "fpmStabilityMapTest.dat";
    const MapSpec spec = stepMap();
    const std::string key = mapKey(spec, "");
    StabilityMap whole = emptyMap(spec);
    completeMap(whole, sceneOf("twoBars"), 1, [] {});

    StabilityMap part = emptyMap(spec);
    struct Killed {};
    int saved = 0;
    EXPECT_THROW(completeMap(part, sceneOf("twoBars"), 1,
                             [&] {
                                 writeMap(file, part, key);
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
        EXPECT_EQ(again.points[k]->result.energyError, whole.points[k]->result.energyError);
    }
    StabilityMap other = emptyMap(spec);
    readMap(file, other, mapKey(spec, "changed"));
    EXPECT_EQ(other.done(), 0U);
    std::filesystem::remove(file);
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
    EXPECT_EQ(outcome("twoBars", {{parameter::penalty, 3}, {parameter::timeStep, 0.5}}),
              Outcome::energyDrift);
    EXPECT_EQ(outcome("twoBars", {{parameter::penalty, 3e-3}, {parameter::speed, 20}}),
              Outcome::penetration);
    EXPECT_EQ(outcome("twoBars",
                      {{parameter::gap, 0.6}, {parameter::speed, 50}, {parameter::search, 1000}}),
              Outcome::tunnelled);
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
