#pragma once

#include "solver/SolverFields.h"
#include "solver/backend/Launches.h"
#include "solver/clock/StepSettings.h"
#include "solver/contact/ContactSolver.h"
#include "solver/ledger/Energies.h"

#include <array>

namespace fpm {

/// The balance of work and energy of a run.
class Ledger
{
public:
    /// `rounding`: energy below which an error is no error; see roundingEnergy.
    Ledger(const SolverSetUp& setUp,
           SolverFields& fields,
           ContactSolver& contact,
           MotionLaunches& launches,
           Backend& backend,
           const StepSettings& settings,
           double rounding);

    /// The energy that is there before the first step.
    void start();
    Energies energies();
    /// The same without a trace: the balance of later times does not depend on whether this was
    /// asked for.
    Energies peek();
    /// Kinetic energy of this time, between the two half steps that its forces make, but for those
    /// of surfaces that are met exactly: they are not known before the second one.
    double kinetic() { return kineticEnergy(false)[0]; }
    NodalWorks nodalWorks() const;

private:
    std::array<double, 2> kineticEnergy(bool reactions);
    std::array<double, nodeWorks> works() const;
    void addElements(Energies& out) const;
    double addContact(Energies& out) const;
    void balance(Energies& out);

    const SolverSetUp& setUp_;
    SolverFields& fields_;
    ContactSolver& contact_;
    MotionLaunches& launches_;
    Backend& backend_;
    const StepSettings& settings_;
};

/// Energy below which the balance of a run is no error but rounding.
double roundingEnergy(const Model& model);

} // namespace fpm
