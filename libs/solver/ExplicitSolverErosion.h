#pragma once

// Part of ExplicitSolver.h: pressures and contact after elements were deleted. Called by the host
// between steps, and only then: a step itself allocates nothing.

namespace fpm {

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::followDeletions()
{
    const bool presses = !data_.pressureFaceCondition.empty();
    if (!presses && !erosion_) return;
    const std::vector<bool> deleted = elementValues().deleted;
    if (presses) endPressures(deleted);
    if (erosion_) renewContact(deleted);
}

/// Sides of deleted elements bear no pressure from the next step on.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::endPressures(const std::vector<bool>& deleted)
{
    for (std::size_t face = 0; face < data_.pressureFaceElement.size(); ++face)
        if (deleted[std::size_t(data_.pressureFaceElement[face])])
            data_.pressureFaceCondition[face] = -1;
    state_.pressureFaceCondition.fromHost(data_.pressureFaceCondition);
}

/// Renews the contact surfaces and keeps what is known of the contactors that stay: face, friction,
/// forces of this time. What springs of vanished faces held is booked as lost.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::renewContact(const std::vector<bool>& deleted)
{
    const std::vector<ContactPassSetup> pairs = data_.passes;
    const std::vector<Index> numbers = data_.contactNumber;
    const ForceScale scale = data_.contactScale;
    if (!erosion_->renewContact(data_, deleted)) return;
    for (std::size_t pair = 0; pair < pairs.size(); ++pair)
        renewPair(pair, compared(pairs[pair], data_.passes[pair]), scale);
    renewContactNodes(numbers, scale);
    if (data_.sharesNodes) {
        shareNodes(data_);
        state_.fixed.fromHost(data_.fixed);
        state_.listedNodes = Array<Index, Executor>(data_.listedNodes);
    }
    executor_.forgetSteps();
    for (const PassListState& pass : state_.passLists.toHost()) times_.searches += pass.searches;
    nearBlocks_ = NearBlocks(data_);
    if (searching_ == Searching::lists) state_.setSearches(nearBlocks_);
    searchNow();
}

/// Takes values over: those of old contactor from[i], -1 for none, in planes.
template <class T, class Executor>
static void carry(const Array<T, Executor>& old,
                  Array<T, Executor>& renewed,
                  const std::vector<Index>& from,
                  std::size_t oldCount)
{
    if (oldCount == 0 || old.size() == 0 || renewed.size() == 0 || from.empty()) return;
    const std::vector<T> before = old.toHost();
    std::vector<T> after = renewed.toHost();
    for (std::size_t plane = 0; plane < before.size() / oldCount; ++plane)
        for (std::size_t i = 0; i < from.size(); ++i)
            if (from[i] >= 0)
                after[plane * from.size() + i] = before[plane * oldCount + std::size_t(from[i])];
    renewed.fromHost(after);
}

/// What `old` held in the contactors that `from` does not take over.
template <class Executor>
static double
leftBehind(const Array<double, Executor>& old, const std::vector<Index>& from, std::size_t oldCount)
{
    const std::vector<double> values = old.toHost();
    double sum = 0;
    for (std::size_t k = 0; k < std::min(oldCount, values.size()); ++k) sum += values[k];
    for (const Index k : from)
        if (k >= 0 && !values.empty()) sum -= values[std::size_t(k)];
    return sum;
}

/// Sum of the forces on those old contactors that `from` takes over, in the scale of now: what acts
/// on them until the next step.
template <class Executor>
static std::vector<std::int64_t> stayingForce(const Array<std::int64_t, Executor>& old,
                                              const std::vector<Index>& from,
                                              const ForceScale& before,
                                              const ForceScale& now)
{
    const std::vector<std::int64_t> forces = old.toHost();
    std::vector<std::int64_t> sum(3);
    for (const Index k : from)
        for (std::size_t c = 0; k >= 0 && c < 3; ++c) sum[c] += forces[3 * std::size_t(k) + c];
    for (std::int64_t& force : sum) force = now.force(before.toForce(force));
    return sum;
}

/// What goes on where a contactor and its face stay: place, spring and friction.
template <class Numbers, class Executor>
static void carryTouch(const ContactPassState<Numbers, Executor>& old,
                       ContactPassState<Numbers, Executor>& renewed,
                       const std::vector<Index>& touching,
                       std::size_t oldCount)
{
    const auto take = [&](const auto& from, auto& to) { carry(from, to, touching, oldCount); };
    take(old.xi, renewed.xi);
    take(old.eta, renewed.eta);
    take(old.overlap, renewed.overlap);
    take(old.surfaceForce, renewed.surfaceForce);
    take(old.spring, renewed.spring);
    take(old.heldStiffness, renewed.heldStiffness);
    take(old.friction, renewed.friction);
    take(old.dampingForce, renewed.dampingForce);
    take(old.frictionFace, renewed.frictionFace);
}

/// What has been booked of a contactor that stays, in touch or not.
template <class Numbers, class Executor>
static void carryWorks(const ContactPassState<Numbers, Executor>& old,
                       ContactPassState<Numbers, Executor>& renewed,
                       const std::vector<Index>& contactor,
                       std::size_t oldCount)
{
    const auto take = [&](const auto& from, auto& to) { carry(from, to, contactor, oldCount); };
    take(old.dissipated, renewed.dissipated);
    take(old.damped, renewed.damped);
    take(old.surfaceWork, renewed.surfaceWork);
    take(old.injected, renewed.injected);
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::renewPair(std::size_t number,
                                                  const PairRenewal& from,
                                                  const ForceScale& before)
{
    ContactPassState<Numbers, Executor>& old = state_.passes[number];
    ContactPassState<Numbers, Executor> renewed(data_.passes[number]);
    const bool faces = data_.passes[number].surface < 0;
    const std::size_t oldCount = old.contactor.size(), count = from.contactor.size();
    const auto newFace = [&](Index face) {
        return face >= 0 ? from.face[std::size_t(face)] : face;
    };
    const std::vector<Index> oldFace = old.face.toHost();
    std::vector<Index> face(count, noFace), touching = from.contactor;
    for (std::size_t i = 0; i < count; ++i) {
        if (from.contactor[i] < 0) continue;
        face[i] = newFace(oldFace[std::size_t(from.contactor[i])]);
        if (faces && face[i] < 0) touching[i] = -1; // its face is gone, and force and friction
    }
    renewed.face.fromHost(face);
    carryTouch(old, renewed, touching, oldCount);
    std::vector<Index> frames = renewed.frictionFace.toHost();
    for (Index& frame : frames) frame = newFace(frame);
    renewed.frictionFace.fromHost(frames);
    if (renewed.force.size() > 0) {
        std::vector<std::int64_t> parts =
            stayingForce(old.contactorForce, touching, before, data_.contactScale);
        parts.resize(renewed.force.size());
        renewed.force.fromHost(parts);
    }
    carryWorks(old, renewed, from.contactor, oldCount);
    renewed.counts.fromHost(old.counts.toHost());
    lost_.contact += leftBehind(old.spring, touching, oldCount);
    lost_.friction += leftBehind(old.dissipated, from.contactor, oldCount);
    lost_.contactDamping += leftBehind(old.damped, from.contactor, oldCount);
    lost_.external += leftBehind(old.surfaceWork, from.contactor, oldCount)
                      + leftBehind(old.injected, from.contactor, oldCount);
    old = std::move(renewed);
}

/// The forces of this time, and the bounds of the bodies, stay for the step that follows;
/// `numbers`: contact numbers of all nodes before.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::renewContactNodes(const std::vector<Index>& numbers,
                                                          const ForceScale& before)
{
    using Motion = typename Numbers::Motion;
    const std::size_t count = data_.contactNodes.size();
    const std::vector<std::int64_t> old = state_.contactSum.toHost();
    std::vector<std::int64_t> sum(4 * count);
    std::vector<double> limit(state_.blocks(Index(count)));
    const std::vector<double> limits = state_.contactLimit.toHost();
    const std::vector<double> ofBodies(limits.begin() + contactBlocks(), limits.end());
    const ForceScale& scale = data_.contactScale;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t node = std::size_t(data_.contactNodes[i]);
        const Index number = numbers[node];
        if (number < 0) continue;
        const std::int64_t* from = &old[4 * std::size_t(number)];
        for (std::size_t c = 0; c < 3; ++c) sum[4 * i + c] = scale.force(before.toForce(from[c]));
        const double stiffness = before.toStiffness(from[3]);
        sum[4 * i + 3] = scale.spring(stiffness);
        double& most = limit[i / ContactLimit<Motion>::block];
        if (!(data_.fixed[node] & imposedNode))
            most = std::max(most, stiffness * double(Motion(1 / data_.nodeMass[node])));
    }
    using Indices = Array<Index, Executor>;
    state_.contactNodes = Indices(data_.contactNodes);
    state_.contactNumber = Indices(data_.contactNumber);
    state_.contactSum = Array<std::int64_t, Executor>(sum);
    state_.referenceDisplacement = Array<double, Executor>(displacementValues * limit.size());
    limit.insert(limit.end(), ofBodies.begin(), ofBodies.end());
    state_.contactLimit = Array<double, Executor>(limit);
    state_.referenceOrigin = Array<double, Executor>(3 * state_.blocks(Index(count)));
    state_.referenceOffset = Array<float, Executor>(3 * count);
}

} // namespace fpm
