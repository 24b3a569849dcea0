#pragma once

#include "solver/Solver.h"

#include <string>

namespace fpm {

/// Why a run stopped that found an element turned inside out, or a number that is none.
struct Inversion {
    std::string
        what; ///< "element 17 of part a and 15 others have no positive volume any more: ..."
    std::string advice; ///< by what the element had gone through
};
Inversion inversionOf(Solver& solver, const Model& model);

} // namespace fpm
