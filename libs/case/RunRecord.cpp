#include "case/RunRecord.h"

#include "base/Error.h"
#include "base/Machine.h"
#include "case/PreviousRun.h"
#include "io/OutputFolder.h"

namespace fpm {

RunRecord::RunRecord(std::filesystem::path caseRoot, const std::string& previousRun, Log& log)
    : root_(std::move(caseRoot))
{
    clearForRun(root_, previousRun, log);
    status_.runId = makeRunId();
    begin();
    log.line("run " + status_.runId);
}

RunRecord::RunRecord(std::filesystem::path caseRoot, const std::string& runId, double wallSeconds)
    : root_(std::move(caseRoot)),
      before_(wallSeconds)
{
    status_.runId = runId;
    begin();
}

void RunRecord::begin()
{
    status_.process = processNumber();
    status_.host = hostName();
    status_.started = utcDate();
    OutputFolder(root_).write("status", status_.text());
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
        OutputFolder(root_).renew("status", status_.text());
    } catch (const Error& error) {
        if (!warned_) log.warning(std::string("status is not up to date: ") + error.what());
        warned_ = true;
    }
}

void RunRecord::end(RunState state, double time, std::int64_t steps)
{
    take(state, time, steps);
    OutputFolder(root_).write("status", status_.text());
}

void RunRecord::take(RunState state, double time, std::int64_t steps)
{
    status_.state = state;
    status_.time = time;
    status_.steps = steps;
    status_.wallSeconds = wallSeconds();
}

} // namespace fpm
