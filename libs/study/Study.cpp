#include "study/Study.h"

#include "base/ChildProcess.h"
#include "base/Format.h"
#include "case/CaseLock.h"
#include "case/RunStatus.h"
#include "io/Checksum.h"

#include <algorithm>
#include <limits>
#include <set>

namespace fpm {

namespace fs = std::filesystem;

namespace {

/// A copy that is removed however it ends.
struct Scratch {
    Scratch(const OutputFolder& itsOutput, std::string itsFolder)
        : output(itsOutput),
          folder(std::move(itsFolder))
    {
        removeCopy(output, folder);
    }
    Scratch(const Scratch&) = delete;
    ~Scratch()
    {
        try {
            removeCopy(output, folder);
        } catch (const std::exception&) {
            // The next start removes it, or says why it cannot.
        }
    }
    const OutputFolder& output;
    std::string folder;
};

} // namespace

Study::Study(Case theCase,
             std::string folder,
             std::vector<StudyRun> runs,
             const StudySettings& settings,
             const Pipeline& pipeline)
    : case_(std::move(theCase)),
      output_(case_.output()),
      folder_(std::move(folder)),
      runs_(std::move(runs)),
      settings_(settings),
      pipeline_(pipeline),
      table_(output_, folder_ + "/runs.dat")
{
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        const Scratch scratch(output_, trialFolder());
        makeCopy(run, scratch.folder);
        const CaseKeys keys = keysOf(output_.path(scratch.folder), settings_.tables);
        keys_.push_back(withPrograms(keys.whole));
        keysButLength_.push_back(withPrograms(keys.butItsLength));
        first_.push_back(
            std::size_t(std::find(keys_.begin(), keys_.end(), keys_.back()) - keys_.begin()));
    }
}

std::string Study::trialFolder() const
{
    return folder_ + "/runs/.trial";
}

std::string Study::withPrograms(const std::string& key) const
{
    Checksum sum;
    sum.add(key);
    sum.add(pipeline_.key());
    return sum.text();
}

void Study::makeCopy(std::size_t run, const std::string& folder) const
{
    const OutputFolder copy = makeCopyFolder(output_, folder);
    copyCase(case_, copy);
    // Entries are changed in what an overlay brings, whatever the order.
    for (const bool overlays : {true, false})
        for (const auto& one : runs_[run].changes)
            if (one.overlay.empty() != overlays) change(case_, copy, one);
}

const RunRow* Study::finished(std::size_t run, int repeat) const
{
    const auto* row = table_.find(keys_[run], repeat);
    if (row == nullptr) return nullptr;
    if (settings_.retry && !row->succeeded()) return nullptr;
    // One that was given less time than it would have now.
    const double given = timeLimitOf(row->state);
    if (given > 0 && (settings_.timeLimit == 0 || settings_.timeLimit > given)) return nullptr;
    // The first repeat leaves its results; without them it counts for nothing.
    if (repeat == 1 && !fs::exists(output_.path(folder_ + "/runs/" + row->run))) return nullptr;
    return row;
}

bool Study::isDue(std::size_t run, int repeat) const
{
    if (first_[run] != run || finished(run, repeat) != nullptr) return false;
    if (repeat == 1) return true;
    const auto* before = finished(run, 1);
    return before == nullptr || before->succeeded(); // what fails once fails again
}

std::size_t Study::toDo() const
{
    std::size_t count = 0;
    for (int repeat = 1; repeat <= settings_.repeats; ++repeat)
        for (std::size_t run = 0; run < runs_.size(); ++run) count += isDue(run, repeat);
    return count;
}

std::size_t Study::total() const
{
    const std::set<std::size_t> distinct(first_.begin(), first_.end());
    return distinct.size() * std::size_t(settings_.repeats);
}

void Study::list(Log& log) const
{
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        const auto* row = finished(run, 1);
        const std::string state = first_[run] != run ? "same as " + runs_[first_[run]].name
                                  : row == nullptr   ? "to do"
                                  : row->succeeded() ? "finished"
                                                     : causeOf(row->state);
        log.line(format("  {}: {}", runs_[run].name, state));
        for (const auto& one : runs_[run].changes)
            log.line(one.overlay.empty() ? format("      {}.{} {}", one.file, one.path, one.value)
                                         : format("      files of {}", one.overlay));
    }
    log.line(format("{} runs ({} repeats each), {} to do", total(), settings_.repeats, toDo()));
}

std::string Study::copyOf(std::size_t run, int repeat) const
{
    return folder_ + "/runs/" + runs_[run].name + (repeat == 1 ? "" : ".again");
}

/// Leaves a copy as it is to be run: from its start, or from what an earlier start has left there.
Continuation Study::prepare(std::size_t run, int repeat, bool fromStart)
{
    const std::string folder = copyOf(run, repeat);
    const fs::path path = output_.path(folder);
    Continuation found;
    if (std::error_code error; fs::exists(fs::symlink_status(path, error))) {
        requireCopy(output_, folder);
        const CaseLock lock(path, "fpmChart"); // refuses while a stray run still works there
        if (repeat == 1) table_.removeRun(runs_[run].name);
        if (!fromStart) found = continuationIn(run, repeat, folder);
        if (found.goesOn) return found;
        removeCopy(output_, folder);
    }
    makeCopy(run, folder);
    noteKey(output_.inner(folder), keysButLength_[run]);
    return found;
}

Continuation Study::continuationIn(std::size_t run, int repeat, const std::string& folder) const
{
    const OutputFolder left = output_.inner(folder);
    if (!fs::exists(left.path() / statusFile)) return {};
    if (notedKey(left.path()) != keysButLength_[run])
        return {.goesOn = false, .why = "its dictionaries, mesh or programs are others now"};
    const Scratch wanted(output_, trialFolder());
    makeCopy(run, wanted.folder);
    const bool frames = (settings_.tables && repeat == 1) || settings_.keepFields;
    Continuation found;
    try {
        found = continuationOf(left, output_.path(wanted.folder),
                               frames ? Frames::needed : Frames::notNeeded);
    } catch (const Error& error) {
        found.why = std::string("what is left of it cannot be read: ") + error.what();
    }
    if (found.goesOn) renewInputs(output_.path(wanted.folder), left);
    return found;
}

RunRow Study::made(std::size_t run, int repeat, const Continuation& from) const
{
    const double limit =
        settings_.timeLimit > 0 ? settings_.timeLimit : std::numeric_limits<double>::infinity();
    return pipeline_.run(output_.path(copyOf(run, repeat)), settings_.tables && repeat == 1, limit,
                         from);
}

void Study::runOne(std::size_t run, int repeat, Log& log, std::size_t number)
{
    Continuation from = prepare(run, repeat, false);
    const std::string& name = runs_[run].name;
    if (from.goesOn)
        log.line(format("      {} goes on from its checkpoint at time {}", name, from.time));
    else if (!from.why.empty())
        log.line(format("      {} begins again: {}", name, from.why));
    auto row = made(run, repeat, from);
    if (from.goesOn && row.state == stateOf("fpmExplicit", ExitCode::checkpoint)) {
        log.line(format("      {} begins again: its checkpoints cannot be used", name));
        from = prepare(run, repeat, true);
        row = made(run, repeat, from);
    }
    row.run = runs_[run].name, row.key = keys_[run], row.repeat = repeat;
    const std::string folder = copyOf(run, repeat);
    if (repeat > 1)
        removeCopy(output_, folder);
    else if (!settings_.keepFields && row.succeeded())
        removeFields(output_.inner(folder));
    table_.add(row);
    const std::string again = repeat > 1 ? format(", repeat {}", repeat) : std::string();
    log.line(format("  {} of {}: {}{}: {}", number, total(), name, again,
                    row.succeeded() ? format("{} s", toText(row.wall, 3)) : causeOf(row.state)));
    if (!row.succeeded())
        log.line(format("      its logs are in {}", output_.path(folder).string()));
}

void Study::run(Log& log)
{
    const std::size_t due = toDo();
    if (due < total() && !table_.rows().empty())
        log.line(format("{} of {} runs are finished already{}", total() - due, total(),
                        due > 0 ? ", going on with the rest" : ""));
    const Interrupt interrupt;
    std::size_t number = total() - due;
    for (int repeat = 1; repeat <= settings_.repeats; ++repeat)
        for (std::size_t run = 0; run < runs_.size(); ++run)
            if (isDue(run, repeat)) {
                if (Interrupt::raised())
                    throw Error(ExitCode::stopped, "interrupted between runs",
                                "finished runs are kept: start again to go on");
                runOne(run, repeat, log, ++number);
            }
}

std::vector<RunRow> Study::rows(std::size_t run) const
{
    std::vector<RunRow> result;
    for (int repeat = 1; repeat <= settings_.repeats; ++repeat)
        if (const auto* row = table_.find(keys_[run], repeat)) result.push_back(*row);
    return result;
}

fs::path Study::folder(std::size_t run) const
{
    const auto* row = table_.find(keys_[run], 1);
    return output_.path(folder_ + "/runs/" + (row == nullptr ? runs_[run].name : row->run));
}

} // namespace fpm
