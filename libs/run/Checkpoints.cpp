#include "run/Checkpoints.h"

#include "base/Error.h"
#include "base/Format.h"
#include "case/RunStatus.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fpm {

namespace fs = std::filesystem;

namespace {

struct Found {
    std::string file;
    std::optional<CheckpointLabel> label; ///< none: damaged
};

bool isPlainFile(const fs::path& file)
{
    std::error_code error;
    return fs::is_regular_file(fs::symlink_status(file, error));
}

bool isWhole(const fs::path& file)
{
    try {
        readCheckpoint(file);
        return true;
    } catch (const Error&) {
        return false;
    }
}

/// Newest first.
std::vector<Found> checkpointsIn(const fs::path& caseRoot)
{
    const auto status = readStatus(caseRoot);
    std::vector<Found> found;
    for (int age = 0; age < mostCheckpoints; ++age) {
        const std::string file = checkpointFileOf(age);
        if (!isPlainFile(caseRoot / file)) continue;
        const auto label = checkpointLabel(caseRoot / file);
        const bool isOther =
            label && status && !status->runId.empty() && label->runId != status->runId;
        // Of another run, if it is whole: else its label may be what is damaged.
        if (!isOther || !isWhole(caseRoot / file))
            found.push_back({file, isOther ? std::nullopt : label});
    }
    return found;
}

/// "0.0001 (checkpoint/state.h5), ..."
std::string listOf(const std::vector<Found>& all)
{
    std::string text;
    for (const Found& one : all)
        if (one.label)
            text +=
                format("{}{} ({})", text.empty() ? "" : ", ", toText(one.label->time, 9), one.file);
    return text.empty() ? "none" : text;
}

/// The first that can be read, of those wanted.
Checkpoint firstWhole(const fs::path& caseRoot, const std::vector<Found>& wanted, Log& log)
{
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        try {
            Checkpoint checkpoint = readCheckpoint(caseRoot / wanted[i].file);
            for (std::size_t lost = 0; lost < i; ++lost)
                log.warning(format(
                    "{} {}: going on from {} at time {}, what was computed after it is computed "
                    "again",
                    wanted[lost].file,
                    wanted[lost].label
                        ? format("of time {} is damaged", toText(wanted[lost].label->time, 9))
                        : std::string("is damaged or cut short"),
                    wanted[i].file, toText(checkpoint.time, 9)));
            return checkpoint;
        } catch (const Error&) {
            if (i + 1 == wanted.size()) throw;
        }
    }
    throw Error(ExitCode::checkpoint, "no checkpoint can be read");
}

constexpr const char* fromZero =
    "to start from time 0: startFrom startTime; startTime 0; the results of now go into previous/ "
    "then";

} // namespace

void Checkpoints::write(const Checkpoint& checkpoint, int keep)
{
    const auto begin = std::chrono::steady_clock::now();
    // The new one is written beside the others first: until it is whole and on the disk, no other
    // moves.
    const std::string fresh = format("{}/next.h5", checkpointFolder);
    writeCheckpoint(case_, fresh, checkpoint);
    for (int age = mostCheckpoints - 1; age > 0; --age) {
        const std::string older = checkpointFileOf(age), newer = checkpointFileOf(age - 1);
        if (age >= keep && isPlainFile(case_.path(older))) case_.remove(older);
        if (age < keep && isPlainFile(case_.path(newer))) case_.rename(newer, older);
    }
    case_.rename(fresh, checkpointFile);
    case_.synchroniseNames(checkpointFolder);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    longest_ = std::max(longest_, seconds.count());
}

std::optional<Checkpoint>
findCheckpoint(const fs::path& caseRoot, const Control& control, const RunInputs& inputs, Log& log)
{
    const bool asks = control.latest || control.startTime > 0;
    if (!asks) return std::nullopt;
    std::vector<Found> wanted = checkpointsIn(caseRoot);
    if (!control.latest) {
        const std::string there = listOf(wanted);
        std::erase_if(wanted, [&](const Found& one) {
            return !one.label
                   || std::abs(one.label->time - control.startTime) > 1e-9 * control.startTime;
        });
        if (wanted.empty())
            throw Error(ExitCode::checkpoint,
                        format("there is no checkpoint of time {} (startTime)",
                               toText(control.startTime, 9)),
                        "there are, by time: " + there);
    }
    if (wanted.empty()) return std::nullopt;
    Checkpoint checkpoint = firstWhole(caseRoot, wanted, log);
    const std::string difference = inputs.differenceFrom(checkpoint.inputs);
    if (!difference.empty())
        throw Error(ExitCode::checkpoint,
                    format("the case is not that of run {} any more, stored at time {}: {}",
                           checkpoint.runId, toText(checkpoint.time, 9), difference),
                    std::string("change it back, or ") + fromZero);
    return checkpoint;
}

} // namespace fpm
