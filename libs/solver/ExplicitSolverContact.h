#pragma once

// Part of ExplicitSolver.h: the contact solver.

namespace fpm {

template <class Precision, class Executor>
ContactSums ExplicitSolver<Precision, Executor>::contactSums()
{
    return {state_.contactSum.data(), data_.contactScale, executor_.alone(), nullptr};
}

template <class Precision, class Executor>
PairView<Precision> ExplicitSolver<Precision, Executor>::pairView(std::size_t number)
{
    PairView<Precision> view = state_.pairs[number].view(data_.pairs[number]);
    view.position = state_.position.data();
    view.velocity = state_.velocity.data();
    view.nodeStride = std::size_t(data_.nodeCount);
    view.contactNumber = state_.contactNumber.data();
    view.sums = contactSums();
    view.sums.shared = state_.pairs[number].shared.data();
    view.clock = state_.clock.data();
    return view;
}

template <class Precision, class Executor>
SurfaceForce<Precision> ExplicitSolver<Precision, Executor>::surfaceForce(std::size_t number)
{
    PairState<Precision, Executor>& s = state_.pairs[number];
    const PairData& pair = data_.pairs[number];
    ContactSums sums = contactSums();
    sums.alone = executor_.threads() > 0; // each contactor pushes its own node only
    return {.contactorCount = Index(s.contactor.size()),
            .contactor = s.contactor.data(),
            .contactNumber = state_.contactNumber.data(),
            .force = s.surfaceForce.data(),
            .work = s.surfaceWork.data(),
            .position = state_.position.data(),
            .velocity = state_.velocity.data(),
            .nodeStride = std::size_t(data_.nodeCount),
            .sums = sums,
            .clock = state_.clock.data(),
            .amplitudeRows = state_.amplitudeRows.data(),
            .reach = pair.reach,
            .deepest = pair.deepest,
            .shape = data_.surfaces[std::size_t(pair.surface)],
            .law = s.law(pair)};
}

template <class Precision, class Executor>
template <bool friction>
void ExplicitSolver<Precision, Executor>::facesForce(std::size_t pass)
{
    executor_.parallelBlocks(NodeBlocks::blocks(Index(state_.pairs[pass].contactor.size())), 0,
                             ContactForce<Precision, friction>{
                                 pairView(pass), state_.pairs[pass].cells(data_.pairs[pass])});
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::contactPasses()
{
    executor_.parallelFor(Index(state_.contactSum.size()),
                          ClearContactSum{state_.contactSum.data(), state_.clock.data()});
    for (std::size_t pass = 0; pass < data_.pairs.size(); ++pass) {
        const Index contactors = Index(state_.pairs[pass].contactor.size());
        if (data_.pairs[pass].surface >= 0)
            executor_.parallelFor(contactors, surfaceForce(pass));
        else if (state_.pairs[pass].rubs(data_.pairs[pass]))
            facesForce<true>(pass);
        else
            facesForce<false>(pass);
    }
    using Limit = ContactLimit<typename Precision::Motion>;
    const Limit limit{
        Index(state_.contactNodes.size()), state_.contactSum.data(), state_.contactNodes.data(),
        state_.inverseMass.data(),         state_.fixed.data(),      data_.contactScale,
        state_.contactLimit.data(),        state_.clock.data()};
    executor_.parallelBlocks(contactBlocks(), Limit::scratch(), limit);
}

/// Looks whether contact lists last for some steps, and searches where they do not. Part of what is
/// recorded.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::lookAtContact(Index steps)
{
    executor_.parallelFor(
        contactBlocks(),
        ContactTravel<Precision>{Index(state_.contactNodes.size()), state_.contactNodes.data(),
                                 state_.position.data(), state_.velocity.data(),
                                 std::size_t(data_.nodeCount), state_.searchOrigin.data(),
                                 state_.searchOffset.data(), state_.contactTravel.data()});
    std::vector<SearchPlan> plans;
    for (std::size_t k = 0; k < state_.searches.size(); ++k)
        plans.push_back(state_.searches[k].plan(
            state_.contactTravel.data(), state_.passSearches.data() + k,
            state_.pairs[state_.searches[k].number].counts.data() + countLate, rules_, steps,
            state_.clock.data()));
    planSearches(executor_, plans, state_.passSearches.data(), state_.clock.data());
    rememberPositions(state_.clock.data());
    for (std::size_t k = 0; k < plans.size(); ++k)
        searchOne(state_.searches[k].number, {plans[k].list, &plans[k].pass->due, nullptr});
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::searchOne(std::size_t pass, const NodeBlocks& blocks)
{
    searchPass(executor_, pairView(pass), state_.pairs[pass].cells(data_.pairs[pass]),
               data_.pairs[pass].search == ContactSearch::faces, blocks);
}

/// Searches in all passes; `clock` not null: where a step follows.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::searchAll(const StepClock* clock)
{
    for (std::size_t pass = 0; pass < data_.pairs.size(); ++pass)
        if (data_.pairs[pass].surface < 0) searchOne(pass, {nullptr, nullptr, clock});
}

/// Times what is searched between steps.
template <class Precision, class Executor>
template <class Body>
void ExplicitSolver<Precision, Executor>::searchByHost(const Body& body)
{
    const auto begin = std::chrono::steady_clock::now();
    body();
    executor_.synchronize();
    hostSearch_ += secondsSince(begin);
}

/// All of it, between steps.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::searchNow()
{
    searchByHost([&] {
        if (searching_ == Searching::lists) {
            arrangeContact(true);
            rememberPositions(nullptr);
        } else {
            searchAll(nullptr);
            times_.searches += std::int64_t(nearBlocks_.passes().size());
        }
    });
}

/// Searches the passes that wait for it, or all, as a whole and finds out what is near what.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::arrangeContact(bool all)
{
    std::vector<PassSearch> passes = state_.passSearches.toHost();
    const NearBlocks::Positions positions = contactPositions();
    for (std::size_t k = 0; k < passes.size(); ++k) {
        if (!all && !passes[k].whole) continue;
        SearchState<Executor>& search = state_.searches[k];
        searchOne(search.number, {nullptr, nullptr, nullptr});
        nearBlocks_.arrange(k, positions);
        if (search.arrange(nearBlocks_.passes()[k])) executor_.forgetSteps();
        shareContactNodes(k);
        passes[k] = {.way = 0,
                     .come = 0,
                     .sure = 0,
                     .sureCome = 0,
                     .due = 0,
                     .searches = passes[k].searches + 1,
                     .whole = 0,
                     .fresh = 1,
                     .steps = 0};
    }
    state_.passSearches.fromHost(passes);
}

/// Of the contact nodes, in three planes.
template <class Precision, class Executor>
NearBlocks::Positions ExplicitSolver<Precision, Executor>::contactPositions() const
{
    const auto all = state_.position.toHost();
    const std::size_t nodes = std::size_t(data_.nodeCount);
    NearBlocks::Positions out;
    out.reserve(3 * data_.contactNodes.size());
    for (std::size_t c = 0; c < 3; ++c)
        for (const Index node : data_.contactNodes)
            out.push_back(double(all[c * nodes + std::size_t(node)]));
    return out;
}

/// `clock` not null: where the last look found a search due.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::rememberPositions(const StepClock* clock)
{
    Index count = Index(state_.contactNodes.size());
    const RememberPositions<Precision> kernel{count,
                                              state_.contactNodes.data(),
                                              state_.position.data(),
                                              std::size_t(data_.nodeCount),
                                              state_.searchOrigin.data(),
                                              state_.searchOffset.data(),
                                              clock};
    if constexpr (Executor::sharesMemory)
        if (clock && !clock->searched) count = 0;
    executor_.parallelFor(count, kernel);
}

/// Tells the threads of the force pass where they have to lock.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::shareContactNodes(std::size_t place)
{
    const std::size_t pass = state_.searches[place].number;
    const PairData& pair = data_.pairs[pass];
    const Index contactors = Index(pair.contactor.size());
    if (executor_.threads() < 2 || contactors != pair.nodeCount) return;
    std::vector<Index> starts;
    for (int thread = 0; thread < executor_.threads(); ++thread)
        starts.push_back(executor_.firstBlock(thread, NodeBlocks::blocks(contactors)));
    state_.pairs[pass].shared =
        Array<std::uint8_t, Executor>(nearBlocks_.sharedBlocks(place, starts));
}

/// Notes what lies inside before the run; it makes full force in passes that do not forgive it.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::measureOverlaps()
{
    for (std::size_t pass = 0; pass < data_.pairs.size(); ++pass) {
        if (data_.pairs[pass].surface >= 0) continue; // its setup has told
        PairState<Precision, Executor>& pair = state_.pairs[pass];
        const Index count = Index(pair.contactor.size());
        executor_.parallelFor(count, MeasureOverlap<Precision>{pairView(pass),
                                                               pair.cells(data_.pairs[pass]),
                                                               pair.overlap.data()});
        executor_.synchronize();
        const std::vector<float> depths = pair.overlap.toHost();
        if (!data_.pairs[pass].forgives)
            executor_.parallelFor(count, Fill<float>{pair.overlap.data(), 0.f});
        executor_.parallelFor(pairCounts, Fill<std::int64_t>{pair.counts.data(), 0});
        PairOverlap& found = overlaps_[data_.pairs[pass].pair];
        for (std::size_t i = 0; i < depths.size(); ++i) {
            // A millionth of a face's width is touching, not overlapping.
            if (!(double(depths[i]) > 1e-6 * data_.pairs[pass].meanFaceSize)) continue;
            ++found.count;
            if (double(depths[i]) <= found.deepest) continue;
            found.deepest = double(depths[i]);
            found.node = data_.pairs[pass].contactor[i];
        }
    }
}

} // namespace fpm
