#pragma once

#include "case/Case.h"

#include <optional>
#include <string>
#include <vector>

namespace fpm {

/// What the dictionaries of a case say of the things a chart may vary, without mesh or model.
struct CaseSurvey {
    /// A number of cells: "meshDict.bodies.bar.cells", its items, ("100" "2" "2") or ("20").
    struct Cells {
        std::string entry;
        std::vector<std::int64_t> counts;
    };
    std::vector<Cells> cells;
    double size = 0;       ///< longest edge of an element of the body with the most [length]
    double elements = 0;   ///< of all bodies
    bool fromFile = false; ///< a body is a mesh file, whose elements are what they are
    /// Parts that deform and take their element from no other part; only those that may yield,
    /// where any may.
    std::vector<std::string> parts;
    bool plastic = false;
    /// Contact pairs with springs and their normalScale.
    std::vector<std::pair<std::string, double>> pairs;
    /// Histories to chart: name, file, column.
    struct Column {
        std::string name, file, y;
    };
    std::vector<Column> columns;
};

/// Throws InputError for a dictionary that cannot be read.
CaseSurvey surveyOf(const Case& theCase);

} // namespace fpm
