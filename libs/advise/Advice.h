#pragma once

#include "advise/CaseEdits.h"
#include "base/Log.h"

#include <string>
#include <vector>

namespace fpm {

/// Words of -apply, in the order they are made in.
const std::vector<std::string>& adviceKinds();

/// One measure that makes the model of a scene smaller.
struct Advice {
    std::string kind;    ///< a word of adviceKinds()
    std::string subject; ///< "planes x = 0, y = 0", "part rod"
    std::string reason;  ///< what it rests on, with figures
    std::string saving;
    std::string price;         ///< what error it may bring
    CaseEdits edits;           ///< of the dictionaries; symmetry cuts the mesh besides
    bool measureOnly = false;  ///< only a comparison shows whether the result stays valid
    std::string part = {};     ///< that it is about; of several pieces the first is applied
    std::string measured = {}; ///< by -measure: the largest difference of all histories
    /// Whether a copy of the case can be made that follows it; else it is a hint to a person.
    bool isMade() const { return kind == "symmetry" || !edits.empty(); }
};

void printAdvice(const std::vector<Advice>& advice, Log& log);

} // namespace fpm
