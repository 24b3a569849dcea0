#include "run/RunForecast.h"

#include "base/Error.h"
#include "base/Format.h"
#include "run/Histories.h"
#include "run/StepSetters.h"
#include "run/resultFrame.h"
#include "solver/elements/ElementStep.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <system_error>

namespace fpm {

namespace {

/// Steps that no run makes: months on the fastest machine with a handful of elements.
constexpr double endless = 1e13;
/// The first frame: the library that makes its image, with room to grow.
constexpr double firstFrameBytes = 5e6;
/// A frame is a folder, a file written through to the disk, and a line in the series.
constexpr double secondsAFrame = 5e-3, bytesASecond = 2e8;
constexpr double headerBytes = 12300; ///< of a frame: groups, links, checksum
constexpr double blockBytes = 4096;   ///< of a disk: a file has whole ones, a folder one of its own
constexpr double bytesANumber = 19;   ///< of a history: as many digits as it needs, and a blank

double bytesOf(const Frame& frame)
{
    std::size_t numbers = 0;
    for (const auto* fields : {&frame.nodeFields, &frame.elementFields})
        for (const ResultField& field : *fields) numbers += field.values.size();
    const double file = headerBytes + double(sizeof(float)) * double(numbers);
    return blockBytes * (1 + std::ceil(file / blockBytes));
}

/// Columns of all tables together.
double historyColumns(const Model& model)
{
    double columns = 0;
    for (const History& history : model.control.histories)
        for (const HistoryTable& table : tablesOf(history, model))
            columns += double(table.columns.size());
    return columns;
}

double freeOnDisk(const std::filesystem::path& folder)
{
    std::error_code failure;
    const auto space = std::filesystem::space(folder, failure);
    return failure ? 1e300 : double(space.available);
}

/// Memory of this process: at its peak until now, and now.
double peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * double(usage.ru_maxrss);
}
double presentMemory()
{
    double total = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> total >> resident;
    return resident * double(sysconf(_SC_PAGESIZE));
}

/// What other programs leave; 1e300 where the system does not say.
double unusedMemory()
{
    std::ifstream stream("/proc/meminfo");
    std::string word;
    double kilobytes = 0;
    while (stream >> word)
        if (word == "MemAvailable:" && stream >> kilobytes) return 1024 * kilobytes;
    return 1e300;
}

std::string bytesText(double bytes)
{
    for (const auto& [unit, size] : {std::pair{"TB", 1e12}, {"GB", 1e9}, {"MB", 1e6}})
        if (bytes >= size) return toText(bytes / size, 3) + " " + unit;
    return toText(bytes / 1e3, 3) + " kB";
}

/// Empty where the disk holds all that will be written.
std::string diskShortage(const RunForecast& f)
{
    if (f.diskBytes() <= f.freeBytes) return "";
    return format("{} frames of {} each and the histories need {}, {} are free on the disk of the "
                  "case",
                  toText(f.frames, 6), bytesText(f.frameBytes), bytesText(f.diskBytes()),
                  bytesText(f.freeBytes));
}

/// How often frames are written, and the steps they ask for.
void addFrames(RunForecast& out, const Control& control, double duration, double most)
{
    out.steps = out.ownSteps;
    if (control.writeControl == WriteControl::clockTime) {
        out.frames = 2; // and as many as the run takes such intervals
        return;
    }
    double stepsAFrame = control.writeInterval;
    if (control.writeControl == WriteControl::runTime) {
        const double intervals = std::ceil(duration / control.writeInterval * (1 - 1e-9));
        stepsAFrame = std::max(1.0, std::ceil(control.writeInterval / out.step * (1 - 1e-9)));
        out.steps = std::min(most, std::max(out.ownSteps, intervals * stepsAFrame));
        out.frames = 1 + std::min(intervals, std::ceil(out.steps / stepsAFrame));
    } else
        out.frames = 1 + std::ceil(out.steps / stepsAFrame);
    if (control.purgeWrite > 0) out.frames = std::min(out.frames, double(control.purgeWrite) + 1);
}

} // namespace

double RunForecast::frameSeconds() const
{
    return frames * (secondsAFrame + frameBytes / bytesASecond);
}

double firstStep(const Solver& solver, const Model& model)
{
    const Control& control = model.control;
    if (control.fixedTimeStep > 0) return control.fixedTimeStep;
    double step = control.timeStepSafety * firstElementStep(solver.elements().setUp(), model);
    if (control.maximumTimeStep > 0) step = std::min(step, control.maximumTimeStep);
    return step;
}

RunForecast forecastRun(Solver& solver,
                        const Model& model,
                        const std::filesystem::path& caseRoot,
                        double step,
                        std::int64_t maxSteps,
                        double from)
{
    const Control& control = model.control;
    const double duration = control.endTime - from;
    RunForecast out;
    out.step = step;
    const double most = maxSteps >= 0 ? double(maxSteps) : 1e300;
    out.ownSteps = std::min(most, std::ceil(duration / step * (1 - 1e-9)));
    addFrames(out, control, duration, most);
    const double rows = control.historyInterval > 0
                            ? std::min(out.steps, duration / control.historyInterval)
                            : out.steps;
    out.historyBytes = rows * historyColumns(model) * bytesANumber;
    out.frameBytes = bytesOf(resultFrame(solver, model));
    const int checkpoints = std::min(control.checkpoint.keep,
                                     control.checkpoint.steps > 0 ? control.checkpoint.keep : 1);
    out.stateBytes = double(checkpoints) * double(solver.fields().stateBytes());
    out.freeBytes = freeOnDisk(caseRoot);
    // A frame is held as numbers, as an image of the file and as what is written.
    out.peakBytes = std::max(peakMemory(), presentMemory() + firstFrameBytes + 5 * out.frameBytes);
    out.memoryBytes = unusedMemory() + presentMemory();
    return out;
}

void reportForecast(const RunForecast& f, double secondsAStep, Log& log)
{
    log.line(format("forecast: {}{} steps of up to {}, {} frames of {}, histories {}, checkpoints "
                    "{}: {} on a disk with {} "
                    "free; memory at the peak {}",
                    secondsAStep > 0 ? "" : "at least ", toText(f.steps, 4), toText(f.step, 4),
                    toText(f.frames, 6), bytesText(f.frameBytes), bytesText(f.historyBytes),
                    bytesText(f.stateBytes), bytesText(f.diskBytes()), bytesText(f.freeBytes),
                    bytesText(f.peakBytes)));
    const bool costs =
        secondsAStep > 0 ? f.frameSeconds() > secondsAStep * f.ownSteps : f.steps > 2 * f.ownSteps;
    if (f.frames > 100 && (costs || f.steps > 2 * f.ownSteps))
        log.warning(format("{} frames cost more than the {} steps there would be without them: "
                           "each is written through to the disk, about {} s in all, and ends a "
                           "step; is writeInterval meant to be as short?",
                           toText(f.frames, 6), toText(f.ownSteps, 4),
                           toText(f.frameSeconds(), 2)));
    if (const std::string what = diskShortage(f); !what.empty()) log.warning(what);
    if (f.peakBytes > f.memoryBytes)
        log.warning(
            format("the run needs {} of memory, {} are there: use a coarser mesh or another "
                   "machine",
                   bytesText(f.peakBytes), bytesText(f.memoryBytes)));
}

void reportStart(Solver& solver,
                 const Model& model,
                 const std::filesystem::path& caseRoot,
                 std::int64_t maxSteps,
                 Log& log)
{
    const StepClock clock = solver.clock();
    const double step =
        clock.steps > 0 ? steadyStep(clock, model.control) : firstStep(solver, model);
    RunForecast forecast = forecastRun(solver, model, caseRoot, step, maxSteps, clock.time);
    forecast.peakBytes = peakMemory(); // the first frame is part of it
    // One that comes to rest ends earlier.
    const std::string shortage = diskShortage(forecast);
    if (!shortage.empty() && !(model.control.relaxationTolerance > 0))
        throw Error(ExitCode::fileIo, shortage,
                    "let writeInterval be longer, make room, or run the case on another disk");
    reportForecast(forecast, 0, log);
    reportStepSetters(stepSetters(solver, model), log);
}

std::string endlessReason(const StepClock& clock, const Control& control, std::int64_t maxSteps)
{
    if (clock.steps == 0 || clock.settled || clock.time >= control.endTime) return "";
    const double step = steadyStep(clock, control), left = (control.endTime - clock.time) / step;
    const std::string at = format("step {} at time {}: ", clock.steps, clock.time);
    if (!(clock.time + step > clock.time))
        return at + format("the time step {} is too small to change the time", step);
    if (maxSteps >= 0 || left < endless) return "";
    return at
           + format("the time step is {}: endTime {} would take {} more of them", toText(step, 4),
                    control.endTime, toText(left, 2));
}

double steadyStep(const StepClock& clock, const Control& control)
{
    if (control.fixedTimeStep > 0) return control.fixedTimeStep;
    double step = control.timeStepSafety * clock.stableStep;
    if (clock.contactFrequency * step > control.contactStepLimit)
        step = control.contactStepLimit / clock.contactFrequency;
    return control.maximumTimeStep > 0 ? std::min(step, control.maximumTimeStep) : step;
}

std::int64_t stepsUntil(const StepClock& clock, double due)
{
    if (!(clock.step > 0)) return 1;
    return std::int64_t(std::clamp(std::ceil((due - clock.time) / clock.step), 1.0, 1e15));
}

} // namespace fpm
