#pragma once

#include "base/Log.h"
#include "study/CaseCopy.h"
#include "study/Continuation.h"
#include "study/Pipeline.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fpm {

/// One variation of a case.
struct StudyRun {
    std::string name; ///< names a folder
    std::vector<CaseChange> changes;
};

struct StudySettings {
    int repeats = 1;
    double timeLimit = 0;    ///< of a run, s; 0: none
    bool tables = false;     ///< fpmProbe -tables follows
    bool keepFields = false; ///< frames and meshes stay
    bool retry = false;      ///< failed runs are not taken for finished
};

/// A case run in many variations, each in a copy under <folder>/runs of it. <folder>/runs.dat says
/// which are finished, by the content of their dictionaries: a later start goes on where one was
/// stopped, and repeats what has changed only. Variations of equal content are run once. A run that
/// was stopped, or has another endTime now, goes on from its checkpoint where that gives the same
/// bits as a run from the start.
class Study
{
public:
    /// Makes a copy of every variation on trial. Throws InputError for a change that cannot be
    /// made.
    Study(Case theCase,
          std::string folder,
          std::vector<StudyRun> runs,
          const StudySettings& settings,
          const Pipeline& pipeline);

    /// Runs still to be done, and all there are; repeats count.
    std::size_t toDo() const;
    std::size_t total() const;
    void list(Log& log) const;
    /// Does them, repeats interleaved: run 1, run 2, ..., run 1 again. Failing runs are results and
    /// have rows; throws Error for interruption, full disk, a run's folder in use.
    void run(Log& log);

    std::size_t size() const { return runs_.size(); }
    const std::string& name(std::size_t run) const { return runs_[run].name; }
    /// Rows of a variation, first repeat first; empty before it was run.
    std::vector<RunRow> rows(std::size_t run) const;
    /// Its folder with logs and histories; that of the variation of equal content.
    std::filesystem::path folder(std::size_t run) const;

private:
    const RunRow* finished(std::size_t run, int repeat) const;
    bool isDue(std::size_t run, int repeat) const;
    std::string copyOf(std::size_t run, int repeat) const;
    std::string trialFolder() const;
    std::string withPrograms(const std::string& key) const;
    Continuation prepare(std::size_t run, int repeat, bool fromStart);
    Continuation continuationIn(std::size_t run, int repeat, const std::string& folder) const;
    RunRow made(std::size_t run, int repeat, const Continuation& from) const;
    void makeCopy(std::size_t run, const std::string& folder) const;
    void runOne(std::size_t run, int repeat, Log& log, std::size_t number);

    Case case_;
    OutputFolder output_; ///< of the case
    std::string folder_;  ///< within it
    std::vector<StudyRun> runs_;
    std::vector<std::string> keys_, keysButLength_;
    std::vector<std::size_t> first_; ///< the first variation of the same content
    StudySettings settings_;
    const Pipeline& pipeline_;
    RunTable table_;
};

} // namespace fpm
