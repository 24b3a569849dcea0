#include "run/FrameWriter.h"

#include "base/Format.h"
#include "io/Frames.h"
#include "run/resultFrame.h"

namespace fpm {

FrameWriter::FrameWriter(Solver& solver, const Model& model, OutputFolder output, std::string runId)
    : solver_(solver),
      model_(model),
      output_(std::move(output)),
      runId_(std::move(runId))
{
}

void FrameWriter::resume()
{
    for (const FrameFile& frame : listFrames(output_.path()))
        if (frame.runId == runId_) series_.push_back(frame.time.first);
    writeSeries(output_, runId_, series_);
}

void FrameWriter::write(int keep, Log& log)
{
    const std::string name = timeName(solver_.clock().time);
    if (!series_.empty() && series_.back() == name) return;
    save(name);
    series_.push_back(name);
    if (keep > 0) purge(keep);
    writeSeries(output_, runId_, series_);
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
    fpm::writeFrame(output_, folder, frame, model_.mesh.points.size(),
                    model_.mesh.hexahedra.size());
}

void FrameWriter::purge(int keep)
{
    while (series_.size() > std::size_t(keep)) {
        const std::string file = series_.front() + "/fields.vtkhdf";
        if (isFrame(output_.path(), file)) {
            output_.remove(file);
            output_.remove(series_.front()); // unless it holds more
        }
        series_.erase(series_.begin());
    }
}

} // namespace fpm
