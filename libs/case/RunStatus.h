#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace fpm {

/// Where it stands in a case.
inline constexpr const char* statusFile = "status";

enum class RunState { running, finished, stopped, failed, died };
std::string nameOf(RunState state);

/// The file `status` of a case: the run its results belong to, and its progress.
struct RunStatus {
    RunState state = RunState::running;
    std::string runId; ///< empty in a status of an older version
    double time = 0;
    std::int64_t steps = 0;
    double wallSeconds = 0;
    int process = 0;
    std::string host, started; ///< UTC, "2025-01-31T12:00:00Z"
    std::string failedFile;    ///< of a run that failed: the file it could not write, if any
    std::string more;          ///< further entries, written only

    std::string text() const;
};

/// Nothing where a case has no status, or one that is not ours. A run that says it is running while
/// its process does not hold the case lock has died.
std::optional<RunStatus> readStatus(const std::filesystem::path& caseRoot);

/// "run 20250131-120000-1a2b3c4d failed at time 2e-05: <first line of why.txt>"; of a finished run
/// "run ... finished at time 0.0001".
std::string describe(const RunStatus& status, const std::filesystem::path& caseRoot);

/// A new one: UTC to the second, which sorts, and 32 random bits; letters, digits and '-'.
std::string makeRunId();

} // namespace fpm
