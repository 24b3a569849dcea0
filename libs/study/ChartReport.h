#pragma once

#include "study/ChartResult.h"

#include <string>
#include <vector>

namespace fpm {

/// A row of words a rung: cost, errors and order of every probe, state.
std::string chartTable(const ChartSpec& chart,
                       const Plan& plan,
                       const std::vector<RungResult>& rungs,
                       const std::vector<ProbeResult>& probes);

/// Error over cost of one probe, a line each line of the plan.
std::string chartPicture(const ChartSpec& chart,
                         const ChartProbe& probe,
                         const Plan& plan,
                         const std::vector<RungResult>& rungs,
                         const ProbeResult& result);

} // namespace fpm
