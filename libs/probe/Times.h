#pragma once

#include "io/Frames.h"

#include <string_view>

namespace fpm {

/// The value of option -time: numbers, ranges and the word latestTime.
struct TimeSelection {
    std::vector<double> times;
    std::vector<std::pair<double, double>> ranges; ///< first and last, both included
    bool latest = false;

    bool empty() const { return times.empty() && ranges.empty() && !latest; }
};

/// "1e-4,2e-4", "1e-4:3e-4", "latestTime", joined by commas. Throws Error(commandLine).
TimeSelection parseTimes(std::string_view text);

/// The frames selected, in order, and the single times for which there is none. A frame stands for
/// a time when it is nearer than 2 % of the spacing of frames: solvers land a step beside it.
struct ChosenFrames {
    std::vector<FrameTime> frames;
    std::vector<double> missing;
};
ChosenFrames chooseFrames(const std::vector<FrameTime>& all, const TimeSelection& selection);

} // namespace fpm
