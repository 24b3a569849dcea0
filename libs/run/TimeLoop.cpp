#include "run/TimeLoop.h"

#include "base/Error.h"
#include "base/Format.h"
#include "base/Machine.h"
#include "case/LaterResults.h"
#include "case/RunRecord.h"
#include "io/FileError.h"
#include "io/OutputFolder.h"
#include "run/Checkpoints.h"
#include "run/ContactWatch.h"
#include "run/FrameWriter.h"
#include "run/Health.h"
#include "run/HealthTable.h"
#include "run/Histories.h"
#include "run/Inversion.h"
#include "run/Performance.h"
#include "run/RunForecast.h"
#include "run/RunJudge.h"
#include "run/RunReport.h"
#include "run/Schedule.h"
#include "run/SignalWatch.h"

#include <algorithm>
#include <optional>

namespace fpm {

namespace {

double secondsSince(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The run's own counters, as a checkpoint that it goes on from stored them; empty without one.
Archive storedRecord(const RunOptions& options)
{
    return options.from ? Archive(options.from->record) : Archive();
}

/// A new one; or one that goes on, what was made after its checkpoint being set aside first.
RunRecord recordOf(const OutputFolder& output,
                   const RunOptions& options,
                   const std::string& previousRun,
                   Log& log)
{
    if (!options.from) return RunRecord(output, previousRun, log);
    setLaterResultsAside(output, options.from->runId, options.from->time, log);
    return RunRecord(output, options.from->runId, options.from->wallSeconds);
}

std::vector<HistoryMark> storedHistories(Archive& record)
{
    std::vector<HistoryMark> marks;
    if (record.reads()) keep(record, marks);
    return marks;
}

/// One run, or the part of it after a checkpoint: what is due when, and what goes where.
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
          output_(root_, fullDiskPolicy()),
          stored_(storedRecord(options)),
          record_(recordOf(output_, options, control_.previousRun, log)),
          frames_(solver, model, output_, record_.id()),
          health_(model, solver),
          edges_(model),
          judge_(control_),
          schedule_(control_, options.maxSteps),
          checkpoints_(output_),
          watch_(options.control)
    {
    }

    void run()
    {
        try {
            loop();
            end(RunState::finished);
        } catch (const Error& error) {
            endAfter(error);
            throw withWayOn(error, checkpointStep_);
        }
        if (options_.strict && findings(verdicts_) > 0)
            throw Error(ExitCode::unhealthy, healthVerdict(verdicts_) + " (-strict)",
                        "the table of health above says what, where and what helps");
        log_.line(healthVerdict(verdicts_));
    }

private:
    FullDiskPolicy fullDiskPolicy()
    {
        return {options_.waitsForRoom, [this] { return !signals_.end().empty(); },
                [this](const std::string& what) { log_.warning(what); }};
    }

    void loop()
    {
        histories_.emplace(output_, model_, record_.id(), storedHistories(stored_), log_);
        options_.from ? goOn() : begin();
        reportStart(solver_, model_, root_, options_.maxSteps, log_);
        std::string why;
        while (why.empty() && !schedule_.atEnd(clock_)) {
            advance();
            check();
            const bool frame = schedule_.frameIsDue(clock_);
            if (schedule_.rowIsDue(clock_))
                sample();
            else if (frame) // none holds a state that is lost
                failIf(judge_.judge(energies_ = solver_.ledger().energies(), clock_, log_));
            if (frame) writeFrame();
            if (watch_.follow(control_, log_)) schedule_.startAt(clock_, wall());
            if (!schedule_.atEnd(clock_)) why = reasonToStop(frame);
            answerRequests();
            if (!why.empty() || schedule_.atEnd(clock_)
                || schedule_.checkpointIsDue(clock_, wall()))
                writeCheckpoint();
            progress();
        }
        // Between rows, by maxSteps or a stop: these rows and frames are no part of what goes on
        // from the checkpoint.
        if (clock_.steps > lastRow_) sample();
        if (!why.empty() && control_.stopAt != StopAt::noWriteNow)
            frames_.write(control_.purgeWrite, log_);
        finish();
        if (!why.empty())
            throw Error(ExitCode::stopped, format("{} at time {}", why, clock_.time),
                        "'fpmExplicit -continue' goes on from here");
    }

    void begin()
    {
        clock_ = solver_.clock();
        reportMassScaling(solver_, log_);
        sample();
        reportOverlaps(solver_, model_, log_);
        writeFrame();
        schedule_.startAt(clock_, wall());
        schedule_.checkpointIsDone(wall());
    }

    void goOn()
    {
        clock_ = solver_.clock();
        requireMoment(*options_.from, clock_.time, clock_.steps);
        keep(stored_);
        frames_.resume();
        schedule_.startAt(clock_, wall());
        schedule_.checkpointIsDone(wall());
        lastRow_ = checkpointStep_ = clock_.steps;
        log_.line(format("going on from the checkpoint at time {}, step {}", toText(clock_.time, 9),
                         clock_.steps));
    }

    /// What the run counts beside its solver.
    void keep(Archive& archive)
    {
        judge_.keep(archive);
        health_.keep(archive);
        edges_.keep(archive);
        EarlierParts parts = archive.reads() ? EarlierParts{} : earlier_.with(solver_.times());
        parts.keep(archive);
        if (archive.reads()) earlier_ = parts;
        if (archive.reads() && !archive.atEnd())
            throw Error(ExitCode::checkpoint, "the record of the run is longer than it should be");
    }

    /// To what is due next, at most for a second or so.
    void advance()
    {
        constexpr double slice = 1;
        const auto begin = std::chrono::steady_clock::now();
        Pause pause;
        pause.at = schedule_.pause();
        pause.goesOn = [&](const StepClock& now) {
            clock_ = now;
            progress();
            return secondsSince(begin) < slice && !signals_.asks();
        };
        solver_.advance(schedule_.stop(), schedule_.steps(clock_), pause);
        clock_ = solver_.clock();
        longestSlice_ = std::max(longestSlice_, secondsSince(begin));
    }

    void sample()
    {
        const Sample row(solver_, model_);
        histories_->sample(solver_, row);
        health_.sample(clock_, row);
        schedule_.rowIsDone(clock_);
        lastRow_ = clock_.steps;
        energies_ = row.energies;
        failIf(judge_.judge(energies_, clock_, log_));
        edges_.checkIfDue(solver_, log_);
    }

    void writeFrame()
    {
        frames_.write(control_.purgeWrite, log_);
        edges_.check(solver_, log_);
        schedule_.frameIsDone(clock_, wall());
    }

    /// Why the run stops here, before its end; empty where it goes on.
    std::string reasonToStop(bool atFrame)
    {
        if (const std::string signal = signals_.end(); !signal.empty())
            return "stopped by " + signal;
        if (control_.maxWallTime > 0
            && wall() + 2 * checkpoints_.longest() + longestSlice_ >= control_.maxWallTime)
            return format("stopped by maxWallTime {} s", control_.maxWallTime);
        if (control_.stopAt == StopAt::writeNow || control_.stopAt == StopAt::noWriteNow
            || (control_.stopAt == StopAt::nextWrite && atFrame))
            return "stopped by stopAt";
        return "";
    }

    /// Frames beside those that are due leave no trace in the run.
    void answerRequests()
    {
        const bool byWall = schedule_.frameIsDueByWall(wall());
        if (byWall || signals_.takeFrame()) {
            requireSound();
            frames_.write(control_.purgeWrite, log_);
        }
        if (byWall) schedule_.frameIsDone(clock_, wall());
        if (signals_.takeCheckpoint()) writeCheckpoint();
    }

    void requireSound() { failIf(judge_.lost(solver_.ledger().peek(), clock_)); }

    void writeCheckpoint()
    {
        if (control_.checkpoint.keep == 0 || checkpointStep_ == clock_.steps) return;
        requireSound();
        Checkpoint out;
        out.runId = record_.id();
        out.time = clock_.time;
        out.steps = clock_.steps;
        out.lastStep = clock_.step;
        out.wallSeconds = record_.wallSeconds();
        out.cpuSeconds = (options_.from ? options_.from->cpuSeconds : 0) + processorSeconds();
        out.settled = clock_.settled != 0;
        out.inputs = options_.inputs;
        out.state = solver_.state();
        Archive archive;
        std::vector<HistoryMark> marks = histories_->marks();
        fpm::keep(archive, marks);
        keep(archive);
        out.record = archive.bytes();
        checkpoints_.write(out, control_.checkpoint.keep);
        checkpointStep_ = clock_.steps;
        schedule_.checkpointIsDone(wall());
        log_.line(format("checkpoint at time {}, step {}", toText(clock_.time, 9), clock_.steps));
    }

    void check()
    {
        if (clock_.failed == 2)
            fail({format("step {} at time {}: timeStep.fixed {} is beyond the stable step {}",
                         clock_.steps, clock_.time, control_.fixedTimeStep, clock_.stableStep),
                  "give a smaller one, or leave it out: the step then follows from stability"});
        if (clock_.failed) {
            const Inversion found = inversionOf(solver_, model_);
            fail({format("step {} at time {}: {}", clock_.steps, clock_.time, found.what),
                  found.advice});
        }
        if (const std::string why = endlessReason(clock_, control_, options_.maxSteps);
            !why.empty())
            fail({why, "see what limits the step, and whether endTime and the units are meant so"});
    }

    void failIf(const std::optional<RunFailure>& failure)
    {
        if (failure) fail(*failure);
    }

    [[noreturn]] void fail(const RunFailure& failure)
    {
        output_.write("why.txt", failure.what + "\n");
        frames_.writeFailed();
        finish();
        throw Error(ExitCode::numericalStop, failure.what,
                    format("the last time folder holds the last good state, '{}' the one that "
                           "stopped the run; {}",
                           FrameWriter::failedFolder, failure.advice));
    }

    void progress()
    {
        const double now = secondsSince(begin_);
        if (now < nextLine_) return;
        nextLine_ = now + 1;
        record_.tell(healthStatus(health_.sampledRows()));
        record_.renew(clock_.time, clock_.steps, log_);
        log_.progress(progressText(clock_, control_, options_.from, energies_.balance,
                                   model_.mesh.hexahedra.size(), now));
    }

    void finish()
    {
        energies_ = solver_.ledger().energies();
        reportEnergies(energies_, log_);
        if (const std::string line = judge_.inertia(); !line.empty()) log_.line(line);
        reportRest(clock_, control_, log_);
        reportPairs(solver_, model_, log_);
        reportContact(solver_, model_, log_);
        reportErosion(solver_, model_, log_);
        if (clock_.steps > 0)
            log_.line(format("last time step {}, limited by {}", toText(clock_.step, 4),
                             stepLimit(solver_, model_)));
        verdicts_ = health_.rows(solver_, edges_);
        for (const std::string& line : healthLines(verdicts_)) log_.line(line);
        writeHealth(output_, record_.id(), verdicts_);
        record_.tell(healthStatus(verdicts_));
        reportPerformance(solver_, model_, earlier_, output_, record_.id(), log_);
    }

    void end(RunState state) { record_.end(state, clock_.time, clock_.steps); }
    void endAfter(const Error& error)
    {
        const auto* file = dynamic_cast<const FileError*>(&error);
        try {
            record_.end(error.code() == ExitCode::stopped ? RunState::stopped : RunState::failed,
                        clock_.time, clock_.steps,
                        file ? file->file().lexically_relative(root_).string() : "");
        } catch (const Error& second) { // the first one says more
            log_.warning(std::string("status is not up to date: ") + second.what());
        }
    }
    double wall() const { return secondsSince(options_.begin); }

    Solver& solver_;
    const Model& model_;
    Control control_;                  ///< as it is now
    const std::filesystem::path root_; ///< of the case
    const RunOptions& options_;
    Log& log_;
    SignalWatch signals_;
    const OutputFolder output_;
    Archive stored_;
    RunRecord record_;
    FrameWriter frames_;
    std::optional<Histories> histories_; ///< once the loop runs: `status` says if they fail
    Health health_;
    EdgeWatch edges_;
    RunJudge judge_;
    EarlierParts earlier_;
    Schedule schedule_;
    Checkpoints checkpoints_;
    ControlWatch watch_;
    StepClock clock_;
    Energies energies_;
    std::int64_t lastRow_ = -1, checkpointStep_ = -1; ///< steps made at the last of them
    double nextLine_ = 1, longestSlice_ = 0;
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
