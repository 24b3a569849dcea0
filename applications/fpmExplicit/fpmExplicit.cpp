#include "application/Application.h"
#include "base/Format.h"
#include "case/RunStatus.h"
#include "model/ContactSetup.h"
#include "model/readModel.h"
#include "run/Checkpoints.h"
#include "run/KernelReport.h"
#include "run/SignalWatch.h"
#include "run/TimeLoop.h"
#include "run/WaitPolicy.h"
#include "solver/backend/IdleCores.h"

#include <chrono>
#include <limits>
#include <optional>
#include <utility>

namespace {

/// The command line beats controlDict.
void applyOptions(const fpm::Run& run, fpm::Control& control)
{
    const auto choice = [&](const char* name, std::string& value,
                            const std::vector<std::string>& allowed) {
        if (const auto given = run.choice(name, allowed)) value = *given;
    };
    choice("backend", control.backend, {"serial", "openmp", "cuda"});
    choice("simd", control.simd, {"auto", "scalar", "avx2", "avx512"});
    std::string precision;
    choice("precision", precision, {"double", "mixed", "single"});
    if (!precision.empty())
        control.precision = precision == "double"  ? fpm::Precision::double_
                            : precision == "mixed" ? fpm::Precision::mixed
                                                   : fpm::Precision::single;
    if (const auto threads = run.integer("threads", 0, 4096)) control.threads = int(*threads);
    if (const auto device = run.integer("device", 0, 1023)) control.device = int(*device);
    control.latest |= run.has("continue");
}

/// Nothing is left to do: it has come to its end, and has said so.
bool isFinished(const fpm::Checkpoint& from,
                const fpm::Control& control,
                const std::filesystem::path& caseRoot,
                fpm::Log& log)
{
    const auto status = fpm::readStatus(caseRoot);
    const bool said = status && status->state == fpm::RunState::finished;
    if (!said || (!from.settled && from.time < control.endTime)) return false;
    log.line(fpm::format("run {} has come to its end, at time {}: a later endTime in "
                         "system/controlDict makes it go on",
                         from.runId, from.time));
    return true;
}

} // namespace

/// Runs the explicit time integration of a case: mesh and dictionaries -> time folders, histories.
int main(int argc, char** argv)
{
    const auto begin = std::chrono::steady_clock::now();
    fpm::ignoreRequests();
    fpm::shortenSpin(argv);
    const fpm::ApplicationInfo info{
        "fpmExplicit",
        "Explicit dynamics of solids in contact (finite particle method).",
        "system/controlDict",
        {{"backend", "<word>", "serial, openmp or cuda"},
         {"threads", "<n>", "threads of openmp; 0: as many as cores are idle"},
         {"device", "<n>", "number of the GPU of cuda; 0"},
         {"simd", "<word>", "auto, scalar, avx2 or avx512"},
         {"precision", "<word>", "double, mixed or single"},
         {"continue", "", "go on from the latest checkpoint; from the start where there is none"},
         {"onDiskFull", "<word>", "stop, or wait for room; stop"},
         {"maxSteps", "<n>", "end after n steps"},
         {"strict", "", "end with code 11 where the run finds fault with itself"},
         {"dryRun", "", "say what would run and how long, then end"}},
        true};
    return fpm::runApplication(info, argc, argv, [begin](fpm::Run& run) {
        fpm::updateContact(run.theCase, run.log);
        const fpm::Dictionary controlDict = run.dictionary();
        fpm::Model model = fpm::readModel(run.theCase, controlDict, run.log);
        applyOptions(run, model.control);
        const fpm::RunInputs inputs = fpm::inputsOf(run.theCase, controlDict, model.control);
        std::optional<fpm::Checkpoint> from;
        if (!run.has("dryRun"))
            from = fpm::findCheckpoint(run.theCase.root(), model.control, inputs, run.log);
        if (from && isFinished(*from, model.control, run.theCase.root(), run.log)) return;
        const auto solver = fpm::makeSolver(model);
        run.log.line("running on " + solver->description());
        const std::string busy = fpm::busyCoresNote(model.control);
        if (!busy.empty()) run.log.line(busy);
        for (const std::string& line : fpm::kernelLines(*solver, model)) run.log.line(line);
        if (from)
            solver->restore(std::exchange(from->state, {}));
        else
            solver->start();
        if (run.has("dryRun"))
            return fpm::reportDryRun(*solver, model, run.theCase.root(), run.log);
        fpm::RunOptions options;
        options.maxSteps =
            run.integer("maxSteps", 0, std::numeric_limits<std::int64_t>::max()).value_or(-1);
        options.strict = run.has("strict");
        options.waitsForRoom =
            run.choice("onDiskFull", {"stop", "wait"}).value_or("stop") == "wait";
        options.from = from ? &*from : nullptr;
        options.inputs = inputs;
        options.control = {run.theCase.path(*run.value("dict")),
                           [&run] { return run.dictionary(); }};
        options.begin = begin;
        fpm::runTimeLoop(*solver, model, run.theCase.root(), options, run.log);
    });
}
