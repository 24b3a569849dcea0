#pragma once

#include "kernels/contact/distribute/PassSums.h"
#include "solver/SolverFields.h"
#include "solver/backend/Launches.h"
#include "solver/contact/ContactReadings.h"

#include <array>

namespace fpm {

/// The contact solver of the paper: forces between surfaces, and what is read of them. Pairs by
/// their number in the model.
class ContactSolver
{
public:
    ContactSolver(const SolverSetUp& setUp,
                  SolverFields& fields,
                  ContactLaunches& launches,
                  Backend& backend,
                  std::size_t pairs);

    /// Forces at the present positions, and the bound of the next step from their springs.
    void updateForces();
    /// Notes what lies inside before the run; it makes full force in passes that do not forgive it.
    void measureOverlaps();

    const ContactSetUp& setUp() const { return setUp_.contact; }
    PairForce force(std::size_t pair);
    PairStatus status(std::size_t pair);
    ContactBound bound() const;
    PairOverlap initialOverlap(std::size_t pair) const { return overlaps_[pair]; }
    /// Of each node that is a contactor with a target within reach: the distance to it, negative
    /// inside, the least where it has several; NaN of all others. Overlaps that are forgiven count.
    std::vector<double> gaps();
    /// Of one pass, as PassSum; added up on the device, once a step however many ask.
    std::array<double, passSums> sumsOf(std::size_t pass);
    /// FNV-1a over the stored friction, continuing from `hash`.
    std::uint64_t checksum(std::uint64_t hash) const;
    double seconds() const { return seconds_; }

private:
    void addUp();
    void noteOverlaps(std::size_t pass, const std::vector<float>& depths);
    std::vector<double> statusOf(std::size_t pass);
    std::vector<double> gapsOf(std::size_t pass);

    const SolverSetUp& setUp_;
    SolverFields& fields_;
    ContactLaunches& launches_;
    Backend& backend_;
    std::vector<PairOverlap> overlaps_;              ///< of each pair of the model
    std::vector<std::array<double, passSums>> sums_; ///< of each pass,
    std::int64_t sumsStep_ = -1;                     ///< after so many steps
    double seconds_ = 0;
};

} // namespace fpm
