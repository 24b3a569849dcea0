#include "run/ContactWatch.h"

#include "base/Format.h"

namespace fpm {

void reportOverlaps(const Solver& solver, const Model& model, Log& log)
{
    for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair) {
        const PairOverlap overlap = solver.contact().initialOverlap(pair);
        if (overlap.count == 0) continue;
        const Point& p = model.mesh.points[std::size_t(overlap.node)];
        log.line(format("pair {}: {} contactors start inside the target, deepest {} at ({} {} {})",
                        model.contactPairs[pair].name, overlap.count, overlap.deepest, p[0], p[1],
                        p[2]));
    }
}

void reportContact(Solver& solver, const Model& model, Log& log)
{
    for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair) {
        const PairForce force = solver.contact().force(pair);
        const std::string& name = model.contactPairs[pair].name;
        if (force.released > 0)
            log.warning(format("{} contactor nodes of pair {} went deeper than the target is "
                               "thick and were released",
                               force.released, name));
        if (force.crowded > 0)
            log.warning(
                format("pair {}: {} times a node had more than three bodies in reach, or an "
                       "edge more than eight edges; it was held by the nearest",
                       name, force.crowded));
        if (force.late > 0)
            log.warning(format("pair {}: {} times blocks of contactors moved further than the skin "
                               "of their lists before these were rebuilt; set searchInterval 1 "
                               "or a smaller timeStep.maximum",
                               name, force.late));
        if (force.overEdge > 0)
            log.line(format("pair {}: {} times a contactor left the target over a free edge while "
                            "in contact",
                            name, force.overEdge));
        if (force.inside > 0)
            log.line(format("pair {}: {} times a contactor was first found inside the target; that "
                            "depth makes no force",
                            name, force.inside));
        if (force.mistaken > 0)
            log.line(format("pair {}: {} times a search found a nearer face than the one a "
                            "contactor in contact had followed",
                            name, force.mistaken));
    }
}

} // namespace fpm
