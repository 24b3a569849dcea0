#include "solver/contact/ContactSolver.h"

#include "base/Hash.h"

namespace fpm {

ContactSolver::ContactSolver(const SolverSetUp& setUp,
                             SolverFields& fields,
                             ContactLaunches& launches,
                             Backend& backend,
                             std::size_t pairs)
    : setUp_(setUp),
      fields_(fields),
      launches_(launches),
      backend_(backend),
      overlaps_(pairs)
{
}

void ContactSolver::updateForces()
{
    if (setUp_.contact.passes.empty()) return;
    backend_.timed(seconds_, [this] { launches_.forces(); });
}

void ContactSolver::measureOverlaps()
{
    for (std::size_t pass = 0; pass < setUp_.contact.passes.size(); ++pass) {
        if (setUp_.contact.passes[pass].surface >= 0) continue; // its set-up has reported it
        launches_.measureOverlaps(pass);
        backend_.synchronize();
        noteOverlaps(pass, fields_.contact.passes[pass]->overlap.toHost());
        if (!setUp_.contact.passes[pass].forgives) launches_.clearOverlaps(pass);
        launches_.clearCounts(pass);
    }
}

void ContactSolver::noteOverlaps(std::size_t number, const std::vector<float>& depths)
{
    const ContactPassSetup& pass = setUp_.contact.passes[number];
    PairOverlap& found = overlaps_[pass.pair];
    for (std::size_t i = 0; i < depths.size(); ++i) {
        // A millionth of a face's width is contact, not overlap.
        if (!(double(depths[i]) > 1e-6 * pass.meanFaceSize)) continue;
        ++found.count;
        if (double(depths[i]) <= found.deepest) continue;
        found.deepest = double(depths[i]);
        found.node = pass.contactor[i];
    }
}

std::uint64_t ContactSolver::checksum(std::uint64_t hash) const
{
    for (const auto& pass : fields_.contact.passes) {
        const std::vector<std::byte> force = pass->tangentialForce.image();
        hash = hashedBytes(hash, force.data(), force.size());
    }
    return hash;
}

} // namespace fpm
