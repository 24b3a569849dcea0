#include "stability/StabilityMap.h"

#include "base/Format.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

namespace fpm {

namespace {

Setting settingAt(const MapSpec& map, double x, double y)
{
    Setting setting = map.fixed;
    setting.set(map.x.parameter, x);
    setting.set(map.y.parameter, y);
    return setting;
}

Trial trialOf(const Scene& scene, const Setting& setting)
{
    Trial trial = scene.make(setting);
    applyCommon(trial.model, setting);
    return trial;
}

/// The bounds do not move with the step, so one set serves a row whose x is the step.
bool rowsShareBounds(const MapSpec& map)
{
    return map.x.parameter == parameter::timeStep;
}

} // namespace

std::size_t StabilityMap::done() const
{
    return std::size_t(std::count_if(points.begin(), points.end(),
                                     [](const auto& point) { return point.has_value(); }));
}

std::optional<double> ownValue(const Model& model, const std::string& name)
{
    const auto common = [](const auto& values, auto value) -> std::optional<double> {
        std::optional<double> found;
        for (const auto& one : values) {
            if (found && *found != value(one)) return {};
            found = value(one);
        }
        return found;
    };
    if (name == parameter::speed) return 1;
    if (name == parameter::search) return double(model.control.searchInterval);
    if (name == parameter::penalty)
        return common(model.contactPairs, [](const ContactPair& pair) { return pair.normalScale; });
    if (name == parameter::hourglass) {
        std::vector<Part> parts = model.parts;
        std::erase_if(parts, [](const Part& part) { return isRigid(part.kind); });
        return common(parts, [](const Part& part) { return part.hourglassCoefficient; });
    }
    if (name == parameter::timeStep) {
        const StepClock clock = firstStep(model);
        return clock.step / clock.elementStep;
    }
    return {};
}

std::optional<OwnPoint> ownPoint(const MapSpec& map, const Scene& scene)
{
    if (map.scene != "case") return {};
    const Trial trial = trialOf(scene, map.fixed);
    const auto x = ownValue(trial.model, map.x.parameter),
               y = ownValue(trial.model, map.y.parameter);
    if (!x || !y) return {};
    const Bounds bounds = boundsOf(trial.model);
    return OwnPoint{*x, *y, runPoint(map, scene, bounds, *x, *y), bounds};
}

Bounds rowBounds(const MapSpec& map, const Scene& scene, double y)
{
    const Trial trial = trialOf(scene, settingAt(map, map.x.values.front(), y));
    Bounds bounds = boundsOf(trial.model);
    if (map.eigenvalue)
        if (const double frequency = largestFrequency(trial.model, bounds.elementStep);
            frequency > 0)
            bounds.eigenvalue = 2 / (frequency * bounds.elementStep);
    return bounds;
}

MapPoint runPoint(const MapSpec& map, const Scene& scene, const Bounds& row, double x, double y)
{
    const Setting setting = settingAt(map, x, y);
    const Trial trial = trialOf(scene, setting);
    const Bounds bounds = rowsShareBounds(map) ? row : boundsOf(trial.model);
    MapPoint point;
    point.result = runTrial(trial, setting, bounds, map.limits);
    const double factor = setting.of(parameter::timeStep, 0);
    constexpr double rounding = 1 + 1e-9; // the case's own step is one of the two
    const bool stepHolds = factor <= 0.9 * rounding * bounds.withContact
                           && (bounds.quality <= 0 || factor <= rounding * bounds.quality);
    point.predictedStable = stepHolds && trial.model.control.searchInterval == 0;
    return point;
}

void completeMap(StabilityMap& map,
                 const Scene& scene,
                 int threads,
                 const std::function<void()>& save)
{
    const std::size_t columns = map.spec.x.values.size(), rows = map.spec.y.values.size();
    std::mutex guard;
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::atomic<bool> failed{false};
    const auto each = [&](std::size_t count, const auto& missing, const auto& work) {
        next = 0;
        const auto serve = [&] {
            for (std::size_t i = next++; i < count; i = next++) try {
                    if (failed) return;
                    if (missing(i)) work(i);
                } catch (...) {
                    const std::lock_guard lock(guard);
                    failure = std::current_exception();
                    failed = true;
                    return;
                }
        };
        std::vector<std::thread> helpers;
        for (int t = 1; t < threads; ++t) helpers.emplace_back(serve);
        serve();
        for (std::thread& helper : helpers) helper.join();
        if (failure) std::rethrow_exception(failure);
    };
    each(
        rows, [&](std::size_t j) { return !map.rows[j]; },
        [&](std::size_t j) {
            const Bounds bounds = rowBounds(map.spec, scene, map.spec.y.values[j]);
            const std::lock_guard lock(guard);
            map.rows[j] = bounds;
            save();
        });
    each(
        rows * columns, [&](std::size_t k) { return !map.points[k]; },
        [&](std::size_t k) {
            const MapPoint point =
                runPoint(map.spec, scene, *map.rows[k / columns], map.spec.x.values[k % columns],
                         map.spec.y.values[k / columns]);
            const std::lock_guard lock(guard);
            map.points[k] = point;
            save();
        });
}

} // namespace fpm
