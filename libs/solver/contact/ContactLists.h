#pragma once

#include "kernels/particle/StepClock.h"
#include "solver/SetUp.h"
#include "solver/backend/Launches.h"
#include "solver/contact/ContactFields.h"
#include "solver/ledger/LedgerFields.h"
#include "solver/nodes/NodeFields.h"

namespace fpm {

/// Verlet lists of contact: the faces that each contactor may meet, rebuilt when a list may have
/// become invalid (ListCheck), at every step, or at a given interval.
class ContactLists
{
public:
    /// `interval`: steps between two searches, 0: by the list check.
    ContactLists(const SolverSetUp& setUp,
                 ContactFields& fields,
                 const NodeFields& nodes,
                 LedgerFields& ledger,
                 ListLaunches& launches,
                 Backend& backend,
                 std::int64_t interval);

    bool any() const { return when_ != When::never; }
    /// By the list check, which says until when they are valid.
    bool areChecked() const { return when_ == When::whenInvalid; }
    /// Searches in all passes as a whole, between steps.
    void searchNow();
    /// Checks whether lists stay valid for so many steps, where needed; part of what a graph
    /// records.
    void check(Index steps);
    /// Steps until lists have to be checked: 0 at such a step, far off where they never are. Those
    /// steps follow from the run alone, not from where the host looks after it.
    std::int64_t stepsToCheck(const StepClock& now) const;
    /// Where every step searches: now.
    void searchAtStep();
    /// Where an interval is given: searches if it is due. Returns how many of `steps` may follow.
    std::int64_t searchIfDue(std::int64_t done, std::int64_t steps);
    /// Rebuilds the lists that the clock waits for.
    void makeWaiting();
    /// Follows another set-up of the passes; what was counted stays.
    void renew();
    /// Fields for another set-up of the passes, without values.
    void renewFields();
    /// Follows lists that are restored.
    void restored();
    /// Marks the blocks where threads of the force kernels need atomic additions.
    void shareAmongThreads();

    double seconds() const; ///< of checks and searches
    void forgetSeconds() { hostSeconds_ = 0; }
    /// Of single passes, after so many steps.
    std::int64_t searches(std::int64_t steps) const;

private:
    enum class When { never, whenInvalid, interval, everyStep };

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
