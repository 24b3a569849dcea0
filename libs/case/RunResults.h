#pragma once

#include "base/Log.h"
#include "case/RunStatus.h"
#include "io/Frames.h"
#include "io/Table.h"

namespace fpm {

/// The results in a case that belong together: those of the run in `status`, without one of the
/// latest run that left frames, on the mesh that is there now.
class RunResults
{
public:
    /// Throws Error(mesh) naming a frame that is cut short.
    explicit RunResults(std::filesystem::path caseRoot);

    const std::vector<FrameTime>& frames() const { return frames_; } ///< ascending
    const std::string& runId() const { return runId_; } ///< empty where no result names one
    /// Warns of a run that did not finish and of all that is left out, by name.
    void report(Log& log) const;

private:
    std::filesystem::path root_;
    std::optional<RunStatus> status_;
    std::string runId_;
    std::vector<FrameTime> frames_;
    std::vector<std::string> ofOtherRuns_, ofOtherMesh_; ///< time folders
};

/// The run that a table names, if it is another than `runId`; a table or a caller that names none
/// is never wrong.
std::string otherRunOf(const Table& table, const std::string& runId);

} // namespace fpm
