#include "run/RunReport.h"

#include "base/Format.h"

#include <algorithm>
#include <cmath>

namespace fpm {

void reportEnergies(const Energies& e, Log& log)
{
    log.line(format("energies at {}: kinetic {} internal {} (elastic {}, plastic {}) hourglass {} "
                    "bulk viscosity {}",
                    e.time, e.kinetic, e.internal, e.internal - e.plastic, e.plastic, e.hourglass,
                    e.bulkViscosity));
    log.line(format("  contact {} friction {} contact damping {} damping {} external {}  "
                    "balance error {} %",
                    e.contact, e.friction, e.contactDamping, e.damping, e.external,
                    toText(100 * e.balance, 3)));
}

void reportRest(const StepClock& clock, const Control& control, Log& log)
{
    if (!(control.relaxationTolerance > 0)) return;
    const std::string where = format("force out of balance {}, square root of the kinetic share {}",
                                     toText(clock.residual, 3), toText(clock.unrest, 3));
    if (clock.settled)
        log.line(format("dynamic relaxation: at rest at time {} after {} steps; ", clock.time,
                        clock.steps)
                 + where);
    else
        log.warning("dynamic relaxation has not come to rest: " + where);
}

void reportErosion(Solver& solver, const Model& model, Log& log)
{
    if (!solver.elements().setUp().erodes) return;
    const ElementValues values = solver.elements().values();
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        const MeshPart& part = model.mesh.parts[p];
        Index deleted = 0;
        double energy = 0;
        for (Index e = part.firstElement; e < part.firstElement + part.elementCount; ++e) {
            deleted += values.deleted[std::size_t(e)];
            energy += values.eroded[std::size_t(e)];
        }
        if (deleted > 0)
            log.line(format("part {}: {} elements deleted, eroded {} (elastic energy they held, "
                            "part of internal)",
                            part.name, deleted, energy));
    }
}

namespace {

std::string clockText(double seconds)
{
    const long s = std::lround(std::clamp(seconds, 0.0, 3.6e8));
    const auto two = [](long n) { return std::string(n < 10 ? "0" : "") + std::to_string(n); };
    return two(s / 3600) + ":" + two(s / 60 % 60) + ":" + two(s % 60);
}

} // namespace

std::string progressText(const StepClock& clock,
                         const Control& control,
                         const CheckpointLabel* from,
                         double balance,
                         std::size_t elements,
                         double seconds)
{
    const double start = from ? from->time : 0,
                 part = (clock.time - start) / (control.endTime - start),
                 rate = double(clock.steps - (from ? from->steps : 0)) * double(elements) / seconds;
    return format("{} %  time {}  dt {}  energy error {} %  {} M el-steps/s  ETA {}",
                  toText(100 * clock.time / control.endTime, 3), toText(clock.time, 4),
                  toText(clock.step, 3), toText(100 * balance, 2), toText(rate / 1e6, 3),
                  clockText(part > 0 ? seconds * (1 - part) / part : 0));
}

Error withWayOn(const Error& error, std::int64_t checkpointStep)
{
    const bool isOfMachine = error.code() == ExitCode::fileIo
                             || error.code() == ExitCode::deviceLost
                             || error.code() == ExitCode::memory;
    if (!isOfMachine || (checkpointStep < 0 && error.code() != ExitCode::deviceLost)) return error;
    const std::string next =
        checkpointStep < 0
            ? "there is no checkpoint yet: start the run again"
            : format("'fpmExplicit -continue' goes on from the checkpoint at step {}",
                     checkpointStep);
    return Error(error.code(), error.what(),
                 error.advice() + (error.advice().empty() ? "" : "\n  = ") + next);
}

} // namespace fpm
