#include "solver/Solver.h"

#include "base/Hash.h"
#include "parallel/CountedMemory.h"
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

/// Memory of the backend, once it has said that the fields of the run will fit.
const Memory& fitting(const Backend& backend,
                      const SolverSetUp& setUp,
                      const std::vector<Point>& points,
                      const NumberTypes& numbers)
{
    if (!backend.sharesMemory()) {
        const CountedMemory counted;
        backend.memory().require(SolverFields(setUp, points, counted, numbers).bytes());
    }
    return backend.memory();
}

} // namespace

Solver::Solver(const Model& model, Machine machine, bool audit)
    : machine_(std::move(machine)),
      backend_(*machine_.backend),
      setUp_(makeSetUp(model, audit)),
      settings_(settingsOf(model, setUp_, audit)),
      fields_(setUp_,
              model.mesh.points,
              fitting(backend_, setUp_, model.mesh.points, machine_.numbers),
              machine_.numbers),
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
    if (renewal_ || (setUp_.elements.erodes && !setUp_.nodes.pressureFaceCondition.empty())) {
        StepClock follows = clock();
        follows.followed = 0;
        fields_.clock.clock.fromHost({follows});
    }
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

/// Contact surfaces follow from the deleted elements, and where the passes have their values, from
/// the surfaces: elements are restored first.
void Solver::restore(const std::vector<FieldSet::Images>& state)
{
    fields_.restoreMotion(state);
    if (setUp_.elements.erodes) {
        const std::vector<bool> deleted = elements_.values().deleted;
        nodes_.endPressures(setUp_.nodes, deleted);
        if (renewal_ && renewal_->rebuild(deleted)) lists_.renewFields();
    }
    fields_.restore(state);
    lists_.restored();
    backend_.forgetSteps();
    firstStep_ = clock().steps;
}

void Solver::advance(double time, std::int64_t maxSteps, const Pause& pause)
{
    const auto begin = std::chrono::steady_clock::now();
    StepClock now = clock();
    const auto mayStep = [&] {
        return !now.failed && !now.settled && now.time < time && now.time < pause.at;
    };
    if (!mayStep()) return;
    now.stop = time;
    now.pause = pause.at;
    now.running = 1;
    fields_.clock.clock.fromHost({now});
    const std::int64_t last = now.steps + maxSteps;
    while (mayStep() && now.steps < last) {
        const std::int64_t steps = stepsToMake(now, last);
        const bool checks = lists_.stepsToCheck(now) == 0;
        // The size of the first step is not known before it is made.
        const Index ahead = now.step > 0 ? Index(stepsPerGraph) : 1;
        if (cores_) useThreads(cores_->threads());
        backend_.repeat(
            steps,
            [this, checks, ahead] {
                if (checks) step_.prepare(ahead);
            },
            [this] { step(); });
        backend_.synchronize();
        now = clock();
        if (now.waits) lists_.makeWaiting();
        if (now.followed >= 0 && now.deletions != now.followed) followDeletions(now);
        if (pause.goesOn && !pause.goesOn(now)) break;
    }
    if (now.time >= time) nodes_.judge();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Until the host has to look after the run again, `last` at most.
std::int64_t Solver::stepsToMake(const StepClock& now, std::int64_t last)
{
    std::int64_t steps = now.step > 0 ? stepsPerGraph : 1;
    if (const std::int64_t valid = lists_.stepsToCheck(now); valid > 0)
        steps = std::min(steps, valid);
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

/// At the step of the deletion, wherever the host would look next: no bit depends on that.
void Solver::followDeletions(StepClock& now)
{
    const std::vector<bool> deleted = elements_.values().deleted;
    if (!setUp_.nodes.pressureFaceCondition.empty()) nodes_.endPressures(setUp_.nodes, deleted);
    const double before = renewal_ ? ledger_.kinetic() : 0;
    if (renewal_ && renewal_->follow(deleted)) {
        backend_.forgetSteps();
        lists_.renew();
        if (lists_.areChecked()) now.listsValidUntil = now.steps;
        // Forces that vanish between the two half steps of this time do not do their second half
        // work, which the springs have given up already.
        fields_.ledger.lostSpring += before - ledger_.kinetic();
    }
    now.followed = now.deletions;
    now.running = 1;
    fields_.clock.clock.fromHost({now});
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
    out.steps = clock().steps - firstStep_;
    return out;
}

std::uint64_t stateChecksum(Solver& solver)
{
    const std::uint64_t nodes = solver.nodes().checksum(hashStart);
    return solver.contact().checksum(solver.elements().checksum(nodes));
}

} // namespace fpm
