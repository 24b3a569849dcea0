#include "run/FrameWriter.h"

#include "base/Format.h"
#include "io/Frames.h"
#include "run/resultFrame.h"

namespace fpm {

FrameWriter::FrameWriter(Solver& solver,
                         const Model& model,
                         std::filesystem::path caseRoot,
                         std::string runId)
    : solver_(solver),
      model_(model),
      root_(std::move(caseRoot)),
      runId_(std::move(runId))
{
}

void FrameWriter::resume()
{
    for (const FrameFile& frame : listFrames(root_))
        if (frame.runId == runId_) series_.push_back(frame.time.first);
    writeSeries(root_, runId_, series_);
}

void FrameWriter::write(int keep, Log& log)
{
    const std::string name = timeName(solver_.clock().time);
    if (!series_.empty() && series_.back() == name) return;
    save(name);
    series_.push_back(name);
    if (keep > 0) purge(keep);
    writeSeries(root_, runId_, series_);
    log.line(format("Time = {}", name));
}

void FrameWriter::writeFailed()
{
    save(failedFolder);
}

void FrameWriter::save(const std::string& folder)
{
    Frame frame = resultFrame(solver_, model_);
    frame.runId = runId_;
    fpm::writeFrame(root_, folder, frame, model_.mesh.points.size(), model_.mesh.hexahedra.size());
}

void FrameWriter::purge(int keep)
{
    while (series_.size() > std::size_t(keep)) {
        const std::string file = series_.front() + "/fields.vtkhdf";
        if (isFrame(root_, file)) {
            std::filesystem::remove(root_ / file);
            std::error_code holdsMore;
            std::filesystem::remove(root_ / series_.front(), holdsMore);
        }
        series_.erase(series_.begin());
    }
}

} // namespace fpm
