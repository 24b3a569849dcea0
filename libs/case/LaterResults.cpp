#include "case/LaterResults.h"

#include "base/Format.h"
#include "io/Frames.h"

#include <vector>

namespace fpm {

namespace fs = std::filesystem;

void setLaterResultsAside(const OutputFolder& theCase,
                          const std::string& runId,
                          double time,
                          Log& log)
{
    const fs::path caseRoot = theCase.path();
    std::vector<std::string> files;
    // Names of time folders have twelve digits: one of this very time may be rounded up.
    for (const FrameFile& frame : listFrames(caseRoot))
        if (frame.runId == runId && frame.time.second > time * (1 + 1e-11))
            files.push_back(frame.time.first + "/fields.vtkhdf");
    const std::size_t frames = files.size();
    for (const char* file : {"failed/fields.vtkhdf", "why.txt"})
        if (fs::is_regular_file(fs::symlink_status(caseRoot / file))) files.emplace_back(file);
    if (files.empty()) return;
    for (const std::string& file : files) {
        theCase.rename(file, format("{}/{}", laterFolder, file));
        const std::string folder = fs::path(file).parent_path();
        if (!folder.empty()) theCase.remove(folder); // unless it holds more
    }
    log.line(format("moved into {}/: {} frames and {} other files of after the checkpoint",
                    laterFolder, frames, files.size() - frames));
}

} // namespace fpm
