#pragma once

#include "study/Study.h"

#include <string>
#include <vector>

namespace fpm {

/// How the step whose order of convergence is observed follows from the value of a rung.
enum class StepOf { none, value, inverse };

/// One thing that is varied: an entry of the case, or which folder is laid over it.
struct Ladder {
    std::string name;
    std::string file, path; ///< the entry; both empty for overlays
    std::vector<std::string> values;
    StepOf step = StepOf::none;

    bool isOverlay() const { return file.empty(); }
    /// Step of a rung; 0 where it has none.
    double stepAt(std::size_t value) const;
};

/// The entries of `ladders`. Throws InputError for entries that neither the case nor the annotated
/// dictionaries know, unknown folders, values given twice.
std::vector<Ladder> readLadders(const Dictionary& entries, const Case& theCase);

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
