#include "run/RunReport.h"

#include "base/Format.h"

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

} // namespace fpm
