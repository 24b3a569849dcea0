#pragma once

#include "model/Model.h"
#include "solver/ExplicitStep.h"
#include "solver/SolverFields.h"
#include "solver/backend/IdleCores.h"
#include "solver/contact/ContactRenewal.h"
#include "solver/ledger/Ledger.h"

#include <functional>
#include <memory>
#include <string>

namespace fpm {

/// Seconds spent. On a GPU the parts are scaled up from a sample of the steps; 0 before the first.
struct StepTimes {
    double total = 0, element = 0, contact = 0, node = 0, search = 0;
    std::int64_t searches = 0; ///< of single passes
    double threads = 0;        ///< of the CPU, on average; 0 on a GPU
    std::int64_t steps = 0;    ///< made in these seconds; fewer than those of a run that goes on
};

/// Where an advance comes back before its end.
struct Pause {
    double at = 1e300; ///< after the first step at or after this time
    /// Given the clock every few steps, between two of them; false: comes back now. Must not touch
    /// the solver. No bit depends on where it does.
    std::function<bool(const StepClock&)> goesOn;
};

/// Where a model is computed: an executor and the kernels for it.
struct Machine {
    std::string description; ///< "openmp, 2 threads, avx512, double"
    std::unique_ptr<Backend> backend;
    NumberTypes numbers;
    /// Makes the kernels that work on these; all of them outlive what is made.
    std::function<Launches(const SolverSetUp&, SolverFields&, const StepSettings&)> launches;
};

/// A model in motion. Positions, stress and forces belong to clock().time,
/// velocities to half a step before.
class Solver
{
public:
    /// `audit`: book nodal works of every force family, for tests.
    Solver(const Model& model, Machine machine, bool audit);

    /// Forces at the start, without motion. Called once, before the first advance().
    void start();
    /// All that the next step reads, of a moment between two steps.
    std::vector<FieldSet::Images> state() { return fields_.state(); }
    /// In place of start(): goes on from the state of a solver of the same model and precision, on
    /// whatever backend. Throws Error(checkpoint) where it does not fit the model.
    void restore(const std::vector<FieldSet::Images>& state);
    /// Steps until `time` is reached exactly or `maxSteps` are done. Stops early on
    /// failure (StepClock::failed) and when dynamic relaxation is at rest (StepClock::settled).
    void advance(double time, std::int64_t maxSteps, const Pause& pause = {});
    /// Goes on with so many threads of the CPU, those it was made with at most. No bit depends on
    /// it.
    void useThreads(int threads);

    StepClock clock() const { return fields_.clock.clock.toHost()[0]; }
    StepTimes times() const;
    const std::string& description() const { return machine_.description; }
    SolverFields& fields() { return fields_; }

    ElementSolver& elements() { return elements_; }
    const ElementSolver& elements() const { return elements_; }
    ContactSolver& contact() { return contact_; }
    const ContactSolver& contact() const { return contact_; }
    NodeSolver& nodes() { return nodes_; }
    const NodeSolver& nodes() const { return nodes_; }
    BodySolver& bodies() { return bodies_; }
    const BodySolver& bodies() const { return bodies_; }
    Ledger& ledger() { return ledger_; }

private:
    void step();
    std::int64_t stepsToMake(const StepClock& now, std::int64_t last);
    void followDeletions(StepClock& now);

    Machine machine_;
    Backend& backend_;
    SolverSetUp setUp_;
    StepSettings settings_;
    SolverFields fields_;
    Launches launches_;
    ElementSolver elements_;
    NodeSolver nodes_;
    BodySolver bodies_;
    ContactSolver contact_;
    ContactLists lists_;
    Ledger ledger_;
    ExplicitStep step_;
    std::unique_ptr<ContactRenewal> renewal_; ///< null unless deletions change contact surfaces
    std::unique_ptr<IdleCores> cores_;        ///< null where the number of threads is fixed
    double seconds_ = 0;
    std::int64_t firstStep_ = 0; ///< of this solver: those before were another's
};

/// Builds the solver for the model's backend, vector width and precision. Throws Error(device) when
/// the backend is not in this build or the machine lacks it; never falls back silently.
std::unique_ptr<Solver> makeSolver(const Model& model, bool audit = false);
/// Threads of the CPU that a run has at most: as many as it may use cores, or OMP_NUM_THREADS,
/// where openmp has no other instruction. Without both it follows the cores that are idle
/// (IdleCores).
int threadCount(const Control& control);
/// FNV-1a over positions, velocities, stress, plastic strain, hourglass forces, friction.
std::uint64_t stateChecksum(Solver& solver);

} // namespace fpm
