#include "solver/Health.h"

#include "base/Format.h"

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
    contact_.sample(row.energies.time, row.pairs);
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
    for (const EdgeFinding& edge : edges.findings())
        rows.push_back({"edges that pass through the other surface", double(edge.count), 0,
                        format("{}, first at ({} {} {})", edge.pair, edge.place[0], edge.place[1],
                               edge.place[2]),
                        edge.time, true,
                        "node-to-face contact does not see edges between their nodes: round the "
                        "edges, or make elements along them smaller than the other body"});
    motion_.addRows(solver, rows);
    return rows;
}

} // namespace fpm
