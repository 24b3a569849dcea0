#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fpm {

/// Where it stands in a case.
inline constexpr const char* performanceFile = "postProcessing/performance/0/performance";

/// What a run tells of its cost when it ends, for programs: a dictionary in its case. Times of a
/// clock in seconds, of the model in the units of the case.
struct PerformanceRecord {
    std::string runId;
    std::string backend, precision, algorithm, description;
    std::int64_t elements = 0, nodes = 0, contactors = 0, steps = 0, searches = 0, deviceBytes = 0;
    /// Of the steps of the whole run; how often it was begun or continued; and the steps and
    /// seconds of the last of these parts, of which the figures below are.
    double wallSeconds = 0;
    std::int64_t parts = 1, partSteps = 0;
    double partSeconds = 0;
    double threads = 0; ///< on average
    /// Nothing: was not timed, or has no meaning.
    std::optional<double> nsPerElementStep, nsPerContactorStep, contactShare, bytesPerElementStep;
    double time = 0, lastStep = 0; ///< at the end
    /// Bound of the elements alone at the end; infinite where they set none.
    double elementStep = std::numeric_limits<double>::infinity();
    std::string contactLimitedBy; ///< pair and node whose springs bounded the last step; or empty
    /// Dissipated since the start, by name of each pair with friction.
    std::vector<std::pair<std::string, double>> frictionWork;
    std::string checksum; ///< of the state at the end

    std::string text() const;
};

/// Nothing where a case has none, or one that is not ours. What it does not tell is as in an empty
/// record.
std::optional<PerformanceRecord> readPerformance(const std::filesystem::path& caseRoot);

} // namespace fpm
