#pragma once

#include "run/HealthRow.h"
#include "solver/Solver.h"

namespace fpm {

/// Judges the ledger: balance, hourglass share of each part, contact springs, inertia.
class EnergyHealth
{
public:
    explicit EnergyHealth(const Model& model);
    /// `judged`: enough steps were made for a balance to mean something.
    void sample(const Energies& energies, bool judged);
    void addRows(HealthRows& rows) const;
    void keep(Archive& archive);

private:
    struct OfPart {
        Peak internal, hourglass;
    };
    void addPart(std::size_t part, HealthRows& rows) const;
    void addContact(HealthRows& rows) const;
    void addInertia(HealthRows& rows) const;
    bool counts(double energy) const;

    const Model& model_;
    std::vector<OfPart> parts_;
    Peak balance_, kineticShare_;
    Peak elastic_;                      ///< what elements and springs can give back
    double contact_ = 0, internal_ = 0; ///< at that time
    double scale_ = 0;
};

} // namespace fpm
