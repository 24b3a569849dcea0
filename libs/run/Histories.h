#pragma once

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

/// The history files of a run: postProcessing/<name>/0/*.dat, one row a sample.
class Histories
{
public:
    /// `runId` goes into the head of every file; none where it is empty.
    Histories(const std::filesystem::path& caseRoot,
              const Model& model,
              const std::string& runId = "");
    /// Appends one row to every file; `row` belongs to the solver's present time.
    void sample(Solver& solver, const Sample& row);

private:
    struct Channel {
        const History* history;
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
