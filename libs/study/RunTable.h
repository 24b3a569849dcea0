#pragma once

#include "base/Error.h"
#include "io/OutputFolder.h"

#include <string>
#include <vector>

namespace fpm {

/// One finished run of a study.
struct RunRow {
    std::string run;          ///< its name, and that of its folder
    std::string key;          ///< checksum of case and programs
    int repeat = 1;           ///< 1, 2, ...
    std::string state = "ok"; ///< or "fpmExplicit:10", ":signal9", ":timeLimit60": what failed
    double wall = 0, cpu = 0; ///< of fpmExplicit [s]
    double elements = 0, steps = 0;
    double nsPerElementStep = 0;
    double memory = 0; ///< most that fpmExplicit held [MB]
    std::string host;

    bool succeeded() const { return state == "ok"; }
};

/// "fpmExplicit:10", of a program that ended with this code.
std::string stateOf(const std::string& program, ExitCode code);
/// "numerical stop of fpmExplicit" for "fpmExplicit:10".
std::string causeOf(const std::string& state);

/// State of a run that was killed after so many seconds in `program`; and these seconds, 0 for
/// other states.
std::string pastTimeLimit(const std::string& program, double seconds);
double timeLimitOf(const std::string& state);

/// runs.dat: a header and one row a run. A row once added is on the disk whole, whatever happens
/// next.
class RunTable
{
public:
    /// Reads what an earlier start has left. Throws Error(fileIo) for a line it cannot read.
    RunTable(const OutputFolder& output, const std::string& file);

    const std::vector<RunRow>& rows() const { return rows_; }
    const RunRow* find(const std::string& key, int repeat) const;
    /// Writes the table with this row. Throws Error(fileIo); the rows before stay.
    void add(const RunRow& row);
    /// Forgets the rows of a run whose folder is about to be used again.
    void removeRun(const std::string& run);

private:
    void write() const;

    OutputFolder output_;
    std::string file_; ///< within `output_`
    std::vector<RunRow> rows_;
};

} // namespace fpm
