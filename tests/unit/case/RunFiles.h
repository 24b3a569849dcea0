#pragma once

#include "case/PerformanceRecord.h"
#include "case/RunStatus.h"
#include "io/Frames.h"
#include "io/RunMark.h"
#include "io/VtkHdf.h"
#include "unit/case/TemporaryCase.h"

namespace fpm {

/// Writes what a run and fpmProbe leave in a case.
class RunFiles
{
public:
    RunFiles(const TemporaryCase& folder, std::string runId)
        : folder_(folder),
          runId_(std::move(runId))
    {
    }

    void mesh(const std::string& checksum) const
    {
        Hdf5Image image;
        image.attribute("/fpm", "meshChecksum", checksum);
        image.save(OutputFolder(folder_.root()), "constant/mesh.vtkhdf");
    }
    void frame(const std::string& time, const std::string& mesh = "") const
    {
        Frame frame;
        frame.time = std::stod(time);
        frame.runId = runId_;
        frame.meshChecksum = mesh;
        writeFrame(OutputFolder(folder_.root()), time, frame, 8, 1);
    }
    void marked(const std::string& file) const
    {
        folder_.write(file, "# " + RunMark{runId_, file}.text() + "\n# time x\n0 1\n");
    }
    void status(RunState state) const
    {
        RunStatus status;
        status.state = state;
        status.runId = runId_;
        status.steps = 10;
        folder_.write("status", status.text());
    }
    /// Frames at the times given, a history, a table, a picture, a plot, performance, series.
    void all(const std::vector<std::string>& times) const
    {
        for (const std::string& time : times) frame(time);
        for (const char* file :
             {"postProcessing/tip/0/displacement.dat", "postProcessing/end/0/U.dat",
              "postProcessing/pictures/mises_0.svg", "postProcessing/plots/tip.svg"})
            marked(file);
        for (const char* file : {"checkpoint/state.h5", "checkpoint/state.1.h5", "later/why.txt"})
            folder_.write(file, "of the run");
        Frame later;
        later.runId = runId_;
        writeFrame(OutputFolder(folder_.root()).inner("later"), "7e-05", later, 8, 1);
        PerformanceRecord performance;
        performance.runId = runId_;
        folder_.write(performanceFile, performance.text());
        folder_.write("postProcessing/performance/0/performance.json", "{}");
        writeSeries(OutputFolder(folder_.root()), runId_, times);
        status(RunState::finished);
    }

private:
    const TemporaryCase& folder_;
    std::string runId_;
};

} // namespace fpm
