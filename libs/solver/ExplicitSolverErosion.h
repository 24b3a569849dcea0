#pragma once

// Part of ExplicitSolver.h: contact after elements were deleted. Called by the host between steps,
// and only then: a step itself allocates nothing.

namespace fpm {

/// Renews the contact surfaces and keeps what is known of the contactors that stay: face, friction,
/// forces of this time. What springs of vanished faces held is booked as lost.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::renewContact()
{
    const std::vector<PairData> pairs = data_.pairs;
    const std::vector<Index> numbers = data_.contactNumber;
    const ForceScale scale = data_.contactScale;
    if (!erosion_->renewContact(data_, elementValues().deleted)) return;
    for (std::size_t pair = 0; pair < pairs.size(); ++pair)
        renewPair(pair, compared(pairs[pair], data_.pairs[pair]));
    renewContactNodes(numbers, scale);
    searchContact();
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::renewPair(std::size_t number, const PairRenewal& from)
{
    PairState<Precision, Executor>& old = state_.pairs[number];
    const std::vector<Index> oldFace = old.face.toHost();
    const std::vector<Work> oldXi = old.xi.toHost(), oldEta = old.eta.toHost(),
                            oldFriction = old.friction.toHost();
    const std::vector<double> oldForce = old.force.toHost(), oldSpring = old.spring.toHost(),
                              oldDissipated = old.dissipated.toHost();
    const std::size_t oldCount = oldFace.size(), count = from.contactor.size();
    std::vector<Index> face(count, noFace);
    std::vector<Work> xi(count), eta(count), friction(oldFriction.empty() ? 0 : 3 * count);
    std::vector<double> force(3 * count), spring(count), dissipated(count);
    for (const double energy : oldSpring) lostSpring_ += energy;
    for (const double energy : oldDissipated) lostFriction_ += energy;
    for (std::size_t i = 0; i < count; ++i) {
        if (from.contactor[i] < 0) continue;
        const std::size_t k = std::size_t(from.contactor[i]);
        dissipated[i] = oldDissipated[k];
        lostFriction_ -= dissipated[i];
        const Index tracked = oldFace[k];
        face[i] = tracked >= 0 ? from.face[std::size_t(tracked)] : tracked;
        if (face[i] < 0) continue; // its face is gone, and with it force and friction
        xi[i] = oldXi[k];
        eta[i] = oldEta[k];
        spring[i] = oldSpring[k];
        lostSpring_ -= spring[i];
        for (std::size_t c = 0; c < 3; ++c) force[c * count + i] = oldForce[c * oldCount + k];
        if (!friction.empty())
            for (std::size_t c = 0; c < 3; ++c)
                friction[c * count + i] = oldFriction[c * oldCount + k];
    }
    PairState<Precision, Executor> renewed(data_.pairs[number]);
    renewed.face.fromHost(face);
    renewed.xi.fromHost(xi);
    renewed.eta.fromHost(eta);
    renewed.friction.fromHost(friction);
    renewed.force.fromHost(force);
    renewed.spring.fromHost(spring);
    renewed.dissipated.fromHost(dissipated);
    renewed.released.fromHost(old.released.toHost());
    old = std::move(renewed);
}

/// The forces of this time stay on the nodes, for the step that follows; `numbers`: contact numbers
/// of all nodes before.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::renewContactNodes(const std::vector<Index>& numbers,
                                                            const ForceScale& before)
{
    using Motion = typename Precision::Motion;
    const std::size_t count = data_.contactNodes.size();
    const std::vector<std::int64_t> old = state_.contactSum.toHost();
    const std::vector<Motion> inverseMass = converted<Motion>(data_.contactInverseMass);
    std::vector<std::int64_t> sum(4 * count);
    std::vector<double> limit(state_.blocks(Index(count)));
    const ForceScale& scale = data_.contactScale;
    for (std::size_t i = 0; i < count; ++i) {
        const Index number = numbers[std::size_t(data_.contactNodes[i])];
        if (number < 0) continue;
        const std::int64_t* from = &old[4 * std::size_t(number)];
        for (std::size_t c = 0; c < 3; ++c) sum[4 * i + c] = scale.force(before.toForce(from[c]));
        const double stiffness = before.toStiffness(from[3]);
        sum[4 * i + 3] = scale.spring(stiffness);
        double& most = limit[i / ContactLimit<Motion>::block];
        most = std::max(most, stiffness * double(inverseMass[i]));
    }
    using Numbers = Array<Index, Executor>;
    state_.contactNodes = Numbers(data_.contactNodes);
    state_.contactNumber = Numbers(data_.contactNumber);
    state_.contactInverseMass = Array<Motion, Executor>(inverseMass);
    state_.contactSum = Array<std::int64_t, Executor>(sum);
    state_.contactLimit = Array<double, Executor>(limit);
    state_.contactTravel = Array<double, Executor>(2 * limit.size());
    state_.searchPosition = Array<double, Executor>(3 * count);
}

} // namespace fpm
