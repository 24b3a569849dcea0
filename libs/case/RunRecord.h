#pragma once

#include "base/Log.h"
#include "case/RunStatus.h"
#include "case/StatusFile.h"

#include <chrono>

namespace fpm {

/// Record of a run in its case: an id, and the file `status` during the run and at its end.
class RunRecord
{
public:
    /// Sets aside what an earlier run left, as controlDict.previousRun says, and writes `status`.
    RunRecord(const OutputFolder& output, const std::string& previousRun, Log& log);

    /// Goes on with a run that took so many seconds until its checkpoint.
    RunRecord(const OutputFolder& output, const std::string& runId, double wallSeconds);

    const std::string& id() const { return status_.runId; }
    /// Entries that `status` has from now on beside its own: "findings 1;\n".
    void tell(const std::string& entries) { status_.more = entries; }
    /// Writes `status` again. Called about once a second; a failure is reported once and does not
    /// stop the run.
    void renew(double time, std::int64_t steps, Log& log);
    /// Works on a full disk too. `failedFile`: the one the run could not write, where that was its
    /// end; relative to the case.
    void end(RunState state, double time, std::int64_t steps, const std::string& failedFile = "");
    /// Of the whole run up to now.
    double wallSeconds() const;

private:
    void take(RunState state, double time, std::int64_t steps);

    RunStatus status_;
    StatusFile file_;
    double before_ = 0; ///< seconds until the checkpoint
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    bool warned_ = false;
};

} // namespace fpm
