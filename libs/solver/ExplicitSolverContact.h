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

/// Searches where lists could not last for `steps` more steps, and returns how many they last for
/// (at least one).
template <class Precision, class Executor>
std::int64_t ExplicitSolver<Precision, Executor>::searchFor(const StepClock& now,
                                                            std::int64_t steps)
{
    const auto timedSearch = [&](const auto& search) {
        const auto begin = std::chrono::steady_clock::now();
        search();
        executor_.synchronize();
        times_.search += secondsSince(begin);
    };
    if (searchInterval_ > 0) {
        if (now.steps >= nextSearch_) {
            timedSearch([&] { searchContact(); });
            nextSearch_ = now.steps + searchInterval_;
        }
        return std::min(steps, nextSearch_ - now.steps);
    }
    if (searchesEveryStep_) {
        timedSearch([&] { searchContact(); });
        return 1;
    }
    executor_.parallelFor(
        contactBlocks(),
        ContactTravel<Precision>{Index(state_.contactNodes.size()), state_.contactNodes.data(),
                                 state_.position.data(), state_.velocity.data(),
                                 std::size_t(data_.nodeCount), state_.searchOrigin.data(),
                                 state_.searchOffset.data(), state_.contactTravel.data()});
    executor_.synchronize();
    const SearchSchedule::Plan plan =
        schedule_.plan(state_.contactTravel.toHost(), rules_.growth * now.step, steps);
    if (!plan.due.empty())
        timedSearch([&] {
            for (const SearchSchedule::Due& due : plan.due) searchOne(due);
            rememberPositions(plan.due);
        });
    return plan.steps;
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::searchOne(const SearchSchedule::Due& due)
{
    ++times_.searches;
    PairState<Precision, Executor>& pair = state_.pairs[due.pass];
    if (!due.blocks.empty()) {
        std::vector<Index> list = due.blocks;
        list.resize(pair.searchBlocks.size());
        pair.searchBlocks.fromHost(list);
    }
    searchPass(executor_, pairView(due.pass), pair.cells(data_.pairs[due.pass]),
               data_.pairs[due.pass].search == ContactSearch::faces,
               {pair.searchBlocks.data(), Index(due.blocks.size())});
}

/// Searches in all passes.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::searchContact()
{
    std::vector<SearchSchedule::Due> all;
    for (std::size_t pass = 0; pass < data_.pairs.size(); ++pass)
        if (data_.pairs[pass].surface < 0) all.push_back({pass, {}});
    for (const SearchSchedule::Due& due : all) searchOne(due);
    rememberPositions(all);
}

/// Of the contact nodes, in three planes.
template <class Precision, class Executor>
SearchSchedule::Positions ExplicitSolver<Precision, Executor>::contactPositions() const
{
    const auto all = state_.position.toHost();
    const std::size_t nodes = std::size_t(data_.nodeCount);
    SearchSchedule::Positions out;
    out.reserve(3 * data_.contactNodes.size());
    for (std::size_t c = 0; c < 3; ++c)
        for (const Index node : data_.contactNodes)
            out.push_back(double(all[c * nodes + std::size_t(node)]));
    return out;
}

template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::rememberPositions(
    const std::vector<SearchSchedule::Due>& searched)
{
    if (searchInterval_ > 0 || searchesEveryStep_) return; // nobody asks for ways
    const Index count = Index(state_.contactNodes.size());
    executor_.parallelFor(count, RememberPositions<Precision>{
                                     count, state_.contactNodes.data(), state_.position.data(),
                                     std::size_t(data_.nodeCount), state_.searchOrigin.data(),
                                     state_.searchOffset.data()});
    executor_.synchronize();
    std::vector<double> positions; // fetched where a pass was searched as a whole, which is rare
    for (const SearchSchedule::Due& due : searched) {
        if (!due.blocks.empty()) continue;
        if (positions.empty()) positions = contactPositions();
        schedule_.arrange(due.pass, positions);
        shareContactNodes(due.pass);
    }
}

/// Tells the threads of the force pass where they have to lock.
template <class Precision, class Executor>
void ExplicitSolver<Precision, Executor>::shareContactNodes(std::size_t pass)
{
    const PairData& pair = data_.pairs[pass];
    const Index contactors = Index(pair.contactor.size());
    if (executor_.threads() < 2 || contactors != pair.nodeCount) return;
    std::vector<Index> starts;
    for (int thread = 0; thread < executor_.threads(); ++thread)
        starts.push_back(executor_.firstBlock(thread, NodeBlocks::blocks(contactors)));
    state_.pairs[pass].shared = Array<std::uint8_t, Executor>(schedule_.sharedBlocks(pass, starts));
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
