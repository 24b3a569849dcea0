#include "run/TimeLoop.h"

#include "base/Error.h"
#include "base/Format.h"
#include "case/RunRecord.h"
#include "io/Frames.h"
#include "io/OutputFolder.h"
#include "run/ContactWatch.h"
#include "run/Health.h"
#include "run/HealthTable.h"
#include "run/Histories.h"
#include "run/Inversion.h"
#include "run/Performance.h"
#include "run/RunForecast.h"
#include "run/RunReport.h"
#include "run/SignalWatch.h"
#include "run/resultFrame.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fpm {

namespace {

double secondsSince(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string clockText(double seconds)
{
    const long s = std::lround(std::clamp(seconds, 0.0, 3.6e8));
    const auto two = [](long n) { return std::string(n < 10 ? "0" : "") + std::to_string(n); };
    return two(s / 3600) + ":" + two(s / 60 % 60) + ":" + two(s % 60);
}

/// Where the state goes that stopped a run: no time folder, and so no frame of the series.
const char* const failedFolder = "failed";

/// One run from start to end: what is due when, and what goes where.
class TimeLoop
{
public:
    TimeLoop(Solver& solver,
             const Model& model,
             const std::filesystem::path& caseRoot,
             const RunOptions& options,
             Log& log)
        : solver_(solver),
          model_(model),
          control_(model.control),
          root_(caseRoot),
          options_(options),
          log_(log),
          record_(OutputFolder(root_), model.control.previousRun, log),
          histories_(root_, model, record_.id()),
          health_(model, solver),
          edges_(model)
    {
    }

    void run()
    {
        try {
            loop();
        } catch (const Error& error) {
            end(error.code() == ExitCode::stopped ? RunState::stopped : RunState::failed);
            throw;
        }
        end(RunState::finished);
        if (options_.strict && findings(verdicts_) > 0)
            throw Error(ExitCode::unhealthy, healthVerdict(verdicts_) + " (-strict)",
                        "the table of health above says what, where and what helps");
        log_.line(healthVerdict(verdicts_));
    }

private:
    void loop()
    {
        const SignalWatch signals;
        reportMassScaling(solver_, log_);
        sample();
        reportOverlaps(solver_, model_, log_);
        writeFrame();
        reportStart(solver_, model_, root_, options_.maxSteps, log_);
        while (!done()) {
            const double nextFrame = frameTime(frames_);
            const double due = std::min(nextFrame, sampleTime(samples_));
            advanceTo(due, nextFrame);
            check();
            const bool frameIsDue = clock_.time >= nextFrame || clock_.settled;
            if (clock_.time >= sampleTime(samples_) - tiny() || done())
                sample();
            else if (frameIsDue)
                judge(solver_.ledger().energies()); // no frame holds a state that is lost
            if (frameIsDue) writeFrame();
            progress();
            if (signals.raised()) {
                if (clock_.time > lastFrame_) writeFrame();
                finish();
                throw Error(ExitCode::stopped, format("stopped by signal at time {}", clock_.time),
                            "frames and histories up to this time are complete; a new run starts "
                            "at time 0");
            }
        }
        finish();
    }

    bool done() const
    {
        return clock_.settled || clock_.time >= control_.endTime
               || (options_.maxSteps >= 0 && clock_.steps >= options_.maxSteps);
    }
    double tiny() const { return 1e-9 * control_.endTime; }
    double frameTime(std::int64_t number) const
    {
        const double time = double(number) * control_.writeInterval;
        return time > control_.endTime - 1e-6 * control_.writeInterval ? control_.endTime : time;
    }
    double sampleTime(std::int64_t number) const
    {
        return std::min(double(number) * control_.historyInterval, control_.endTime);
    }

    /// Frames and the end are hit exactly; a history row is taken at the first step at or after its
    /// time, so that it never shortens a step.
    void advanceTo(double due, double stop)
    {
        std::int64_t steps = stepsUntil(clock_, due);
        if (options_.maxSteps >= 0) steps = std::min(steps, options_.maxSteps - clock_.steps);
        solver_.advance(std::min(stop, control_.endTime), steps, [this](const StepClock& now) {
            clock_ = now;
            progress();
        });
        clock_ = solver_.clock();
    }

    void sample()
    {
        const Sample row(solver_, model_);
        histories_.sample(solver_, row);
        health_.sample(clock_, row);
        while (control_.historyInterval > 0 && clock_.steps > 0
               && sampleTime(samples_) <= clock_.time + tiny()
               && sampleTime(samples_) < control_.endTime)
            ++samples_;
        judge(row.energies);
        edges_.checkIfDue(solver_, log_);
    }

    void judge(const Energies& energies)
    {
        energies_ = energies;
        const double error = std::abs(energies.balance);
        if (!std::isfinite(energies.total))
            fail(format("the energy is not a number at time {}", clock_.time), noNumberAdvice);
        // The first steps of a drive from rest: nothing to measure the error by yet.
        if (clock_.steps < Health::judgedSteps) return;
        if (error > control_.energyStop)
            fail(format("energy balance error {} % at time {} is beyond energyBalance.stop {} %",
                        toText(100 * energies.balance, 3), clock_.time, 100 * control_.energyStop));
        if (error > control_.energyWarning && !balanceWarned_)
            log_.warning(format("energy balance error {} % at time {} is beyond "
                                "energyBalance.warning {} %",
                                toText(100 * energies.balance, 3), clock_.time,
                                100 * control_.energyWarning));
        balanceWarned_ |= error > control_.energyWarning;
        checkInertia();
    }

    /// A slow run is quasi-static while its kinetic energy is small.
    void checkInertia()
    {
        if (!(control_.kineticShare > 0) || clock_.time < control_.quasiStaticAfter) return;
        const double share = energies_.kineticShare();
        if (share > control_.kineticShare && largestShare_ <= control_.kineticShare)
            log_.warning(
                format("kinetic energy is {} % of that of the elements at time {}, more than "
                       "quasiStatic.kineticShare: inertia has a part in the result; load more "
                       "slowly or scale the mass less",
                       toText(100 * share, 3), clock_.time));
        largestShare_ = std::max(largestShare_, share);
    }

    void check()
    {
        if (clock_.failed == 2)
            fail(format("step {} at time {}: timeStep.fixed {} is beyond the stable step {}",
                        clock_.steps, clock_.time, control_.fixedTimeStep, clock_.stableStep),
                 "give a smaller one, or leave it out: the step then follows from stability");
        if (clock_.failed) {
            const Inversion found = inversionOf(solver_, model_);
            fail(format("step {} at time {}: {}", clock_.steps, clock_.time, found.what),
                 found.advice);
        }
        if (const std::string why = endlessReason(clock_, control_, options_.maxSteps);
            !why.empty())
            fail(why, "see what limits the step, and whether endTime and the units are meant so");
    }

    [[noreturn]] void fail(const std::string& what,
                           const std::string& advice =
                               "try a smaller timeStep.safety or normalScale, and see the element "
                               "or pair named")
    {
        OutputFolder(root_).write("why.txt", what + "\n");
        // Beside the mesh as any frame, but of no time: the series ends with the last good state.
        saveState(failedFolder);
        finish();
        throw Error(ExitCode::numericalStop, what,
                    format("the last time folder holds the last good state, '{}' the one that "
                           "stopped the run; {}",
                           failedFolder, advice));
    }

    void saveState(const std::string& folder)
    {
        Frame frame = resultFrame(solver_, model_);
        frame.runId = record_.id();
        fpm::writeFrame(OutputFolder(root_), folder, frame, model_.mesh.points.size(),
                        model_.mesh.hexahedra.size());
    }

    void writeFrame()
    {
        const std::string name = timeName(clock_.time);
        saveState(name);
        series_.push_back(name);
        writeSeries(OutputFolder(root_), record_.id(), series_);
        log_.line(format("Time = {}", name));
        edges_.check(solver_, log_);
        lastFrame_ = clock_.time;
        ++frames_;
    }

    void progress()
    {
        const double wall = secondsSince(begin_);
        if (wall < nextLine_) return;
        nextLine_ = wall + 1;
        record_.tell(healthStatus(health_.sampledRows()));
        record_.renew(clock_.time, clock_.steps, log_);
        const double part = clock_.time / control_.endTime;
        const double rate = double(clock_.steps) * double(model_.mesh.hexahedra.size()) / wall;
        log_.progress(format("{} %  time {}  dt {}  energy error {} %  {} M el-steps/s  ETA {}",
                             toText(100 * part, 3), toText(clock_.time, 4), toText(clock_.step, 3),
                             toText(100 * energies_.balance, 2), toText(rate / 1e6, 3),
                             clockText(part > 0 ? wall * (1 - part) / part : 0)));
    }

    void finish()
    {
        energies_ = solver_.ledger().energies();
        reportEnergies(energies_, log_);
        if (control_.kineticShare > 0)
            log_.line(format("largest kinetic share after {}: {} %", control_.quasiStaticAfter,
                             toText(100 * largestShare_, 3)));
        reportRest(clock_, control_, log_);
        reportPairs(solver_, model_, log_);
        reportContact(solver_, model_, log_);
        reportErosion(solver_, model_, log_);
        if (clock_.steps > 0)
            log_.line(format("last time step {}, limited by {}", toText(clock_.step, 4),
                             stepLimit(solver_, model_)));
        verdicts_ = health_.rows(solver_, edges_);
        for (const std::string& line : healthLines(verdicts_)) log_.line(line);
        writeHealth(root_, record_.id(), verdicts_);
        record_.tell(healthStatus(verdicts_));
        reportPerformance(solver_, model_, root_, record_.id(), log_);
    }

    void end(RunState state) { record_.end(state, clock_.time, clock_.steps); }

    Solver& solver_;
    const Model& model_;
    const Control& control_;
    const std::filesystem::path root_; ///< of the case
    const RunOptions options_;
    Log& log_;
    RunRecord record_;
    Histories histories_;
    std::vector<std::string> series_; ///< time folders of the frames written
    StepClock clock_;
    Energies energies_;
    std::int64_t frames_ = 0, samples_ = 1;
    double nextLine_ = 1, lastFrame_ = 0, largestShare_ = 0;
    bool balanceWarned_ = false;
    Health health_;
    EdgeWatch edges_;
    HealthRows verdicts_; ///< at the end
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

} // namespace

void runTimeLoop(Solver& solver,
                 const Model& model,
                 const std::filesystem::path& caseRoot,
                 const RunOptions& options,
                 Log& log)
{
    TimeLoop(solver, model, caseRoot, options, log).run();
}

} // namespace fpm
