#pragma once

#include "study/Study.h"

#include <string>
#include <vector>

namespace fpm {

/// One thing that is varied: entries of the case, or which folder is laid over it.
struct Ladder {
    std::string name;
    std::vector<std::string> values;              ///< of the rungs, as they are called
    std::vector<std::vector<CaseChange>> changes; ///< of every value
    std::vector<double> steps; ///< of every value: whose order is reported; empty where none is
    /// Of every value: a smaller one is finer; empty where no value is finer than another.
    std::vector<double> coarseness;
};

/// The entries of `fixed`: what all runs of a chart have. Throws as readLadders.
std::vector<CaseChange> readFixed(const Dictionary& entries, const Case& theCase);

/// The entries of `ladders`, for runs that have `fixed`. Throws InputError for entries that are
/// neither in the case nor in folders laid over it nor in the annotated dictionaries, unknown
/// folders, values given twice, names or steps that are not one per value.
std::vector<Ladder> readLadders(const Dictionary& entries,
                                const Case& theCase,
                                const std::vector<CaseChange>& fixed = {});

/// One variation: a value for every ladder, or -1 where the case is left as it is.
struct Rung {
    StudyRun run;
    std::string label; ///< "refinement 2, precision mixed"
    std::vector<int> values;
};

/// Rungs that differ in one ladder only, in its order.
struct Line {
    std::string label;
    std::size_t ladder;
    std::vector<std::size_t> rungs;
};

struct Plan {
    std::vector<Rung> rungs;
    std::vector<Line> lines;
};

/// Every combination, with lines along the first ladder.
Plan productOf(const std::vector<Ladder>& ladders);
/// One ladder at a time, a line each.
Plan eachOf(const std::vector<Ladder>& ladders);

} // namespace fpm
