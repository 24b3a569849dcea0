#include "run/Health.h"

#include "base/Format.h"
#include "run/HealthLimits.h"

namespace fpm {

Health::Health(const Model& model, const Solver& solver)
    : energies_(model),
      contact_(model, solver),
      motion_(model)
{
}

void Health::sample(const StepClock& clock, const Sample& row)
{
    energies_.sample(row.energies, clock.steps >= judgedSteps);
    contact_.sample(row);
}

void Health::keep(Archive& archive)
{
    energies_.keep(archive);
    contact_.keep(archive);
}

HealthRows Health::sampledRows() const
{
    HealthRows rows;
    energies_.addRows(rows);
    contact_.addRows(rows);
    return rows;
}

HealthRows Health::rows(Solver& solver, const EdgeWatch& edges) const
{
    HealthRows rows = sampledRows();
    contact_.addCounts(solver, rows);
    for (const EdgeFinding& edge : edges.findings()) {
        const Point& at = edge.crossings.place;
        rows.push_back({"edges that pass through the other surface / width of a face",
                        edge.crossings.depth, HealthLimits::depthOfEdge,
                        format("{}, {} edges, deepest at ({} {} {})", edge.pair,
                               edge.crossings.count, at[0], at[1], at[2]),
                        edge.time, edge.isDeep(), edge.advice()});
    }
    motion_.addRows(solver, rows);
    return rows;
}

} // namespace fpm
