#pragma once

#include "solver/Solver.h"

namespace fpm {

/// What a history row is made of, asked of the solver once.
struct Sample {
    Energies energies;
    std::vector<PairStatus> pairs; ///< as Model::contactPairs
    std::vector<PairForce> forces;
    Sample(Solver& solver, const Model& model) : energies(solver.ledger().energies())
    {
        for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair) {
            pairs.push_back(solver.contact().status(pair));
            forces.push_back(solver.contact().force(pair));
        }
    }
};

} // namespace fpm
