#pragma once

#include "base/Log.h"
#include "io/OutputFolder.h"
#include "solver/Solver.h"

#include <string>
#include <vector>

namespace fpm {

/// The time folders of a run, and the series that lists them.
class FrameWriter
{
public:
    FrameWriter(Solver& solver, const Model& model, OutputFolder output, std::string runId);
    /// Goes on with the frames that this run has in the case.
    void resume();
    /// One of the present time, unless there is one; of all of the run no more than the latest
    /// `keep` stay, where that is not 0.
    void write(int keep, Log& log);
    /// The state that stopped the run: beside the mesh as any frame, but of no time.
    void writeFailed();
    static constexpr const char* failedFolder = "failed";

private:
    void save(const std::string& folder);
    void purge(int keep);

    Solver& solver_;
    const Model& model_;
    const OutputFolder output_; ///< the case
    const std::string runId_;
    std::vector<std::string> series_; ///< time folders, ascending
};

} // namespace fpm
