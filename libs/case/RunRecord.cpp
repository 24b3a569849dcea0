#include "case/RunRecord.h"

#include "base/Error.h"
#include "base/Machine.h"
#include "case/PreviousRun.h"

namespace fpm {

namespace {

RunStatus firstStatus(const std::string& runId)
{
    RunStatus status;
    status.runId = runId;
    status.process = processNumber();
    status.host = hostName();
    status.started = utcDate();
    return status;
}

std::string newRun(const OutputFolder& output, const std::string& previousRun, Log& log)
{
    clearForRun(output, previousRun, log);
    return makeRunId();
}

} // namespace

RunRecord::RunRecord(const OutputFolder& output, const std::string& previousRun, Log& log)
    : RunRecord(output, newRun(output, previousRun, log), 0)
{
    log.line("run " + status_.runId);
}

RunRecord::RunRecord(const OutputFolder& output, const std::string& runId, double wallSeconds)
    : status_(firstStatus(runId)),
      file_(output, status_.text()),
      before_(wallSeconds)
{
}

double RunRecord::wallSeconds() const
{
    return before_
           + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void RunRecord::renew(double time, std::int64_t steps, Log& log)
{
    take(RunState::running, time, steps);
    try {
        file_.rewrite(status_.text(), false);
    } catch (const Error& error) {
        if (!warned_) log.warning(std::string("status is not up to date: ") + error.what());
        warned_ = true;
    }
}

void RunRecord::end(RunState state, double time, std::int64_t steps, const std::string& failedFile)
{
    take(state, time, steps);
    status_.failedFile = failedFile;
    file_.rewrite(status_.text(), true);
}

void RunRecord::take(RunState state, double time, std::int64_t steps)
{
    status_.state = state;
    status_.time = time;
    status_.steps = steps;
    status_.wallSeconds = wallSeconds();
}

} // namespace fpm
