#pragma once

#include "io/Table.h"
#include "solver/Solver.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace fpm {

/// The history files of a run: postProcessing/<name>/0/*.dat, one row a sample.
class Histories
{
public:
    /// `runId` goes into the head of every file; none where it is empty.
    Histories(const std::filesystem::path& caseRoot,
              const Model& model,
              const std::string& runId = "");
    /// Appends one row to every file; `energies` belong to the solver's present time.
    void sample(Solver& solver, const Energies& energies);

private:
    struct Channel {
        const History* history;
        std::vector<std::unique_ptr<HistoryFile>> files; ///< one a field or contact pair
        Condition drive;               ///< reaction: what its condition or surface is moved by
        std::vector<double> driveRows; ///< its amplitude
    };
    void samplePoint(Channel& channel, Solver& solver, double time);
    void sampleReaction(Channel& channel, Solver& solver, double time);
    void sampleBody(Channel& channel, Solver& solver, double time);
    void sampleContact(Channel& channel, Solver& solver, double time);

    const Model& model_;
    std::vector<Channel> channels_;
};

/// Column names of rigidBody.dat: displacement and velocity of the centre, angular velocity in
/// global axes and in axes that turn with the body, force and moment of contact and loads.
std::vector<std::string> rigidBodyColumns();

/// Column names of energies.dat.
std::vector<std::string> energyColumns();

} // namespace fpm
