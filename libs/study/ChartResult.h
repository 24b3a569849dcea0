#pragma once

#include "study/ChartDict.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fpm {

/// What a rung cost: median, least and most of its repeats.
struct Cost {
    double median = 0, least = 0, most = 0;
};

/// One rung of a chart.
struct RungResult {
    std::string label, state; ///< state as in RunRow, empty before it was run
    Cost cost;                ///< of the chart's kind; for failed runs up to the failure
    RunRow row;               ///< the first repeat
    bool succeeded() const { return state == "ok"; }
};

/// The errors of one probe.
struct ProbeResult {
    std::vector<std::optional<CurveErrors>> errors; ///< of every rung; none where it failed
    std::vector<std::optional<double>> orders; ///< between a rung and the one before on its line
    std::vector<bool> isReference; ///< rungs whose run is the reference: no error to judge them by
    std::vector<bool> front;       ///< nothing is both cheaper and more accurate (Pareto)
    std::vector<double>
        foreign;           ///< errors of other programs; not a number: none, or not this probe
    std::string reference; ///< in words
    std::string theRung;   ///< "precision double", where that one itself is the reference
    double error(std::size_t rung, Measure measure) const; ///< not a number where there is none
};

/// The errors of all rungs, from the histories of the study's runs. Throws Error(dictionary) for a
/// file or column that a finished run does not have.
ProbeResult judge(const ChartProbe& probe,
                  const ChartSpec& chart,
                  const Plan& plan,
                  const Study& study,
                  const std::vector<RungResult>& rungs);

std::vector<RungResult> costsOf(const ChartSpec& chart, const Plan& plan, const Study& study);

/// Marks the rungs that nothing beats in both error and cost; those without error are not marked.
std::vector<bool> paretoFront(const std::vector<double>& costs, const std::vector<double>& errors);

} // namespace fpm
