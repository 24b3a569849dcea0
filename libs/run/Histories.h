#pragma once

#include "base/Archive.h"
#include "base/Log.h"
#include "io/HistoryFile.h"
#include "run/PartMotion.h"
#include "run/Sample.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace fpm {

/// One file of a history: its name without ending, its columns and their units.
struct HistoryTable {
    std::string name;
    std::vector<std::string> columns, units;
};
std::vector<HistoryTable> tablesOf(const History& history, const Model& model);

/// How much of a history was there at a checkpoint.
struct HistoryMark {
    std::string file; ///< in its case
    std::uint64_t bytes = 0;
};
void keep(Archive& archive, std::vector<HistoryMark>& marks);

/// The history files of a run: postProcessing/<name>/0/*.dat, one row a sample.
class Histories
{
public:
    /// `runId` goes into the head of every file; none where it is empty. Goes on with the files of
    /// `stored`, cut to what they held then: one that is missing, shorter or has other columns now
    /// begins anew, with a warning.
    Histories(const OutputFolder& output,
              const Model& model,
              const std::string& runId,
              const std::vector<HistoryMark>& stored,
              Log& log);
    /// What the files hold now, all of it on the disk.
    std::vector<HistoryMark> marks();
    /// Appends one row to every file; `row` belongs to the solver's present time.
    void sample(Solver& solver, const Sample& row);

private:
    struct Channel {
        const History* history;
        std::vector<std::string> names;                  ///< of the files, in the case
        std::vector<std::unique_ptr<HistoryFile>> files; ///< one a field or contact pair
        Condition drive;                  ///< reaction: what its condition or surface is moved by
        std::vector<double> driveRows;    ///< its amplitude
        std::optional<PartMotion> motion; ///< part: from the first row on
    };
    void samplePoint(Channel& channel, Solver& solver, double time);
    void sampleReaction(Channel& channel, Solver& solver, double time);
    void sampleBody(Channel& channel, Solver& solver, double time);
    void samplePart(Channel& channel, Solver& solver, double time);
    void sampleContact(Channel& channel, Solver& solver, const Sample& row);

    const Model& model_;
    std::vector<Channel> channels_;
};

} // namespace fpm
