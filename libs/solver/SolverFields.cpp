#include "solver/SolverFields.h"

#include "base/Error.h"
#include "base/Format.h"

#include <cmath>

namespace fpm {

namespace {

/// Throws Error(checkpoint) where a restored clock is none that a run can have.
void requireSound(const StepClock& now)
{
    constexpr std::int64_t most = std::int64_t(1) << 62; // differences of two are numbers too
    const auto isSpan = [](double value) { return std::isfinite(value) && value >= 0; };
    const auto isCount = [](std::int64_t value) { return value >= 0 && value <= most; };
    if (!isSpan(now.time) || !isSpan(now.step) || !isSpan(now.mean) || !std::isfinite(now.lost))
        throw Error(ExitCode::checkpoint, "clock: its time or its step is none");
    if (!isCount(now.steps) || !isCount(now.deletions) || !isCount(now.listsValidUntil)
        || (now.followed != -1 && !isCount(now.followed)))
        throw Error(ExitCode::checkpoint, "clock: a number of steps is none");
}

} // namespace

SolverFields::SolverFields(const SolverSetUp& setUp,
                           const std::vector<Point>& points,
                           const Memory& memory,
                           const NumberTypes& numbers)
    : clock(memory, numbers),
      elements(setUp.elements, std::size_t(setUp.nodes.interiorEnd), memory, numbers),
      nodes(setUp.nodes, points, memory, numbers),
      bodies(setUp.bodies, memory, numbers),
      contact(setUp.contact, memory, numbers)
{
}

std::vector<FieldSet*> SolverFields::sets()
{
    std::vector<FieldSet*> out{&clock, &elements, &nodes, &bodies, &contact, &ledger};
    for (const auto& pass : contact.passes) out.push_back(pass.get());
    for (const auto& lists : contact.passLists) out.push_back(lists.get());
    return out;
}

std::size_t SolverFields::bytes()
{
    std::size_t sum = 0;
    for (const FieldSet* set : sets()) sum += set->bytes();
    return sum;
}

std::size_t SolverFields::stateBytes()
{
    constexpr std::size_t aField = 1000; // its header, name and checksum
    std::size_t sum = 0;
    for (const FieldSet* set : sets())
        for (const FieldBase* field : set->fields())
            if (field->info().role == Role::state) sum += field->bytes() + aField;
    return sum;
}

std::vector<FieldSet::Images> SolverFields::state()
{
    std::vector<FieldSet::Images> out;
    for (const FieldSet* set : sets()) out.push_back(set->images(Role::state));
    return out;
}

void SolverFields::restore(const std::vector<FieldSet::Images>& state)
{
    const std::vector<FieldSet*> now = sets();
    if (state.size() != now.size())
        throw Error(ExitCode::checkpoint,
                    format("{} sets of fields, and the model has {}", state.size(), now.size()));
    for (std::size_t set = 0; set < now.size(); ++set) now[set]->setImages(Role::state, state[set]);
    requireSound(clock.clock.toHost()[0]);
    for (const auto& pass : contact.passes) pass->requireNumbers();
}

void SolverFields::restoreMotion(const std::vector<FieldSet::Images>& state)
{
    FieldSet* const first[] = {&clock, &elements, &nodes, &bodies};
    if (state.size() < std::size(first))
        throw Error(ExitCode::checkpoint, format("{} sets of fields only", state.size()));
    for (std::size_t set = 0; set < std::size(first); ++set)
        first[set]->setImages(Role::state, state[set]);
}

} // namespace fpm
