#pragma once

#include "case/CheckpointLabel.h"
#include "fields/FieldSet.h"
#include "io/OutputFolder.h"
#include "run/RunInputs.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fpm {

/// All that a run needs to go on where it stood, whatever backend, vector width and number of
/// threads it goes on with.
struct Checkpoint : CheckpointLabel {
    bool settled = false; ///< dynamic relaxation has come to rest: nothing is left to do
    RunInputs inputs;
    std::vector<FieldSet::Images> state; ///< Solver::state
    std::vector<std::byte> record;       ///< Archive of the run's own counters
};

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
