#pragma once

#include "kernels/particle/StepClock.h"
#include "solver/SetUp.h"
#include "solver/backend/Launches.h"
#include "solver/contact/ContactFields.h"
#include "solver/ledger/LedgerFields.h"
#include "solver/nodes/NodeFields.h"

namespace fpm {

/// Verlet lists of contact: which face each contactor may touch, made anew when a list may not hold
/// any more (ListCheck), at every step, or every so many steps.
class ContactLists
{
public:
    /// `interval`: steps between two searches, 0: as the lists last.
    ContactLists(const SolverSetUp& setUp,
                 ContactFields& fields,
                 const NodeFields& nodes,
                 LedgerFields& ledger,
                 ListLaunches& launches,
                 Backend& backend,
                 std::int64_t interval);

    bool any() const { return when_ != When::never; }
    /// Searches in all passes as a whole, between steps.
    void searchNow();
    /// Whether lists last for so many steps, where that is asked; part of what a graph records.
    void check(Index steps);
    /// Where every step searches: now.
    void searchAtStep();
    /// Where an interval is given: searches if it is due. Returns how many of `steps` may follow.
    std::int64_t searchIfDue(std::int64_t done, std::int64_t steps);
    /// Makes the lists that the clock waits for.
    void makeWaiting();
    /// Follows another set-up of the passes; what was counted stays.
    void renew();
    /// Tells the threads of the force kernels where they have to lock.
    void shareAmongThreads();

    double seconds() const; ///< of checks and searches
    void forgetSeconds() { hostSeconds_ = 0; }
    /// Of single passes, after so many steps.
    std::int64_t searches(std::int64_t steps) const;

private:
    enum class When { never, asListsLast, interval, everyStep };

    void decideWhen();
    void makeLists(bool all);
    void shareAmongThreads(std::size_t place);
    NearBlocks::Positions positions() const;

    const SolverSetUp& setUp_;
    ContactFields& fields_;
    const NodeFields& nodes_;
    LedgerFields& ledger_;
    ListLaunches& launches_;
    Backend& backend_;
    std::int64_t interval_;
    When when_ = When::never;
    NearBlocks near_;
    double seconds_ = 0;
    double hostSeconds_ = 0; ///< of searches between steps: never sampled
};

} // namespace fpm
