#include "solver/contact/ContactRenewal.h"

#include "kernels/contact/distribute/PassSums.h"

#include <algorithm>

namespace fpm {

namespace {

/// What `old` held in the contactors that `from` does not take over.
double leftBehind(const Field<double>& old, const std::vector<Index>& from, std::size_t oldCount)
{
    const std::vector<double> values = old.toHost();
    double sum = 0;
    for (std::size_t k = 0; k < std::min(oldCount, values.size()); ++k) sum += values[k];
    for (const Index k : from)
        if (k >= 0 && !values.empty()) sum -= values[std::size_t(k)];
    return sum;
}

Index renumbered(Index face, const std::vector<Index>& faces)
{
    return face >= 0 ? faces[std::size_t(face)] : face;
}

} // namespace

ContactRenewal::ContactRenewal(const Model& model, SolverSetUp& setUp, SolverFields& fields)
    : setUp_(setUp),
      fields_(fields),
      erosion_(model)
{
}

bool ContactRenewal::follow(const std::vector<bool>& deleted)
{
    const std::vector<ContactPassSetup> passes = setUp_.contact.passes;
    const std::vector<Index> numbers = setUp_.contact.numberOf;
    const ForceScale scale = setUp_.contact.scale;
    if (!erosion_.renewContact(setUp_, deleted)) return false;
    for (std::size_t pass = 0; pass < passes.size(); ++pass)
        renewPass(pass, compared(passes[pass], setUp_.contact.passes[pass]), scale);
    renewNodes(numbers, scale);
    fields_.contact.bindSurfaces(setUp_.contact);
    renewMovers();
    return true;
}

bool ContactRenewal::rebuild(const std::vector<bool>& deleted)
{
    if (!erosion_.renewContact(setUp_, deleted)) return false;
    ContactFields& contact = fields_.contact;
    for (std::size_t pass = 0; pass < contact.passes.size(); ++pass)
        contact.passes[pass] = std::make_unique<PassFields>(setUp_.contact.passes[pass],
                                                            contact.memory(), contact.numbers());
    contact.renewNodes(setUp_.contact);
    contact.bindSurfaces(setUp_.contact);
    renewMovers();
    return true;
}

/// Nodes that have come into contact are moved by the pass over the nodes.
void ContactRenewal::renewMovers()
{
    if (!setUp_.nodes.movedByPatches) return;
    shareNodes(setUp_);
    fields_.nodes.renewListed(setUp_.nodes);
    fields_.elements.patches.fromHost(setUp_.elements.patches);
}

void ContactRenewal::renewPass(std::size_t number,
                               const PassRenewal& from,
                               const ForceScale& before)
{
    const ContactPassSetup& setUp = setUp_.contact.passes[number];
    ContactFields& contact = fields_.contact;
    const PassFields& old = *contact.passes[number];
    auto renewed = std::make_unique<PassFields>(setUp, contact.memory(), contact.numbers());
    const std::size_t oldCount = old.contactor.size(), count = from.contactor.size();
    const std::vector<Index> oldFace = old.face.toHost();
    std::vector<Index> face(count, noFace), touching = from.contactor;
    for (std::size_t i = 0; i < count; ++i) {
        if (from.contactor[i] < 0) continue;
        face[i] = renumbered(oldFace[std::size_t(from.contactor[i])], from.face);
        if (setUp.surface < 0 && face[i] < 0)
            touching[i] = -1; // its face is gone, and force and friction
    }
    for (std::size_t k = 0; k < renewed->fields().size(); ++k) {
        const Renewal renewal = old.fields()[k]->info().renewal;
        if (renewal == Renewal::reset) continue;
        renewed->fields()[k]->take(*old.fields()[k],
                                   renewal == Renewal::kept ? from.contactor : touching, oldCount);
    }
    renewed->face.fromHost(face);
    std::vector<Index> frames = renewed->frictionFace.toHost();
    for (Index& frame : frames) frame = renumbered(frame, from.face);
    renewed->frictionFace.fromHost(frames);
    renewForce(*renewed, old, touching, before);
    renewed->counts.fromHost(old.counts.toHost());
    bookLost(old, from, touching);
    contact.passes[number] = std::move(renewed);
}

/// Sum of the forces on the contactors that stay, in the scale of now: what acts on them until the
/// next step.
void ContactRenewal::renewForce(PassFields& renewed,
                                const PassFields& old,
                                const std::vector<Index>& touching,
                                const ForceScale& before) const
{
    if (renewed.force.size() == 0) return;
    const std::vector<std::int64_t> forces = old.contactorForce.toHost();
    std::vector<std::int64_t> sum(3);
    for (const Index k : touching)
        for (std::size_t c = 0; k >= 0 && c < 3; ++c) sum[c] += forces[3 * std::size_t(k) + c];
    for (std::int64_t& force : sum) force = setUp_.contact.scale.force(before.toForce(force));
    sum.resize(renewed.force.size());
    renewed.force.fromHost(sum);
}

void ContactRenewal::bookLost(const PassFields& old,
                              const PassRenewal& from,
                              const std::vector<Index>& touching)
{
    const std::size_t oldCount = old.contactor.size();
    LedgerFields& lost = fields_.ledger;
    lost.lostSpring += leftBehind(old.springEnergy, touching, oldCount);
    lost.lostFriction += leftBehind(old.dissipated, from.contactor, oldCount);
    lost.lostDamping += leftBehind(old.damped, from.contactor, oldCount);
    lost.lostWork += leftBehind(old.surfaceWork, from.contactor, oldCount)
                     + leftBehind(old.injected, from.contactor, oldCount);
}

/// The forces of this time stay for the step that follows; `numbers`: contact numbers of all nodes
/// before.
void ContactRenewal::renewNodes(const std::vector<Index>& numbers, const ForceScale& before)
{
    const std::vector<std::int64_t> old = fields_.contact.sum.toHost();
    fields_.contact.renewNodes(setUp_.contact);
    const std::size_t count = setUp_.contact.nodes.size();
    std::vector<std::int64_t> sum(4 * count);
    std::vector<double> bound(fields_.contact.blocks());
    const std::vector<double> inverseMass = fields_.nodes.inverseMass.toDoubles();
    const ForceScale& scale = setUp_.contact.scale;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t node = std::size_t(setUp_.contact.nodes[i]);
        const Index number = numbers[node];
        if (number < 0) continue;
        const std::int64_t* from = &old[4 * std::size_t(number)];
        for (std::size_t c = 0; c < 3; ++c) sum[4 * i + c] = scale.force(before.toForce(from[c]));
        const double stiffness = before.toStiffness(from[3]);
        sum[4 * i + 3] = scale.spring(stiffness);
        double& most = bound[i / std::size_t(contactBlock)];
        if (!(setUp_.nodes.fixed[node] & imposedNode))
            most = std::max(most, stiffness * inverseMass[node]);
    }
    fields_.contact.sum.fromHost(sum);
    fields_.contact.bound.fromHost(bound);
}

} // namespace fpm
