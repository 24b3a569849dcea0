#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "model/Model.h"

namespace fpm {

/// constant/caseProperties: title and units.
struct CaseProperties {
    std::string title;
    std::array<std::string, 3> units; ///< length, mass, time
};
CaseProperties readCaseProperties(const Dictionary& dictionary);

/// Metres in one of the case's length units divided by seconds in one of its time units.
double metresPerSecond(const std::array<std::string, 3>& units);

/// What a column of a table is measured in.
enum class Quantity {
    none,
    time,
    length,
    velocity,
    acceleration,
    force,
    moment,
    energy,
    spin,
    momentum,
    angularMomentum
};
/// Its unit in the case's: "mm/s", "N", "mJ"; "-" without, "tonne*mm/s^2" where it has no name.
/// Momenta are forces and moments times time.
std::string unitOf(Quantity quantity, const std::array<std::string, 3>& units);

/// Speed of compression waves, sqrt((lambda + 2 mu) / rho) [length/time].
double waveSpeed(const Part& part);

/// Warns when a part's wave speed, in m/s, is one no solid has (50 ... 20000), or its density, in
/// kg/m3 (1 ... 30000): the usual signs of values given in other units than the rest.
void checkUnits(const std::vector<Part>& parts, const std::array<std::string, 3>& units, Log& log);
/// The same of the largest acceleration of a gravity, in m/s2 (0.1 ... 1000).
void checkGravity(const std::vector<BoundaryCondition>& conditions,
                  const std::array<std::string, 3>& units,
                  Log& log);

} // namespace fpm
