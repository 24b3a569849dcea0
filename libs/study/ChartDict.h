#pragma once

#include "study/Curve.h"
#include "study/Ladder.h"

#include <optional>
#include <string>
#include <vector>

namespace fpm {

/// What the history of a probe is held against.
struct ReferenceSpec {
    enum class Kind { curve, expression, finest };
    Kind kind = Kind::curve;
    Curve curve;            ///< of a table or a file
    std::string expression; ///< in t
    std::size_t ladder = 0; ///< finest: its last value, all others at their first
};

/// A history whose error is charted: two columns of a .dat file of the run.
struct ChartProbe {
    std::string name;
    std::string file; ///< relative to the case: "postProcessing/tip/0/displacement.dat"
    std::string x, y;
    double xScale = 1, yScale = 1;
    double average = 0;     ///< width of x of a running mean; 0: none
    bool perLength = false; ///< y are shares of nodes, given per length of x
    Measure measure = Measure::l2;
    ReferenceSpec reference;
};

/// A result of another program: its error, or the curve that is held against the reference.
struct ForeignPoint {
    std::string name, probe, note; ///< for all probes where `probe` is empty
    double cost = 0, error = 0;
    std::optional<Curve> curve; ///< with `probe` only
    bool isFor(const ChartProbe& other) const { return probe.empty() || probe == other.name; }
};

enum class CostKind { wall, cpu, elementSteps };

/// system/chartDict, charts: one entry.
struct ChartSpec {
    std::string name, title;
    bool product = false;
    StudySettings settings;
    CostKind cost = CostKind::wall;
    double tolerance = 0.01;
    std::vector<CaseChange> fixed; ///< what all runs have
    std::vector<Ladder> ladders;
    std::vector<ChartProbe> probes;
    std::vector<ForeignPoint> foreign;
};

/// Reads and checks all charts before anything runs: entries of ladders, probes against the
/// histories and tables of the case, reference files, formulas. Throws InputError, Error(fileIo).
std::vector<ChartSpec> readChartDict(const Dictionary& dictionary, const Case& theCase);

std::string measureText(const ChartProbe& probe); ///< "L2 over time", "peak", ...
std::string costText(CostKind cost);              ///< "wall time [s]", ...

} // namespace fpm
