#pragma once

#include "advise/Advice.h"
#include "advise/Mirror.h"
#include "case/Case.h"
#include "model/Model.h"

#include <filesystem>

namespace fpm {

/// A model cut at every mirror plane it has: planes, and elements before and after.
struct SymmetryFinding {
    std::vector<MirrorPlane> planes;
    std::vector<std::string> obstacles; ///< "x = 0: ...", of the other planes
    std::size_t elements = 0;           ///< of the whole
    int factor() const { return 1 << planes.size(); }
};
SymmetryFinding symmetryFinding(const Model& model);

/// Writes `target`: a copy of the case with its mesh, the edits made, cut at its mirror planes
/// where `cut` demands it, contact surfaces set, read once as the solver would, and a README.md
/// with notes for its user. The case itself is not changed. Throws Error(commandLine) where the
/// target exists and where there is no plane to cut at; an incomplete target is removed again.
void writeReducedCase(const Case& theCase,
                      const std::vector<Advice>& advice,
                      bool cut,
                      const std::filesystem::path& target,
                      Log& log);

} // namespace fpm
