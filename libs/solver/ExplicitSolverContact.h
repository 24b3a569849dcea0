#pragma once

// Part of ExplicitSolver.h: the contact solver.

namespace fpm {

template <class Numbers, class Executor>
ContactSums ExplicitSolver<Numbers, Executor>::contactSums()
{
    return {state_.contactSum.data(), data_.contactScale, executor_.alone(), nullptr};
}

template <class Numbers, class Executor>
ContactPassView<Numbers> ExplicitSolver<Numbers, Executor>::passView(std::size_t number)
{
    ContactPassView<Numbers> view = state_.passes[number].view(data_.passes[number]);
    view.position = state_.position.data();
    view.velocity = state_.velocity.data();
    view.nodeStride = std::size_t(data_.nodeCount);
    view.contactNumber = state_.contactNumber.data();
    view.sums = contactSums();
    view.sums.shared = state_.passes[number].shared.data();
    view.clock = state_.clock.data();
    return view;
}

template <class Numbers, class Executor>
SurfaceForce<Numbers> ExplicitSolver<Numbers, Executor>::surfaceForce(std::size_t number)
{
    ContactPassState<Numbers, Executor>& s = state_.passes[number];
    const ContactPassSetup& pair = data_.passes[number];
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

template <class Numbers, class Executor>
template <bool friction>
void ExplicitSolver<Numbers, Executor>::launchFaceContact(std::size_t pass)
{
    executor_.parallelBlocks(NodeBlocks::blocks(Index(state_.passes[pass].contactor.size())), 0,
                             ContactForce<Numbers, friction>{
                                 passView(pass), state_.passes[pass].cells(data_.passes[pass])});
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::launchContact()
{
    executor_.parallelFor(Index(state_.contactSum.size()),
                          ClearContactSum{state_.contactSum.data(), state_.clock.data()});
    for (std::size_t pass = 0; pass < data_.passes.size(); ++pass) {
        const Index contactors = Index(state_.passes[pass].contactor.size());
        if (data_.passes[pass].surface >= 0)
            executor_.parallelFor(contactors, surfaceForce(pass));
        else if (state_.passes[pass].hasFriction(data_.passes[pass]))
            launchFaceContact<true>(pass);
        else
            launchFaceContact<false>(pass);
    }
    using Limit = ContactLimit<typename Numbers::Motion>;
    const Limit limit{
        Index(state_.contactNodes.size()), state_.contactSum.data(), state_.contactNodes.data(),
        state_.inverseMass.data(),         state_.fixed.data(),      data_.contactScale,
        state_.contactLimit.data(),        state_.clock.data()};
    executor_.parallelBlocks(contactBlocks(), Limit::scratch(), limit);
}

/// Looks whether contact lists last for some steps, and searches where they do not. Part of what is
/// recorded.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::checkContactLists(Index steps)
{
    executor_.parallelFor(contactBlocks(),
                          ReferenceDisplacement<Numbers>{
                              Index(state_.contactNodes.size()), state_.contactNodes.data(),
                              state_.position.data(), state_.velocity.data(),
                              std::size_t(data_.nodeCount), state_.referenceOrigin.data(),
                              state_.referenceOffset.data(), state_.referenceDisplacement.data()});
    std::vector<ListCheck> checks;
    for (std::size_t k = 0; k < state_.searches.size(); ++k)
        checks.push_back(state_.searches[k].check(
            state_.referenceDisplacement.data(), state_.passLists.data() + k,
            state_.passes[state_.searches[k].number].counts.data() + countLate, rules_, steps,
            state_.clock.data()));
    checkLists(executor_, checks, state_.passLists.data(), state_.clock.data());
    storeReferencePositions(state_.clock.data());
    for (std::size_t k = 0; k < checks.size(); ++k)
        searchOne(state_.searches[k].number, {checks[k].list, &checks[k].pass->due, nullptr});
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::searchOne(std::size_t pass, const NodeBlocks& blocks)
{
    searchPass(executor_, passView(pass), state_.passes[pass].cells(data_.passes[pass]),
               data_.passes[pass].search == ContactSearch::faces, blocks);
}

/// Searches in all passes; `clock` not null: where a step follows.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::searchAll(const StepClock* clock)
{
    for (std::size_t pass = 0; pass < data_.passes.size(); ++pass)
        if (data_.passes[pass].surface < 0) searchOne(pass, {nullptr, nullptr, clock});
}

/// Times what is searched between steps.
template <class Numbers, class Executor>
template <class Body>
void ExplicitSolver<Numbers, Executor>::searchByHost(const Body& body)
{
    const auto begin = std::chrono::steady_clock::now();
    body();
    executor_.synchronize();
    hostSearch_ += secondsSince(begin);
}

/// All of it, between steps.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::searchNow()
{
    searchByHost([&] {
        if (searching_ == Searching::lists) {
            arrangeContact(true);
            storeReferencePositions(nullptr);
        } else {
            searchAll(nullptr);
            times_.searches += std::int64_t(nearBlocks_.passes().size());
        }
    });
}

/// Searches the passes that wait for it, or all, as a whole and finds out what is near what.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::arrangeContact(bool all)
{
    std::vector<PassListState> passes = state_.passLists.toHost();
    const NearBlocks::Positions positions = contactPositions();
    for (std::size_t k = 0; k < passes.size(); ++k) {
        if (!all && !passes[k].whole) continue;
        SearchState<Executor>& search = state_.searches[k];
        searchOne(search.number, {nullptr, nullptr, nullptr});
        nearBlocks_.arrange(k, positions);
        if (search.arrange(nearBlocks_.passes()[k])) executor_.forgetSteps();
        shareContactNodes(k);
        passes[k] = {.displacementBefore = 0,
                     .displacementSince = 0,
                     .leastBefore = 0,
                     .leastSince = 0,
                     .due = 0,
                     .searches = passes[k].searches + 1,
                     .whole = 0,
                     .fresh = 1,
                     .steps = 0};
    }
    state_.passLists.fromHost(passes);
}

/// Of the contact nodes, in three planes.
template <class Numbers, class Executor>
NearBlocks::Positions ExplicitSolver<Numbers, Executor>::contactPositions() const
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
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::storeReferencePositions(const StepClock* clock)
{
    Index count = Index(state_.contactNodes.size());
    const StoreReferencePositions<Numbers> kernel{count,
                                                  state_.contactNodes.data(),
                                                  state_.position.data(),
                                                  std::size_t(data_.nodeCount),
                                                  state_.referenceOrigin.data(),
                                                  state_.referenceOffset.data(),
                                                  clock};
    if constexpr (Executor::sharesMemory)
        if (clock && !clock->searched) count = 0;
    executor_.parallelFor(count, kernel);
}

/// Tells the threads of the force pass where they have to lock.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::shareContactNodes(std::size_t place)
{
    const std::size_t pass = state_.searches[place].number;
    const ContactPassSetup& pair = data_.passes[pass];
    const Index contactors = Index(pair.contactor.size());
    if (executor_.threads() < 2 || contactors != pair.nodeCount) return;
    std::vector<Index> starts;
    for (int thread = 0; thread < executor_.threads(); ++thread)
        starts.push_back(executor_.firstBlock(thread, NodeBlocks::blocks(contactors)));
    state_.passes[pass].shared =
        Array<std::uint8_t, Executor>(nearBlocks_.sharedBlocks(place, starts));
}

/// Notes what lies inside before the run; it makes full force in passes that do not forgive it.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::measureOverlaps()
{
    for (std::size_t pass = 0; pass < data_.passes.size(); ++pass) {
        if (data_.passes[pass].surface >= 0) continue; // its setup has told
        ContactPassState<Numbers, Executor>& pair = state_.passes[pass];
        const Index count = Index(pair.contactor.size());
        executor_.parallelFor(count, MeasureOverlap<Numbers>{passView(pass),
                                                             pair.cells(data_.passes[pass]),
                                                             pair.overlap.data()});
        executor_.synchronize();
        const std::vector<float> depths = pair.overlap.toHost();
        if (!data_.passes[pass].forgives)
            executor_.parallelFor(count, Fill<float>{pair.overlap.data(), 0.f});
        executor_.parallelFor(passCounts, Fill<std::int64_t>{pair.counts.data(), 0});
        PairOverlap& found = overlaps_[data_.passes[pass].pair];
        for (std::size_t i = 0; i < depths.size(); ++i) {
            // A millionth of a face's width is touching, not overlapping.
            if (!(double(depths[i]) > 1e-6 * data_.passes[pass].meanFaceSize)) continue;
            ++found.count;
            if (double(depths[i]) <= found.deepest) continue;
            found.deepest = double(depths[i]);
            found.node = data_.passes[pass].contactor[i];
        }
    }
}

} // namespace fpm
