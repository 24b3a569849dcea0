#include "stability/TrialRun.h"

#include "base/Error.h"
#include "solver/Solver.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

/// Largest over all pairs of depth weighted by force, 2 E / F, over the width of a face.
double depthOf(Solver& solver, std::size_t pairs)
{
    double most = 0;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        const PairForce now = solver.contact().force(pair);
        const double force = std::hypot(now.force[0], now.force[1], now.force[2]);
        double width = 0;
        for (const ContactPassSetup& pass : solver.contact().setUp().passes)
            if (pass.pair == pair) width = std::max(width, pass.meanFaceSize);
        if (force > 0 && width > 0) most = std::max(most, 2 * now.springEnergy / (force * width));
    }
    return most;
}

double meanAlong(Solver& solver, const std::vector<Index>& nodes, int axis)
{
    const NodeValues values = solver.nodes().values(nodes);
    double sum = 0;
    for (std::size_t i = 0; i < values.count; ++i) sum += values.at(0, i)[std::size_t(axis)];
    return sum / double(std::max<std::size_t>(1, values.count));
}

/// Follows one run.
class Watch
{
public:
    Watch(Solver& solver, const Trial& trial, const TrialLimits& limits)
        : solver_(solver),
          trial_(trial),
          limits_(limits)
    {
        const Energies start = solver.ledger().energies();
        scale_ = start.total;
    }

    /// False once the end is clear.
    bool sample()
    {
        const StepClock clock = solver_.clock();
        result_.steps = double(clock.steps);
        const Energies now = solver_.ledger().energies();
        const double error = std::abs(now.balance), gained = std::abs(now.total - now.external);
        scale_ = std::max(scale_, std::abs(now.external));
        if (!(error <= result_.energyError)) result_.energyError = error;
        if (!std::isfinite(now.total) || gained > 100 * scale_) return end(Outcome::diverged);
        if (clock.failed) return end(error > 1 ? Outcome::diverged : Outcome::inverted);
        const std::size_t pairs = trial_.model.contactPairs.size();
        result_.penetration = std::max(result_.penetration, depthOf(solver_, pairs));
        for (std::size_t pair = 0; pair < pairs; ++pair)
            if (solver_.contact().force(pair).released > 0) lost_ = true;
        sampleContact(pairs);
        return true;
    }
    TrialResult result()
    {
        if (result_.outcome != Outcome::stable) return result_;
        if (trial_.passed > 0) {
            const double gap = meanAlong(solver_, trial_.upper, trial_.axis)
                               - meanAlong(solver_, trial_.lower, trial_.axis);
            lost_ |= gap < -trial_.passed;
        }
        if (lost_)
            result_.outcome = Outcome::tunnelled;
        else if (result_.energyError > limits_.energy)
            result_.outcome = Outcome::energyDrift;
        else if (result_.penetration > limits_.penetration)
            result_.outcome = Outcome::penetration;
        else if (trial_.staysClosed && double(changes_) > limits_.chatter * double(samples_))
            result_.outcome = Outcome::chatter;
        return result_;
    }

private:
    bool end(Outcome outcome)
    {
        result_.outcome = outcome;
        return false;
    }
    void sampleContact(std::size_t pairs)
    {
        bool closed = false;
        for (std::size_t pair = 0; pair < pairs; ++pair)
            closed |= solver_.contact().force(pair).active > 0;
        ++samples_;
        if (samples_ > 1 && closed != closed_) ++changes_;
        closed_ = closed;
    }

    Solver& solver_;
    const Trial& trial_;
    TrialLimits limits_;
    TrialResult result_;
    double scale_ = 0;
    std::int64_t samples_ = 0, changes_ = 0;
    bool closed_ = false, lost_ = false;
};

} // namespace

const char* nameOf(Outcome outcome)
{
    static constexpr const char* names[outcomeCount] = {
        "stable", "energy drift", "chatter", "penetration", "tunnelled", "inverted", "diverged"};
    return names[int(outcome)];
}

TrialResult runTrial(const Trial& trial,
                     const Setting& setting,
                     const Bounds& bounds,
                     const TrialLimits& limits)
{
    Model model = trial.model;
    if (setting.has(parameter::timeStep)) {
        model.control.fixedTimeStep = setting.of(parameter::timeStep, 1) * bounds.elementStep;
        model.control.beyondBound = true;
    }
    const auto solver = makeSolver(model);
    solver->start();
    Watch watch(*solver, trial, limits);
    for (int done = 0; done < limits.steps; done += 5) {
        solver->advance(model.control.endTime, 5);
        if (!watch.sample() || solver->clock().time >= model.control.endTime) break;
    }
    return watch.result();
}

} // namespace fpm
