#pragma once

#include "study/ChartResult.h"

#include <string>
#include <vector>

namespace fpm {

/// What the chart of a probe comes to: the cheapest rung within the tolerance whose finer rungs are
/// within it too, with the largest error of those; or that nothing here reaches the tolerance. The
/// reference itself is never advised, as it has no error, nor a rung whose error grows again on a
/// finer one.
std::string conclusion(const ChartSpec& chart,
                       const ChartProbe& probe,
                       const Plan& plan,
                       const std::vector<RungResult>& rungs,
                       const ProbeResult& result);

} // namespace fpm
