#pragma once

#include "case/LaterResults.h"
#include "fields/FieldSet.h"
#include "io/OutputFolder.h"
#include "run/RunInputs.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fpm {

/// The newest; those before it are state.1.h5, state.2.h5, ...
inline constexpr const char* checkpointFile = "checkpoint/state.h5";

/// All that a run needs to go on where it stood, whatever backend, vector width and number of
/// threads it goes on with.
struct Checkpoint {
    std::string runId;
    double time = 0;
    std::int64_t steps = 0;
    double wallSeconds = 0; ///< of the run up to here
    bool settled = false;   ///< dynamic relaxation has come to rest: nothing is left to do
    RunInputs inputs;
    std::vector<FieldSet::Images> state; ///< Solver::state
    std::vector<std::byte> record;       ///< Archive of the run's own counters
};

/// What a file says of itself without being opened.
struct CheckpointLabel {
    std::string runId;
    double time = 0;
    std::int64_t steps = 0;
};
std::optional<CheckpointLabel> checkpointLabel(const std::filesystem::path& file);

/// Complete or absent. Throws Error(fileIo).
void writeCheckpoint(const OutputFolder& theCase,
                     const std::string& file,
                     const Checkpoint& checkpoint);
/// Compares the checksum of the file and of every array. Throws Error(checkpoint) for a file that
/// is damaged, none of ours, or of another version, which it names.
Checkpoint readCheckpoint(const std::filesystem::path& file);
/// Throws Error(checkpoint) where the state that was restored is of another moment than its
/// checkpoint says.
void requireMoment(const Checkpoint& checkpoint, double time, std::int64_t steps);

} // namespace fpm
