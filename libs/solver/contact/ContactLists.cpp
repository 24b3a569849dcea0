#include "solver/contact/ContactLists.h"

#include "base/Error.h"
#include "kernels/contact/broad/Search.h"

#include <algorithm>
#include <chrono>

namespace fpm {

namespace {

/// Adds the seconds that `body` takes on the host, all kernels included.
template <class Body>
void timedByHost(Backend& backend, double& seconds, const Body& body)
{
    const auto begin = std::chrono::steady_clock::now();
    body();
    backend.synchronize();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

ContactLists::ContactLists(const SolverSetUp& setUp,
                           ContactFields& fields,
                           const NodeFields& nodes,
                           LedgerFields& ledger,
                           ListLaunches& launches,
                           Backend& backend,
                           std::int64_t interval)
    : setUp_(setUp),
      fields_(fields),
      nodes_(nodes),
      ledger_(ledger),
      launches_(launches),
      backend_(backend),
      interval_(interval),
      near_(setUp)
{
    decideWhen();
    if (when_ == When::whenInvalid) fields_.renewLists(near_);
}

void ContactLists::decideWhen()
{
    for (const NearBlocks::Pass& pass : near_.passes())
        if (setUp_.contact.passes[pass.number].search == ContactSearch::closestParticle)
            when_ = When::everyStep;
        else if (when_ == When::never)
            when_ = When::whenInvalid;
    if (when_ != When::never && interval_ > 0) when_ = When::interval;
}

void ContactLists::searchNow()
{
    timedByHost(backend_, hostSeconds_, [this] {
        if (when_ == When::whenInvalid) {
            makeLists(true);
            launches_.storeReferencePositions();
            return;
        }
        for (const NearBlocks::Pass& pass : near_.passes()) launches_.search(pass.number, false);
        ledger_.searches += std::int64_t(near_.passes().size());
    });
}

void ContactLists::check(Index steps)
{
    if (when_ == When::whenInvalid)
        backend_.timed(seconds_, [this, steps] { launches_.check(steps); });
}

std::int64_t ContactLists::stepsToCheck(const StepClock& now) const
{
    constexpr std::int64_t never = std::int64_t(1) << 62;
    if (!areChecked()) return never;
    return now.step > 0 ? std::max<std::int64_t>(0, now.listsValidUntil - now.steps) : 0;
}

void ContactLists::searchAtStep()
{
    if (when_ != When::everyStep) return;
    backend_.timed(seconds_, [this] {
        for (const NearBlocks::Pass& pass : near_.passes()) launches_.search(pass.number, true);
    });
}

std::int64_t ContactLists::searchIfDue(std::int64_t done, std::int64_t steps)
{
    if (when_ != When::interval) return steps;
    if (done >= ledger_.nextSearch()) {
        searchNow();
        ledger_.nextSearch = done + interval_;
    }
    return std::min(steps, ledger_.nextSearch() - done);
}

void ContactLists::makeWaiting()
{
    timedByHost(backend_, hostSeconds_, [this] { makeLists(false); });
}

/// Searches the passes that wait for it, or all, as a whole and finds out what is near what.
void ContactLists::makeLists(bool all)
{
    std::vector<PassListState> lists = fields_.lists.toHost();
    const NearBlocks::Positions now = positions();
    for (std::size_t place = 0; place < lists.size(); ++place) {
        if (!all && !lists[place].rebuild) continue;
        ListFields& of = *fields_.passLists[place];
        launches_.search(of.number, false);
        near_.rebuild(place, now);
        if (of.rebuild(near_.passes()[place])) backend_.forgetSteps();
        shareAmongThreads(place);
        const std::int64_t searches = lists[place].searches + 1;
        lists[place] = {};
        lists[place].searches = searches;
        lists[place].rebuilt = 1;
    }
    fields_.lists.fromHost(lists);
}

/// Of the contact nodes, in three planes.
NearBlocks::Positions ContactLists::positions() const
{
    const std::vector<double> all = nodes_.position.toDoubles();
    const std::size_t nodes = all.size() / 3;
    NearBlocks::Positions out;
    out.reserve(3 * setUp_.contact.nodes.size());
    for (std::size_t c = 0; c < 3; ++c)
        for (const Index node : setUp_.contact.nodes)
            out.push_back(all[c * nodes + std::size_t(node)]);
    return out;
}

void ContactLists::shareAmongThreads()
{
    for (std::size_t place = 0; place < fields_.passLists.size(); ++place) shareAmongThreads(place);
}

void ContactLists::shareAmongThreads(std::size_t place)
{
    const std::size_t pass = fields_.passLists[place]->number;
    const ContactPassSetup& setUp = setUp_.contact.passes[pass];
    const Index contactors = Index(setUp.contactor.size());
    if (backend_.threads() < 2 || contactors != setUp.nodeCount) return;
    std::vector<Index> starts;
    for (int thread = 0; thread < backend_.threads(); ++thread)
        starts.push_back(backend_.firstBlock(thread, NodeBlocks::blocks(contactors)));
    fields_.passes[pass]->shared.assign(near_.sharedBlocks(place, starts));
}

void ContactLists::renew()
{
    for (const PassListState& list : fields_.lists.toHost()) ledger_.searches += list.searches;
    renewFields();
    searchNow();
}

void ContactLists::renewFields()
{
    near_ = NearBlocks(setUp_);
    if (when_ == When::whenInvalid) fields_.renewLists(near_);
}

void ContactLists::restored()
{
    constexpr std::int64_t most = std::int64_t(1) << 53; // of searches: their sum is a number
    for (const PassListState& list : fields_.lists.toHost())
        if (list.searches < 0 || list.searches > most)
            throw Error(ExitCode::checkpoint, "contact lists: a number of searches is none");
    if (ledger_.searches() < 0 || ledger_.searches() > most || ledger_.nextSearch() < 0)
        throw Error(ExitCode::checkpoint, "ledger: a number of searches is none");
    for (std::size_t place = 0; place < fields_.passLists.size(); ++place) {
        const ListFields& of = *fields_.passLists[place];
        near_.restore(place, of.nearStart.toHost(), of.near.toHost());
    }
    shareAmongThreads();
}

double ContactLists::seconds() const
{
    return seconds_ * backend_.timedScale() + hostSeconds_;
}

std::int64_t ContactLists::searches(std::int64_t steps) const
{
    std::int64_t sum = ledger_.searches();
    for (const PassListState& list : fields_.lists.toHost()) sum += list.searches;
    if (when_ == When::everyStep) sum += steps * std::int64_t(near_.passes().size());
    return sum;
}

} // namespace fpm
