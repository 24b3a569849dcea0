#pragma once

#include "base/Log.h"
#include "io/Table.h"
#include "model/Model.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace fpm {

/// The most that was seen of a part in all frames.
struct PartExtremes {
    double mises = 0, plasticStrain = 0;
    double strainEnergy = 0; ///< elastic, of the centre stresses
    double deviation = 0;    ///< from the best rigid motion, root mean square [length]
};

/// Steps of a run, and what bounded the last one.
struct StepFigures {
    double count = 0, time = 0; ///< made until then
    double elementStep = 0;     ///< bound of the elements alone, at the end
    std::string limit;          ///< the pair and node whose springs did; empty: the elements
};

/// Results of a finished or pilot run, from its frames and histories.
struct Results {
    double lastTime = 0, longestStep = 0; ///< of the frames
    std::size_t frames = 0;
    double fastest = 0; ///< speed of any node in any frame
    std::vector<PartExtremes> parts;
    /// Lowest and highest position of each node.
    std::vector<Point> low, high;
    std::optional<Table> energies;
    /// Of each contact pair, dissipated by friction; nothing where the run has no such result.
    std::vector<std::optional<double>> frictionWork;
    std::optional<StepFigures> steps; ///< nothing where the run has none
};

/// Results of the run that `status` names; the log says what is left out. Nothing where that run
/// has fewer than two frames of the present mesh.
std::optional<Results>
readResults(const std::filesystem::path& caseRoot, const Model& model, Log& log);

/// Largest value of a column of the energies.
double largest(const Table& table, const std::string& column);
/// Of kinetic, internal and external.
double largestEnergy(const Table& energies);

} // namespace fpm
