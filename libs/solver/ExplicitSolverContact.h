#pragma once

// Part of ExplicitSolver.h: the contact solver.

namespace fpm {

template <class Precision, class Executor>
PairView<Precision> ExplicitSolver<Precision, Executor>::pairView(std::size_t number)
{
    PairState<Precision, Executor>& s = state_.pairs[number];
    const PairData& pair = data_.pairs[number];
    return {.contactorCount = Index(s.contactor.size()),
            .faceCount = Index(s.faceThickness.size()),
            .targetCount = Index(s.target.size()),
            .contactor = s.contactor.data(),
            .contactorNumber = s.contactorNumber.data(),
            .ownFaceStart = s.ownFaceStart.data(),
            .ownFaceNode = s.ownFaceNode.data(),
            .faceNode = s.faceNode.data(),
            .faceNumber = s.faceNumber.data(),
            .neighbour = s.neighbour.data(),
            .faceStiffness = s.faceStiffness.data(),
            .faceThickness = s.faceThickness.data(),
            .faceMass = s.faceMass.data(),
            .target = s.target.data(),
            .targetFaceStart = s.targetFaceStart.data(),
            .targetFaces = s.targetFaces.data(),
            .ownNormal = s.ownNormal.data(),
            .face = s.face.data(),
            .xi = s.xi.data(),
            .eta = s.eta.data(),
            .force = s.force.data(),
            .released = s.released.data(),
            .position = state_.position.data(),
            .velocity = state_.velocity.data(),
            .nodeStride = std::size_t(data_.nodeCount),
            .sum = state_.contactSum.data(),
            .scale = data_.contactScale,
            .clock = state_.clock.data(),
            .reach = Work(pair.reach),
            .law = pairLaw(number)};
}

template <class Precision, class Executor>
PairLaw<typename Precision::Work> ExplicitSolver<Precision, Executor>::pairLaw(std::size_t number)
{
    PairState<Precision, Executor>& s = state_.pairs[number];
    const ContactLaw& law = data_.pairs[number].law;
    const double slow = law.friction, fast = law.dynamicFriction;
    return {.count = Index(s.contactor.size()),
            .source = law.penalty == PenaltyRule::series   ? PenaltySource::series
                      : law.penalty == PenaltyRule::target ? PenaltySource::target
                                                           : PenaltySource::lesser,
            .contactorStiffness = s.contactorStiffness.data(),
            .friction = {.staticCoefficient = Work(slow),
                         .dynamicCoefficient = Work(fast < 0 ? slow : fast),
                         .decay = law.frictionDecay,
                         .stiffnessRatio = Work(law.tangentialScale / law.normalScale),
                         .paper = law.paperFriction},
            .stored = s.friction.data(),
            .storedFace = s.frictionFace.data(),
            .spring = s.spring.data(),
            .dissipated = s.dissipated.data(),
            .dampingRatio = Work(law.normalDamping),
            .contactorMass = s.contactorMass.data(),
            .dampingForce = s.dampingForce.data(),
            .damped = s.damped.data(),
            .limitFactor = Work(dampingLimit(law))};
}

template <class Precision, class Executor>
SurfaceForce<Precision> ExplicitSolver<Precision, Executor>::surfaceForce(std::size_t number)
{
    PairState<Precision, Executor>& s = state_.pairs[number];
    const PairData& pair = data_.pairs[number];
    return {.contactorCount = Index(s.contactor.size()),
            .contactor = s.contactor.data(),
            .contactorNumber = s.contactorNumber.data(),
            .force = s.force.data(),
            .work = s.surfaceWork.data(),
            .position = state_.position.data(),
            .velocity = state_.velocity.data(),
            .nodeStride = std::size_t(data_.nodeCount),
            .sum = state_.contactSum.data(),
            .scale = data_.contactScale,
            .clock = state_.clock.data(),
            .amplitudeRows = state_.amplitudeRows.data(),
            .reach = pair.reach,
            .deepest = pair.deepest,
            .shape = data_.surfaces[std::size_t(pair.surface)],
            .law = pairLaw(number)};
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::contactPasses()
{
    executor_.parallelFor(Index(state_.contactSum.size()),
                          ClearContactSum{state_.contactSum.data(), state_.clock.data()});
    for (std::size_t pair = 0; pair < data_.pairs.size(); ++pair) {
        const Index contactors = Index(state_.pairs[pair].contactor.size());
        if (data_.pairs[pair].surface >= 0)
            executor_.parallelFor(contactors, surfaceForce(pair));
        else
            executor_.parallelFor(contactors, ContactForce<Precision>{pairView(pair)});
    }
    using Limit = ContactLimit<typename Precision::Motion>;
    const Limit limit{Index(state_.contactNodes.size()), state_.contactSum.data(),
                      state_.contactInverseMass.data(),  data_.contactScale,
                      state_.contactLimit.data(),        state_.clock.data()};
    executor_.parallelBlocks(contactBlocks(), Limit::scratch(), limit);
}

/// Searches where the lists could not last for `steps` more steps, and returns how many they last
/// for (at least one). They are valid while no two points can have come closer by more than the
/// reach: twice the way made since the search and the way the coming steps can make (method of
/// Verlet).
template <class Precision, class Executor>
std::int64_t ExplicitSolver<Precision, Executor>::searchFor(const StepClock& now,
                                                            std::int64_t steps)
{
    const Index count = Index(state_.contactNodes.size());
    executor_.parallelFor(
        contactBlocks(),
        ContactTravel<Precision>{count, state_.contactNodes.data(), state_.position.data(),
                                 state_.velocity.data(), std::size_t(data_.nodeCount),
                                 state_.searchPosition.data(), state_.contactTravel.data()});
    executor_.synchronize();
    const std::vector<double> travel = state_.contactTravel.toHost();
    double distance = 0, speed = 0;
    for (std::size_t block = 0; block < travel.size() / 2; ++block) {
        distance = std::max(distance, travel[2 * block]);
        speed = std::max(speed, travel[2 * block + 1]);
    }
    double reach = 1e300;
    for (const PairData& pair : data_.pairs)
        if (pair.surface < 0) reach = std::min(reach, pair.reach);
    // Half as fast again leaves room for acceleration within the batch.
    const double way = 1.5 * std::sqrt(speed) * rules_.growth * now.step;
    const auto lasting = [&](double done) {
        const double left = reach / 2 - done;
        return way * double(steps) <= left ? steps : std::int64_t(left / way);
    };
    const std::int64_t lastsFor = lasting(std::sqrt(distance));
    if (lastsFor >= steps && !searchesEveryStep_) return steps;
    timed(times_.search, [&] { searchContact(); });
    return std::max<std::int64_t>(1, lasting(0));
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::searchContact()
{
    ++times_.searches;
    for (std::size_t pair = 0; pair < data_.pairs.size(); ++pair)
        if (data_.pairs[pair].surface < 0) searchPair(pair);
    executor_.parallelFor(
        Index(state_.contactNodes.size()),
        RememberPositions<Precision>{Index(state_.contactNodes.size()), state_.contactNodes.data(),
                                     state_.position.data(), std::size_t(data_.nodeCount),
                                     state_.searchPosition.data()});
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::searchPair(std::size_t number)
{
    PairState<Precision, Executor>& pair = state_.pairs[number];
    const PairView<Precision> view = pairView(number);
    const CellLists cells{pair.head.data(), pair.next.data(), pair.mask,
                          data_.pairs[number].cellSize};
    const Index contactors = Index(pair.contactor.size());
    executor_.parallelFor(Index(pair.head.size()), Fill<Index>{pair.head.data(), Index(-1)});
    executor_.parallelFor(contactors, ContactorNormal<Precision>{view});
    if (data_.pairs[number].search == ContactSearch::faces) {
        executor_.parallelFor(view.faceCount, InsertFace<Precision>{view, cells});
        executor_.parallelFor(contactors, FindFace<Precision>{view, cells});
    } else {
        executor_.parallelFor(view.targetCount, InsertTarget<Precision>{view, cells});
        executor_.parallelFor(contactors, FindClosestParticle<Precision>{view, cells});
    }
}

} // namespace fpm
