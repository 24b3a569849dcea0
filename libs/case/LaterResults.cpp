#include "case/LaterResults.h"

#include "base/Format.h"
#include "io/Frames.h"

#include <vector>

namespace fpm {

namespace fs = std::filesystem;

void setLaterResultsAside(const fs::path& caseRoot, const std::string& runId, double time, Log& log)
{
    std::vector<std::string> files;
    for (const FrameFile& frame : listFrames(caseRoot))
        if (frame.runId == runId && frame.time.second > time * (1 + 1e-12))
            files.push_back(frame.time.first + "/fields.vtkhdf");
    const std::size_t frames = files.size();
    for (const char* file : {"failed/fields.vtkhdf", "why.txt"})
        if (fs::is_regular_file(fs::symlink_status(caseRoot / file))) files.emplace_back(file);
    if (files.empty()) return;
    for (const std::string& file : files) {
        const fs::path target = caseRoot / laterFolder / file;
        fs::create_directories(target.parent_path());
        fs::rename(caseRoot / file, target);
        std::error_code holdsMore;
        if (fs::path(file).has_parent_path())
            fs::remove((caseRoot / file).parent_path(), holdsMore);
    }
    log.line(format("moved into {}/: {} frames and {} other files of after the checkpoint",
                    laterFolder, frames, files.size() - frames));
}

} // namespace fpm
