#pragma once

#include "solver/Solver.h"

#include <string>

namespace fpm {

/// Why a run stopped that found an element turned inside out, or a number that is none.
struct Inversion {
    std::string what;   ///< "element 17 of part a has no positive volume any more: ..."
    std::string advice; ///< by what the element had gone through
};
Inversion inversionOf(Solver& solver, const Model& model);

/// What helps where velocities, forces or energies are no numbers any more.
inline constexpr const char* noNumberAdvice =
    "check the sizes and units of initial velocities, drives and loads, and whether the precision "
    "holds them; else try a smaller timeStep.safety or normalScale";

} // namespace fpm
