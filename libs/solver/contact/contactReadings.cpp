#include "kernels/contact/broad/Search.h"
#include "kernels/contact/distribute/ContactStatus.h"
#include "kernels/contact/narrow/NodeGap.h"
#include "solver/contact/ContactSolver.h"

#include <cmath>

namespace fpm {

void ContactSolver::addUp()
{
    sums_.assign(setUp_.contact.passes.size(), {});
    for (std::size_t pass = 0; pass < sums_.size(); ++pass) launches_.sums(pass);
    backend_.synchronize();
    for (std::size_t pass = 0; pass < sums_.size(); ++pass) {
        const std::vector<double> parts = fields_.contact.passes[pass]->sums.toHost();
        for (std::size_t k = 0; k < parts.size(); ++k) sums_[pass][k % passSums] += parts[k];
    }
}

std::array<double, passSums> ContactSolver::sumsOf(std::size_t pass)
{
    // Surfaces are renewed between two steps, before anybody reads.
    const std::int64_t steps = fields_.clock.clock.toHost()[0].steps;
    if (steps != sumsStep_ || steps == 0) addUp();
    sumsStep_ = steps;
    return sums_[pass];
}

PairForce ContactSolver::force(std::size_t number)
{
    backend_.synchronize();
    PairForce out;
    for (std::size_t pass = 0; pass < setUp_.contact.passes.size(); ++pass) {
        if (setUp_.contact.passes[pass].pair != number) continue;
        const std::array<double, passSums> sums = sumsOf(pass);
        const double sign = setUp_.contact.passes[pass].reversed ? -1 : 1;
        for (std::size_t c = 0; c < 3; ++c) out.force[c] += sign * sums[sumForce + c];
        out.active += Index(sums[sumTouching]);
        out.springEnergy += sums[sumSpringEnergy];
        out.friction += sums[sumDissipated];
        out.damping += sums[sumDamped];
        const std::vector<std::int64_t> counts = fields_.contact.passes[pass]->counts.toHost();
        out.released += counts[countReleased];
        out.overEdge += counts[countOverEdge];
        out.inside += counts[countInside];
        out.mistaken += counts[countMistaken];
        out.crowded += counts[countCrowded];
        out.late += counts[countLate];
    }
    return out;
}

/// [block][statusValues]
std::vector<double> ContactSolver::statusOf(std::size_t pass)
{
    PassFields& fields = *fields_.contact.passes[pass];
    const std::size_t blocks = std::size_t(NodeBlocks::blocks(Index(fields.contactor.size())));
    if (fields.status.size() != blocks * statusValues) fields.status.resize(blocks * statusValues);
    launches_.status(pass);
    backend_.synchronize();
    return fields.status.toHost();
}

PairStatus ContactSolver::status(std::size_t number)
{
    backend_.synchronize();
    PairStatus out;
    double weight = 0;
    for (std::size_t pass = 0; pass < setUp_.contact.passes.size(); ++pass) {
        if (setUp_.contact.passes[pass].pair != number) continue;
        const double sign = setUp_.contact.passes[pass].reversed ? -1 : 1;
        const std::vector<double> blocks = statusOf(pass);
        for (const double* of = blocks.data(); of < blocks.data() + blocks.size();
             of += statusValues) {
            out.active += Index(of[statusCount]);
            weight += of[statusWeight];
            out.meanDepth += of[statusDepth];
            out.normal += of[statusNormal];
            out.speed += of[statusSpeed];
            for (std::size_t c = 0; c < 3; ++c) {
                out.friction[c] += sign * of[statusFriction + c];
                out.slip[c] += sign * of[statusSlip + c];
            }
            if (!(of[statusDeepest] > out.maxDepth)) continue;
            out.maxDepth = of[statusDeepest];
            out.thickness = of[statusThickness];
            out.deepest = setUp_.contact.passes[pass].contactor[std::size_t(of[statusContactor])];
        }
    }
    const double share = weight > 0 ? 1 / weight : 0;
    out.meanDepth *= share;
    out.speed *= share;
    for (double& v : out.slip) v *= share;
    return out;
}

/// [contactor]
std::vector<double> ContactSolver::gapsOf(std::size_t pass)
{
    PassFields& fields = *fields_.contact.passes[pass];
    fields.gap.resize(fields.contactor.size());
    launches_.gaps(pass);
    backend_.synchronize();
    const std::vector<double> values = fields.gap.toHost();
    fields.gap.resize(0);
    return values;
}

std::vector<double> ContactSolver::gaps()
{
    backend_.synchronize();
    std::vector<double> least(std::size_t(setUp_.nodes.count), noGap);
    for (std::size_t pass = 0; pass < setUp_.contact.passes.size(); ++pass) {
        if (setUp_.contact.passes[pass].ofEdges) continue; // gaps are of nodes
        const std::vector<double> gaps = gapsOf(pass);
        const std::vector<Index> nodes = fields_.contact.passes[pass]->contactor.toHost();
        for (std::size_t i = 0; i < gaps.size(); ++i) {
            double& of = least[std::size_t(nodes[i])];
            if (gaps[i] < of || std::isnan(of)) of = gaps[i];
        }
    }
    return least;
}

ContactBound ContactSolver::bound() const
{
    backend_.synchronize();
    ContactBound out;
    const ContactSetUp& contact = setUp_.contact;
    const std::vector<std::int64_t> sum = fields_.contact.sum.toHost();
    double most = 0;
    for (std::size_t i = 0; i < contact.nodes.size(); ++i) {
        const std::size_t node = std::size_t(contact.nodes[i]);
        if (setUp_.nodes.fixed[node] & imposedNode) continue;
        const double square =
            contact.scale.toStiffness(sum[4 * i + 3]) * (1 / setUp_.nodes.mass[node]);
        if (!(square > most)) continue;
        most = square;
        out = {contact.nodes[i], -1, std::sqrt(square)};
    }
    const std::vector<double> ofBodies = fields_.bodies.contactBound.toHost();
    for (std::size_t body = 0; body < ofBodies.size(); ++body) {
        if (!(ofBodies[body] > most)) continue;
        most = ofBodies[body];
        out = {-1, setUp_.bodies.part[body], std::sqrt(most)};
    }
    return out;
}

} // namespace fpm
