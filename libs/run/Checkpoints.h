#pragma once

#include "base/Log.h"
#include "run/Checkpoint.h"

namespace fpm {

/// Writes the checkpoints of a run: the newest as state.h5, once those before it have moved on by
/// one number. At no moment is there less than the newest one before.
class Checkpoints
{
public:
    explicit Checkpoints(OutputFolder theCase) : case_(std::move(theCase)) {}
    /// Keeps so many files, the new one included; at least one. Throws Error(fileIo).
    void write(const Checkpoint& checkpoint, int keep);
    /// Seconds the slowest has taken; 0 before the first.
    double longest() const { return longest_; }

private:
    OutputFolder case_;
    double longest_ = 0;
};

/// The checkpoint to go on from: of control.startTime, or the latest; of the run that `status`
/// names, where it names one. Nothing where control asks for none, or for the latest and there is
/// none. One that is damaged is passed over with a warning for the one before it. Throws
/// Error(checkpoint) where none can be read, none is of that time, or the case has changed since.
std::optional<Checkpoint> findCheckpoint(const std::filesystem::path& caseRoot,
                                         const Control& control,
                                         const RunInputs& inputs,
                                         Log& log);

} // namespace fpm
