#include "study/Continuation.h"

#include "base/Format.h"
#include "case/Case.h"
#include "case/CheckpointLabel.h"
#include "case/RunStatus.h"
#include "io/Frames.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fpm {

namespace fs = std::filesystem;

namespace {

/// What of a controlDict says when a run ends and what its end decides besides.
struct Ending {
    double endTime = 0;
    std::optional<double> frames; ///< writeInterval, where it is a time
    std::int64_t frameSteps = 0;  ///< the same, where it is a number of steps
    double rows = 0;              ///< historyInterval
    std::string follows;          ///< an entry that is absent and so follows from endTime
};

Ending endingOf(const fs::path& root)
{
    const Dictionary control = Case(root).dictionary("system/controlDict");
    const std::string by = control.wordOr("writeControl", "runTime");
    const bool byTime = by == "runTime" || by == "adjustableRunTime";
    Ending ending;
    ending.endTime = control.number("endTime");
    if (byTime) ending.frames = control.numberOr("writeInterval", ending.endTime / 10);
    if (by == "timeStep")
        ending.frameSteps = control.integer("writeInterval", 1, std::int64_t(1) << 52);
    ending.rows = control.numberOr("historyInterval", ending.endTime / 1000);
    if (byTime && !control.has("writeInterval"))
        ending.follows = "writeInterval";
    else if (!control.has("historyInterval"))
        ending.follows = "historyInterval";
    else if (control.has("quasiStatic") && !control.sub("quasiStatic").has("after"))
        ending.follows = "quasiStatic.after";
    return ending;
}

/// Whether a run to `ending` meets this earlier time too, for a frame, and takes a row there.
bool isPassed(double time, const Ending& ending)
{
    if (!ending.frames) return false;
    const double frames = *ending.frames, rows = ending.rows;
    const bool isFrame =
        std::round(time / frames) * frames == time && ending.endTime - time > 1e-5 * frames;
    return isFrame && (rows == 0 || std::abs(std::round(time / rows) * rows - time) <= 1e-9 * rows);
}

/// Whether runs to both ends come through the state of a checkpoint. Steps are cut, or halved,
/// where less than two of them are left to an end, and none is longer than 1.1 times the one
/// before.
bool isCommon(const CheckpointLabel& checkpoint, const Ending& then, const Ending& now)
{
    if (then.endTime == now.endTime) return true;
    if (now.endTime > then.endTime && isPassed(then.endTime, now)) return true;
    return checkpoint.time + 3 * checkpoint.lastStep < std::min(then.endTime, now.endTime);
}

/// A run that was stopped has left a frame of that moment, which is of no run from the start.
void removeFrameOfStop(const OutputFolder& left,
                       const CheckpointLabel& checkpoint,
                       const Ending& then)
{
    const double time = checkpoint.time;
    const bool isUndue = then.frames
                             ? std::round(time / *then.frames) * *then.frames != time
                             : then.frameSteps > 0 && checkpoint.steps % then.frameSteps != 0;
    if (!isUndue || time == then.endTime) return;
    for (const FrameFile& frame : listFrames(left.path())) {
        const std::string& folder = frame.time.first;
        if (frame.runId != checkpoint.runId || folder != timeName(time)) continue;
        left.remove(folder + "/fields.vtkhdf");
        left.remove(folder); // unless it holds more
    }
}

Continuation no(const std::string& why)
{
    return {.goesOn = false, .why = why};
}

} // namespace

Continuation continuationOf(const OutputFolder& left, const fs::path& wanted, Frames frames)
{
    const fs::path root = left.path();
    const auto status = readStatus(root);
    if (!status) return {};
    const Ending then = endingOf(root), now = endingOf(wanted);
    if (then.endTime != now.endTime && !now.follows.empty())
        return no(format("{} is not given and follows from endTime", now.follows));
    if (frames == Frames::needed && !fs::exists(root / "case.vtkhdf.series"))
        return no("the frames of its beginning are removed (keepFields no)");
    Continuation found = no("there is no checkpoint of it");
    for (int age = 0; age < mostCheckpoints; ++age) {
        const std::string file = checkpointFileOf(age);
        const auto label = checkpointLabel(root / file);
        if (!label || label->runId != status->runId) continue;
        if (isCommon(*label, then, now)) {
            removeFrameOfStop(left, *label, then);
            return {true, "", label->time, label->wallSeconds, label->cpuSeconds};
        }
        left.remove(file);
        found = no(now.endTime < then.endTime
                       ? format("no checkpoint before endTime {} is left", now.endTime)
                       : format("its last steps were cut to meet endTime {}, and no checkpoint "
                                "before them is left",
                                then.endTime));
    }
    return found;
}

} // namespace fpm
