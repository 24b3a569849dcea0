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

/// A map: row j, column i at j * x.values.size() + i; empty where a point is not done yet.
struct StabilityMap {
    MapSpec spec;
    std::vector<std::optional<MapPoint>> points;
    std::vector<std::optional<Bounds>> rows; ///< of each y, at the first x

    std::size_t done() const;
};

/// One sentence: how many points, whether a predicted-stable one failed, and how far beyond the
/// prediction failure begins.
std::string conclusionOf(const StabilityMap& map);

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
