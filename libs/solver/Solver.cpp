#include "solver/Solver.h"

#include "base/Hash.h"
#include "parallel/LaunchSizes.h"

#include <algorithm>
#include <chrono>

namespace fpm {

namespace {

StepSettings settingsOf(const Model& model, const SolverSetUp& setUp, bool audit)
{
    const Control& control = model.control;
    StepSettings out;
    out.massDamping = control.massDamping;
    out.midStepStrain = control.midStepStrain;
    // A scene without loads, drives and damping needs no works of nodes.
    out.ledger = audit || !setUp.nodes.conditions.empty() || control.massDamping > 0
                 || setUp.nodes.relaxation.tolerance > 0;
    out.rules.safety = control.timeStepSafety;
    out.rules.contactLimit = control.contactStepLimit;
    out.rules.maximumStep = control.maximumTimeStep;
    out.rules.fixedStep = control.fixedTimeStep;
    out.rules.beyondBound = control.beyondBound;
    return out;
}

} // namespace

Solver::Solver(const Model& model, Machine machine, bool audit)
    : machine_(std::move(machine)),
      backend_(*machine_.backend),
      setUp_(makeSetUp(model, audit)),
      settings_(settingsOf(model, setUp_, audit)),
      fields_(setUp_, model.mesh.points, backend_.memory(), machine_.numbers),
      launches_(machine_.launches(setUp_, fields_, settings_)),
      elements_(setUp_.elements, fields_.elements, *launches_.elements, backend_),
      nodes_(setUp_.nodes, fields_.nodes, *launches_.motion, backend_),
      bodies_(setUp_.bodies,
              fields_.bodies,
              fields_.clock,
              *launches_.motion,
              backend_,
              settings_.massDamping),
      contact_(setUp_, fields_, *launches_.contact, backend_, model.contactPairs.size()),
      lists_(setUp_,
             fields_.contact,
             fields_.nodes,
             fields_.ledger,
             *launches_.lists,
             backend_,
             model.control.searchInterval),
      ledger_(
          setUp_, fields_, contact_, *launches_.motion, backend_, settings_, roundingEnergy(model)),
      step_(elements_, contact_, lists_, nodes_, bodies_)
{
    if (followsIdleCores(model.control)) {
        cores_ = std::make_unique<IdleCores>(threadCount(model.control));
        backend_.useThreads(cores_->threads());
    }
    if (setUp_.elements.erodes && !setUp_.contact.passes.empty())
        renewal_ = std::make_unique<ContactRenewal>(model, setUp_, fields_);
}

void Solver::start()
{
    if (lists_.any()) {
        lists_.searchNow();
        contact_.measureOverlaps();
        lists_.forgetSeconds(); // of steps is asked
    }
    step_.updateForces();
    ledger_.start();
}

void Solver::advance(double time, std::int64_t maxSteps)
{
    const auto begin = std::chrono::steady_clock::now();
    StepClock now = clock();
    if (now.failed || now.settled || now.time >= time) return;
    now.stop = time;
    now.running = 1;
    fields_.clock.clock.fromHost({now});
    const std::int64_t last = now.steps + maxSteps;
    while (!now.failed && !now.settled && now.time < time && now.steps < last) {
        const std::int64_t steps = stepsToMake(now, last);
        if (cores_) useThreads(cores_->threads());
        backend_.repeat(
            steps, [this, steps] { step_.prepare(Index(steps)); }, [this] { step(); });
        backend_.synchronize();
        now = clock();
        if (now.waits) lists_.makeWaiting();
        if (now.deletions != fields_.ledger.deletions()) followDeletions();
        fields_.ledger.deletions = now.deletions;
        if (observer_) observer_(now);
    }
    if (now.time >= time) nodes_.judge();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Until the host has to look after the run again, `last` at most.
std::int64_t Solver::stepsToMake(const StepClock& now, std::int64_t last)
{
    // The size of the first step is not known before it is made.
    const std::int64_t steps = now.step <= 0 ? 1 : stepsPerGraph;
    return lists_.searchIfDue(now.steps, std::min(steps, last - now.steps));
}

/// Does nothing once contact lists have to be made.
void Solver::step()
{
    if (backend_.sharesMemory() && !fields_.clock.clock.data()->mayStep()) return;
    step_.advance();
}

void Solver::useThreads(int threads)
{
    const int before = backend_.threads();
    backend_.useThreads(threads);
    if (backend_.threads() != before) lists_.shareAmongThreads();
}

void Solver::followDeletions()
{
    const bool presses = !setUp_.nodes.pressureFaceCondition.empty();
    if (!presses && !renewal_) return;
    const std::vector<bool> deleted = elements_.values().deleted;
    if (presses) nodes_.endPressures(setUp_.nodes, deleted);
    if (!renewal_ || !renewal_->follow(deleted)) return;
    backend_.forgetSteps();
    lists_.renew();
}

StepTimes Solver::times() const
{
    StepTimes out;
    const double scale = backend_.timedScale();
    out.total = seconds_;
    out.element = scale * elements_.seconds();
    out.contact = scale * contact_.seconds();
    out.node = scale * (nodes_.seconds() + bodies_.seconds());
    out.search = lists_.seconds();
    out.threads = cores_ ? cores_->mean() : backend_.threads();
    out.searches = lists_.searches(clock().steps);
    return out;
}

std::uint64_t stateChecksum(Solver& solver)
{
    const std::uint64_t nodes = solver.nodes().checksum(hashStart);
    return solver.contact().checksum(solver.elements().checksum(nodes));
}

} // namespace fpm
