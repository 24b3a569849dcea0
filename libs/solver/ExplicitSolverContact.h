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
            .target = s.target.data(),
            .targetFaceStart = s.targetFaceStart.data(),
            .targetFaces = s.targetFaces.data(),
            .ownNormal = s.ownNormal.data(),
            .face = s.face.data(),
            .xi = s.xi.data(),
            .eta = s.eta.data(),
            .friction = s.friction.data(),
            .force = s.force.data(),
            .spring = s.spring.data(),
            .dissipated = s.dissipated.data(),
            .released = s.released.data(),
            .position = state_.position.data(),
            .velocity = state_.velocity.data(),
            .nodeStride = std::size_t(data_.nodeCount),
            .sum = state_.contactSum.data(),
            .scale = data_.contactScale,
            .clock = state_.clock.data(),
            .reach = Work(pair.reach),
            .frictionCoefficient = Work(pair.friction),
            .tangentialRatio = Work(pair.tangentialRatio)};
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::contactPasses()
{
    executor_.parallelFor(Index(state_.contactSum.size()),
                          ClearContactSum{state_.contactSum.data(), state_.clock.data()});
    for (std::size_t pair = 0; pair < data_.pairs.size(); ++pair)
        executor_.parallelFor(Index(state_.pairs[pair].contactor.size()),
                              ContactForce<Precision>{pairView(pair)});
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
    double reach = data_.pairs[0].reach;
    for (const PairData& pair : data_.pairs) reach = std::min(reach, pair.reach);
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
    for (std::size_t pair = 0; pair < data_.pairs.size(); ++pair) searchPair(pair);
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
