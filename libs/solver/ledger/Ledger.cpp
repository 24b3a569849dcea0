#include "solver/ledger/Ledger.h"

#include <algorithm>
#include <cmath>

namespace fpm {

Ledger::Ledger(const SolverSetUp& setUp,
               SolverFields& fields,
               ContactSolver& contact,
               MotionLaunches& launches,
               Backend& backend,
               const StepSettings& settings,
               double rounding)
    : setUp_(setUp),
      fields_(fields),
      contact_(contact),
      launches_(launches),
      backend_(backend),
      settings_(settings)
{
    fields_.ledger.largestEnergy = rounding;
}

void Ledger::start()
{
    const Energies first = energies();
    fields_.ledger.startEnergy = first.total - first.external;
}

/// Kinetic energy, and the half work of loads and drives that closes the ledger at this time.
std::array<double, 2> Ledger::kineticEnergy(bool reactions)
{
    launches_.kineticEnergy(reactions);
    backend_.synchronize();
    std::array<double, 2> sums{0, 0};
    const std::vector<double> blocks = fields_.nodes.blockEnergy.toHost();
    for (std::size_t i = 0; i < blocks.size(); ++i) sums[i % 2] += blocks[i];
    const StepClock now = fields_.clock.clock.toHost()[0];
    for (const RigidBody& body : fields_.bodies.bodies.toHost()) {
        const auto [kinetic, closing] = bodyEnergy(body, now.step);
        sums[0] += kinetic;
        sums[1] += closing;
    }
    return sums;
}

std::array<double, nodeWorks> Ledger::works() const
{
    std::array<double, nodeWorks> sums{};
    const std::vector<double> blocks = fields_.nodes.blockWork.toHost();
    for (std::size_t i = 0; i < blocks.size(); ++i) sums[i % nodeWorks] += blocks[i];
    for (const RigidBody& body : fields_.bodies.bodies.toHost())
        for (std::size_t k = 0; k < nodeWorks; ++k) sums[k] += body.work[k];
    return sums;
}

NodalWorks Ledger::nodalWorks() const
{
    backend_.synchronize();
    const auto sums = works();
    return {sums[internalBefore] + sums[internalAfter], sums[contactBefore] + sums[contactAfter],
            sums[externalBefore] + sums[externalAfter], sums[driveBefore] + sums[driveAfter],
            sums[damping]};
}

void Ledger::addElements(Energies& out) const
{
    const std::vector<double> patches = fields_.elements.patchEnergy.toHost();
    out.parts.resize(setUp_.elements.materials.size());
    for (std::size_t patch = 0; patch < setUp_.elements.patches.size(); ++patch) {
        const double* sums = patches.data() + elementEnergies * patch;
        PartEnergies& of = out.parts[std::size_t(setUp_.elements.patches[patch].material)];
        of.internal += sums[0];
        of.plastic += sums[1];
        of.hourglass += sums[2];
        out.bulkViscosity += sums[3];
    }
    for (const PartEnergies& part : out.parts) {
        out.internal += part.internal;
        out.plastic += part.plastic;
        out.hourglass += part.hourglass;
    }
}

/// Returns what the end of forgiven overlaps put into springs.
double Ledger::addContact(Energies& out) const
{
    out.contact = fields_.ledger.lostSpring();
    out.friction = fields_.ledger.lostFriction();
    out.contactDamping = fields_.ledger.lostDamping();
    out.external = fields_.ledger.lostWork();
    double faded = 0;
    for (std::size_t pass = 0; pass < setUp_.contact.passes.size(); ++pass) {
        const std::array<double, passSums> sums = contact_.sumsOf(pass);
        out.contact += sums[sumSpringEnergy];
        out.friction += sums[sumDissipated];
        out.contactDamping += sums[sumDamped];
        out.external += sums[sumSurfaceWork];
        faded += sums[sumInjected];
    }
    return faded;
}

Energies Ledger::energies()
{
    backend_.synchronize();
    Energies out;
    out.time = fields_.clock.clock.toHost()[0].time;
    const auto [kinetic, closing] = kineticEnergy(true);
    out.kinetic = kinetic;
    addElements(out);
    const double faded = addContact(out);
    if (settings_.ledger) {
        const auto sums = works();
        out.damping = sums[NodeWork::damping];
        out.external += sums[externalBefore] + sums[externalAfter] + sums[driveBefore]
                        + sums[driveAfter] + closing;
    }
    out.external += faded;
    balance(out);
    return out;
}

Energies Ledger::peek()
{
    const double largest = fields_.ledger.largestEnergy();
    const Energies out = energies();
    fields_.ledger.largestEnergy = largest;
    return out;
}

void Ledger::balance(Energies& out)
{
    out.total = out.kinetic + out.internal + out.hourglass + out.bulkViscosity + out.contact
                + out.friction + out.contactDamping + out.damping;
    // A body that friction has brought to rest is judged by the energy it came with.
    const double lost = out.friction + out.contactDamping + out.damping;
    const double start = fields_.ledger.startEnergy();
    out.scale = std::max({fields_.ledger.largestEnergy(), out.kinetic, out.internal,
                          std::abs(out.external), lost, start});
    fields_.ledger.largestEnergy = out.scale;
    out.error = out.total - out.external - start;
    out.balance = out.scale > 0 ? out.error / out.scale : 0;
}

} // namespace fpm
