#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace fpm {

/// Folder of a case with the checkpoints of its run, and the newest of them; those before it are
/// state.1.h5, state.2.h5, ...
inline constexpr const char* checkpointFolder = "checkpoint";
inline constexpr const char* checkpointFile = "checkpoint/state.h5";

/// Of the checkpoint `age` writings ago, relative to the case; there are at most so many.
inline constexpr int mostCheckpoints = 101;
std::string checkpointFileOf(int age);

/// What a checkpoint says of itself without being opened.
struct CheckpointLabel {
    std::string runId;
    double time = 0;
    std::int64_t steps = 0;
    double lastStep = 0;                    ///< the time step that led there
    double wallSeconds = 0, cpuSeconds = 0; ///< of the run up to here, all its parts together

    std::string text() const;
};

/// Nothing for a file that is none, or damaged at its end.
std::optional<CheckpointLabel> checkpointLabel(const std::filesystem::path& file);

} // namespace fpm
