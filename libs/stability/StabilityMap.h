#pragma once

#include "stability/StabilityDict.h"

#include <functional>
#include <optional>

namespace fpm {

/// One point of a map.
struct MapPoint {
    TrialResult result;
    bool predictedStable = false; ///< element, contact and energy-quality bounds hold
};

/// Where the case itself lies on a map of it.
struct OwnPoint {
    double x = 0, y = 0;
    MapPoint point;
    Bounds bounds;
};

/// A map: row j, column i at j * x.values.size() + i; empty where a point is not done yet.
struct StabilityMap {
    MapSpec spec;
    std::vector<std::optional<MapPoint>> points;
    std::vector<std::optional<Bounds>> rows; ///< of each y, at the first x
    std::optional<OwnPoint> own{};           ///< of a map of a case

    std::size_t done() const;
};

/// What a map varies of the model itself: its step over that from elements alone, the penalty of
/// its pairs, ...; nothing where its pairs or parts differ in it.
std::optional<double> ownValue(const Model& model, const std::string& parameter);
/// The case as it is, run as one more point; nothing for other scenes, and where no point of the
/// map stands for it.
std::optional<OwnPoint> ownPoint(const MapSpec& map, const Scene& scene);

/// Bounds of the scene at row `y`.
Bounds rowBounds(const MapSpec& map, const Scene& scene, double y);
MapPoint runPoint(const MapSpec& map, const Scene& scene, const Bounds& row, double x, double y);

/// Runs what is missing, on `threads` threads, calling `save` after each finished row or point
/// (never at the same time). Errors of a scene are thrown.
void completeMap(StabilityMap& map,
                 const Scene& scene,
                 int threads,
                 const std::function<void()>& save);

} // namespace fpm
